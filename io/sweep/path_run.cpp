// SPDX-License-Identifier: BSD-3-Clause
#include "io/sweep/path_run.hpp"

#include "framework/problem/statistics.hpp"
#include "io/report/provenance.hpp"
#include "io/report/run_result.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "solvers/factorisation/kept_analyses.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::io {

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// The first error of a scene that cannot be read.
std::string first_fault(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics.sorted())
    if (d.severity == Severity::error) return diagnostics.where(d.place) + ": " + d.message;
  return "a plugin is missing";
}

/// A point that has been solved, for those that are continued from it.
struct Solved {
  std::unique_ptr<Case> the_case;
  std::vector<double> x;  // over all degrees of freedom [m]
  const StudyPoint* point = nullptr;
};

/// Whether what is known of one scene can be used in the other: the same unknowns, numbered alike.
bool have_one_topology(Case& a, Case& b) {
  return a.assembler().numbering().dofs() == b.assembler().numbering().dofs() &&
         a.assembler().pattern() == b.assembler().pattern();
}

/// How far from the last point the next one is, over the way from the one before that; nothing if they do not
/// lie on a line.
std::optional<double> way_on(const StudyPoint& before, const StudyPoint& last, const StudyPoint& next) {
  std::optional<double> ratio;
  for (std::size_t v = 0; v < next.values.size(); ++v) {
    const auto &a = before.values[v], &b = last.values[v], &c = next.values[v];
    if (a.text == b.text && b.text == c.text) continue;
    if (ratio || !a.number || !b.number || !c.number || *a.number == *b.number) return std::nullopt;
    ratio = (*c.number - *b.number) / (*b.number - *a.number);
  }
  return ratio;
}

/// One item while it is solved.
class PathRun {
 public:
  PathRun(const Study& study, const StudyItem& item, const PathContext& context)
      : study_(study), item_(item), context_(context), make_(keep_analyses(make_factorisation)) {}

  std::optional<ItemRecord> run() {
    ItemRecord record;
    record.hash = item_.hash, record.program = program_version();
    record.cost.host = host_name(), record.cost.started = utc_now();
    const double wall = wall_seconds(), cpu = cpu_seconds();
    for (const StudyPoint& point : item_.points) {
      record.points.push_back(solve(point));
      if (is_interrupted()) return std::nullopt;
    }
    record.cost.wall_seconds = wall_seconds() - wall, record.cost.cpu_seconds = cpu_seconds() - cpu;
    return record;
  }

 private:
  bool is_interrupted() const { return context_.interrupt && context_.interrupt->load(); }

  PointRecord solve(const StudyPoint& point) {
    auto the_case =
        std::make_unique<Case>(source_of_point(study_, item_, point, context_), *context_.registry, make_);
    PointRecord record;
    if (the_case->open() != Case::State::ready) {
      record.status = "wrong input", record.reason = first_fault(the_case->diagnostics());
      return record;
    }
    require_same_files(*the_case);
    if (const auto why_not = the_case->why_unfit()) throw StudyError(*why_not);
    const Solution solution = find(*the_case, point, record);
    fill(record, *the_case, solution);
    keep(std::move(the_case), solution, point);
    return record;
  }

  void require_same_files(Case& the_case) const {
    for (const SourceFile& file : the_case.loaded().files)
      if (std::none_of(study_.files.begin(), study_.files.end(),
                       [&](const auto& known) { return known.second == file.hash; }))
        throw StudyError(file.path + " has changed since the study was planned; plan it again");
  }

  Solution find(Case& the_case, const StudyPoint& point, PointRecord& record) {
    const Watch watch{context_.interrupt, {}, nullptr};
    std::optional<Solution> continued;
    if (!trail_.empty() && have_one_topology(*trail_.back().the_case, the_case))
      continued = the_case.continue_from(the_case.assembler().displacements_to(predict(point)), watch);
    record.start = "continued";
    if (continued && continued->status == SolveStatus::converged) return std::move(*continued);
    record.start = "anew";
    Solution found = the_case.solve(watch);
    if (continued) found.statistics.add(continued->statistics), found.work += continued->work;
    return found;
  }

  /// Where the last points lead: on the line through two of them, or to the last.
  std::vector<double> predict(const StudyPoint& point) const {
    const Solved& last = trail_.back();
    std::vector<double> x = last.x;
    if (trail_.size() < 2) return x;
    const Solved& before = trail_[trail_.size() - 2];
    const auto ratio = way_on(*before.point, *last.point, point);
    if (!ratio || before.x.size() != x.size()) return x;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += *ratio * (x[i] - before.x[i]);
    return x;
  }

  void fill(PointRecord& record, Case& the_case, const Solution& s) const {
    record.status = name_of(s.status), record.reason = s.reason;
    record.iterations = s.statistics.iterations, record.factorisations = s.statistics.factorisations;
    record.work = s.work;
    record.figures = figures_of(the_case, s);
    if (study_.figures.empty()) return;
    std::erase_if(record.figures, [&](const StudyFigure& figure) {
      return std::find(study_.figures.begin(), study_.figures.end(), figure.name) == study_.figures.end();
    });
  }

  /// Points go on only from equilibria that are stable.
  void keep(std::unique_ptr<Case> the_case, const Solution& s, const StudyPoint& point) {
    if (s.status != SolveStatus::converged) return trail_.clear();
    trail_.push_back({std::move(the_case), s.x, &point});
    if (trail_.size() > 2) trail_.erase(trail_.begin());
  }

  const Study& study_;
  const StudyItem& item_;
  const PathContext& context_;
  MakeFactorisation make_;
  std::vector<Solved> trail_;  // the last two points, the newest behind
};

}  // namespace

std::optional<ItemRecord> run_path(const Study& study, const StudyItem& item, const PathContext& context) {
  return PathRun(study, item, context).run();
}

CaseSource source_of_point(const Study& study, const StudyItem& item, const StudyPoint& point,
                           const PathContext& context) {
  CaseSource source{context.folder / study.scene, study.set, context.threads};
  source.overrides.insert(source.overrides.end(), item.set.begin(), item.set.end());
  source.overrides.insert(source.overrides.end(), point.set.begin(), point.set.end());
  return source;
}

std::vector<StudyFigure> figures_of(Case& the_case, const Solution& solution) {
  RunResult result;
  result.solution = solution;
  collect(the_case.loaded(), the_case.assembler(), result);
  std::vector<StudyFigure> figures;
  for (const NamedScalar& s : result.scalars) figures.push_back({"results/" + s.name, s.unit, s.value});
  for (const NamedScalar& s : result.gear) figures.push_back({"gear/" + s.name, s.unit, s.value});
  for (const HoldForce& hold : result.hold_forces)
    for (std::size_t axis = 0; axis < 3; ++axis)
      figures.push_back({"held/" + hold.name + "/" + "xyz"[axis], "N", hold.force[axis]});
  return figures;
}

}  // namespace netloft::io
