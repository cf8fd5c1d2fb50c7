// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/scope.hpp"

#include "io/formats/svg/plot.hpp"
#include "io/formats/units/degrees.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/studies/sweep/branch.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "solvers/factorisation/kept_analyses.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace netloft::studies {

namespace {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

Variable variable_in_metres(const char* name, const char* key) {
  Variable variable;
  variable.name = name;
  variable.unit = "m";
  variable.keys.emplace_back().path = key;
  return variable;
}

/// Names of the figures of the boards. They contain the name of the pair of boards in the plan.
struct ScopeFigureNames {
  std::string heel, spread;
};

ScopeFigureNames names_for(const scenes::LoadedScene& loaded) {
  if (!loaded.gear || !(loaded.gear->ship_speed > 0) || !loaded.scene.bed.is_there)
    throw std::invalid_argument(
        "a scope table needs a gear behind a ship over a bed: [ship] in the net plan, [bed] in the scene");
  if (loaded.gear->pairs.size() != 1)
    throw std::invalid_argument("a scope table needs a gear with one pair of boards");
  const std::string& pair = loaded.gear->pairs.begin()->first;
  return {"gear/pairs/" + pair + "/heel", "gear/pairs/" + pair + "/spread"};
}

double value_of(const std::vector<StudyFigure>& figures, const std::string& name) {
  const auto at = std::ranges::find(figures, name, &StudyFigure::name);
  return at == figures.end() ? kNoFigure : at->value;
}

ScopePoint without_numbers(double warp, std::string why_not) {
  return {warp, kNoFigure, kNoFigure, kNoFigure, kNoFigure, kNoFigure, std::move(why_not)};
}

ScopePoint point_of(runs::PreparedScene& scene, const Solution& solution, double warp) {
  if (solution.status != SolveStatus::converged)
    return without_numbers(warp, std::string(name_of(solution.status)) + ": " + solution.reason);
  const auto figures = figures_of(scene, solution);
  const ScopeFigureNames names = names_for(scene.loaded());
  return {warp,
          formats::kDegreesPerRadian * value_of(figures, names.heel),
          value_of(figures, names.spread),
          value_of(figures, "gear/mouth/upper_wing_spread"),
          value_of(figures, "gear/mouth/headline_height"),
          value_of(figures, "gear/towing/pull")};
}

bool is_within(const ScopeRequest& request, const ScopePoint& p) {
  return request.heel.contains(p.heel) && (!request.spread || request.spread->contains(p.spread));
}

/// For a value that changes from a, which is within the band, to b: the fraction of this change at which the
/// value leaves the band; 1 if it stays within.
double leaves_at(const Interval& band, double a, double b) {
  if (band.contains(b)) return 1;
  return !std::isfinite(b) ? 0 : ((b > a ? band.high : band.low) - a) / (b - a);
}

/// The length of warp at which the boards leave their bands, between a point within the bands and a
/// neighbouring point outside.
double end_between(const ScopeRequest& request, const ScopePoint& in, const ScopePoint& out) {
  double t = leaves_at(request.heel, in.heel, out.heel);
  if (request.spread) t = std::min(t, leaves_at(*request.spread, in.spread, out.spread));
  return in.warp + t * (out.warp - in.warp);
}

/// Solves all depths. At every depth, the length increases from the shortest one. The equilibrium at the
/// shortest length is followed from depth to depth, so that a fold at a larger length does not affect the
/// next depth.
class ScopeRun {
 public:
  ScopeRun(const runs::CaseSource& source, Registry& registry, const ScopeRequest& request,
           const runs::Watch& watch, const OnScopePoint& on_point)
      : source_(source),
        registry_(registry),
        request_(request),
        watch_(watch),
        on_point_(on_point),
        make_(keep_analyses(make_factorisation)),
        shortest_(
            variables_, [this](const auto& values) { return open(values); }, watch_) {}

  std::vector<ScopeRow> run() {
    std::vector<ScopeRow> rows;
    for (std::size_t d = 0; d < request_.depths.size() && !is_interrupted(); ++d) {
      ScopeRow& row = rows.emplace_back();
      row.depth = request_.depths[d];
      try {
        solve(row);
      } catch (const formats::Interrupted&) {  // interrupted while a scene was read; solved points are kept
      }
      if (row.points.size() == request_.scopes.size()) find_lengths(request_, row);
    }
    if (!was_read_ && !rows.empty() && !rows.front().points.empty())
      throw std::invalid_argument("no length of warp can be read: " + rows.front().points.front().why_not);
    return rows;
  }

 private:
  bool is_interrupted() const { return watch_.interrupt && watch_.interrupt->load(); }

  std::shared_ptr<runs::PreparedScene> make_case(const std::vector<VariableValue>& values) const {
    runs::CaseSource source = source_;
    for (std::size_t v = 0; v < values.size(); ++v)
      formats::append(source.changes, variables_[v].changes(values[v]));
    return std::make_shared<runs::PreparedScene>(std::move(source), registry_, make_);
  }

  /// Opens the scene with these values; nullptr if it cannot be read.
  std::shared_ptr<runs::PreparedScene> open(const std::vector<VariableValue>& values) const {
    auto scene = make_case(values);
    return scene->prepare() == runs::PreparedScene::State::ready ? scene : nullptr;
  }

  void solve(ScopeRow& row) {
    solve(row, request_.scopes[0], shortest_);
    Branch longer = shortest_;
    for (std::size_t k = 1; k < request_.scopes.size() && !is_interrupted(); ++k)
      solve(row, request_.scopes[k], longer);
  }

  void solve(ScopeRow& row, double scope, Branch& branch) {
    const double warp = scope * row.depth;
    if (ScopePoint point =
            solve(row, warp, {variables_[0].value_of(row.depth), variables_[1].value_of(warp)}, branch);
        !is_interrupted()) {
      row.points.push_back(std::move(point));
      ++solved_;
    }
    if (on_point_ && !row.points.empty()) on_point_(solved_, row, row.points.back());
  }

  ScopePoint solve(ScopeRow& row, double warp, const std::vector<VariableValue>& values, Branch& branch) {
    const auto scene = make_case(values);
    if (scene->prepare() != runs::PreparedScene::State::ready)
      return without_numbers(warp, first_fault(scene->diagnostics()));
    was_read_ = true;
    Reached reached = branch.reach(scene, values);
    std::ranges::move(reached.events, std::back_inserter(row.events));
    return point_of(*scene, reached.solution, warp);
  }

  const runs::CaseSource& source_;
  Registry& registry_;
  const ScopeRequest& request_;
  const runs::Watch& watch_;
  const OnScopePoint& on_point_;
  bool was_read_ = false;
  std::size_t solved_ = 0;
  MakeFactorisation make_;
  std::vector<Variable> variables_ = {variable_in_metres("depth", "bed.depth"),
                                      variable_in_metres("warp", "ship.warp.length")};
  Branch shortest_;  // the equilibrium at the shortest length, followed from depth to depth
};

}  // namespace

void find_lengths(const ScopeRequest& request, ScopeRow& row) {
  const auto& p = row.points;
  const double middle = 0.5 * (request.heel.low + request.heel.high);
  row.chosen.reset();
  row.warp.reset();
  for (std::size_t k = 0; k < p.size(); ++k)
    if (is_within(request, p[k]) &&
        (!row.chosen || std::abs(p[k].heel - middle) < std::abs(p[*row.chosen].heel - middle)))
      row.chosen = k;
  if (!row.chosen) return;
  std::size_t first = *row.chosen, last = first;
  while (first > 0 && is_within(request, p[first - 1])) --first;
  while (last + 1 < p.size() && is_within(request, p[last + 1])) ++last;
  row.warp = {first > 0 ? end_between(request, p[first], p[first - 1]) : p[first].warp,
              last + 1 < p.size() ? end_between(request, p[last], p[last + 1]) : p[last].warp};
}

std::vector<ScopeRow> find_scope(const runs::CaseSource& source, Registry& registry,
                                 const ScopeRequest& request, const runs::Watch& watch,
                                 const OnScopePoint& on_point) {
  runs::PreparedScene first(source, registry);
  if (first.prepare() == runs::PreparedScene::State::ready) names_for(first.loaded());
  return ScopeRun(source, registry, request, watch, on_point).run();
}

std::string draw_scope(const std::string& scene, const std::vector<ScopeRow>& rows, bool as_page) {
  formats::LinePlot plot{"Warp for " + scene, "depth [m]", "warp [m]", {}};
  plot.x_scale = plot.y_scale = formats::AxisScale::linear;
  formats::PlotSeries lengths{"boards as wanted", {}};
  for (const ScopeRow& row : rows)
    if (row.chosen) {
      lengths.points.push_back({row.depth, row.points[*row.chosen].warp});
      lengths.band.push_back({row.depth, row.warp->low, row.warp->high});
    }
  plot.series.push_back(std::move(lengths));
  return as_page ? formats::draw_html(plot) : formats::draw_svg(plot);
}

}  // namespace netloft::studies
