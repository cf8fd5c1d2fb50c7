// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/figure_indices.hpp"

#include "io/scenes/water/dice.hpp"
#include "io/studies/sweep/site.hpp"
#include "io/studies/sweep/study_statistics.hpp"
#include "solvers/fitting/kriging/hull.hpp"
#include "solvers/fitting/kriging/kriging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace netloft::studies {

namespace {

// Limit of points: each point costs one correlation per sample. With more points, most of the error comes
// from the distance between the values of the study.
constexpr std::size_t kMostTablePoints = 500;
constexpr std::size_t kMostGroups = 10;  // limit of groups of samples, each of which is left out in turn
constexpr std::size_t kHullPoints = 128;
constexpr std::size_t kLeastLevels = 3;

using Numbers = std::vector<double>;
using Group = std::vector<std::size_t>;  // indices of points

/// A column of the table that is a coordinate of points, scaled to [0, 1] between its least and largest
/// value.
struct Coordinate {
  std::size_t column = 0;
  Numbers levels;              // values in ascending order
  std::optional<double> held;  // the held value; empty: the coordinate varies
  bool is_sampled = false;

  double low() const { return levels.front(); }
  double extent() const { return levels.back() > levels.front() ? levels.back() - levels.front() : 1; }
  /// The scaled value below which a fraction p of the column's distribution lies.
  double at(double p) const {
    if (held) return (*held - low()) / extent();
    return is_sampled ? (quantile_of(levels, p) - low()) / extent() : p;
  }
};

/// The known values of one figure.
struct KnownFigures {
  std::vector<Numbers> points;
  Numbers values;
  std::vector<std::size_t> samples;

  KnownFigures without(const Group& group) const {
    KnownFigures rest;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::binary_search(group.begin(), group.end(), i)) {
        rest.points.push_back(points[i]);
        rest.values.push_back(values[i]);
        rest.samples.push_back(samples[i]);
      }
    return rest;
  }
};

/// Finds the indices of one figure. The member functions are the steps, in the order of execution.
class IndexEstimator {
 public:
  IndexEstimator(const KnownFigures& known, const std::vector<Coordinate>& coordinates)
      : known_(known),
        coordinates_(coordinates),
        kriging_(known.points, known.values),
        scales_(kriging_.scales()) {}

  void run(FigureIndices& figure) {
    SobolIndices found = indices_of(kriging_, {});
    const SobolIndices at_first = indices_of(kriging_, kOneReplicate);
    std::vector<SobolIndex> lack(found.variables.size());  // errors of the response: the two parts of (1)
    add_samples(at_first, lack);
    add_levels(at_first, lack);
    for (std::size_t i = 0; i < lack.size(); ++i) {
      auto& [first, total] = found.variables[i];
      first.error = std::hypot(first.error, lack[i].first.error);
      total.error = std::hypot(total.error, lack[i].total.error);
    }
    figure.mean = found.mean;
    figure.deviation = found.deviation;
    figure.variables = found.variables;
    if (residuals_ && found.deviation > 0)
      figure.off = std::sqrt(squares_ / static_cast<double>(residuals_)) / found.deviation;
  }

 private:
  static constexpr SobolSample kOneReplicate{SobolSample{}.points, 1};

  SobolIndices indices_of(const Kriging& kriging, const SobolSample& sample) const {
    const auto varied = static_cast<std::size_t>(
        std::count_if(coordinates_.begin(), coordinates_.end(), [](const auto& c) { return !c.held; }));
    const auto f = [&](const Numbers& unit) {
      Numbers point;
      std::size_t next = 0;
      for (const Coordinate& c : coordinates_) point.push_back(c.at(c.held ? 0 : unit[next++]));
      return kriging.value_at(point);
    };
    return sobol_indices(f, varied, sample);
  }

  /// Adds to the errors `lack` the first term of (1) in figure_indices.hpp, from groups of samples.
  void add_samples(const SobolIndices& all, std::vector<SobolIndex>& lack) {
    const std::set<std::size_t> samples(known_.samples.begin(), known_.samples.end());
    if (std::none_of(coordinates_.begin(), coordinates_.end(), [](const auto& c) { return c.is_sampled; }))
      return;
    const std::size_t k = std::min(kMostGroups, samples.size());
    std::vector<SobolIndex> squares(lack.size());
    for (std::size_t g = 0; g < k; ++g) {
      const auto is_left_out = [&](std::size_t i) {
        return static_cast<std::size_t>(std::distance(samples.begin(), samples.find(known_.samples[i]))) %
                   k ==
               g;
      };
      const auto differences = without(group_of(is_left_out), all);
      for (std::size_t i = 0; i < squares.size(); ++i) {
        squares[i].first.error += differences[i].first.error * differences[i].first.error;
        squares[i].total.error += differences[i].total.error * differences[i].total.error;
      }
    }
    const double spread = static_cast<double>(k - 1) / static_cast<double>(k);
    for (std::size_t i = 0; i < lack.size(); ++i) {
      lack[i].first.error += 2 * std::sqrt(spread * squares[i].first.error);
      lack[i].total.error += 2 * std::sqrt(spread * squares[i].total.error);
    }
  }

  /// Adds to the errors `lack` the second term of (1) in figure_indices.hpp, from values of listed variables.
  void add_levels(const SobolIndices& all, std::vector<SobolIndex>& lack) {
    for (std::size_t c = 0; c < coordinates_.size(); ++c) {
      if (coordinates_[c].is_sampled) continue;
      std::set<double> levels;
      for (const Numbers& point : known_.points) levels.insert(point[c]);
      std::vector<SobolIndex> worst(lack.size());
      for (const double level : levels) {
        if (level == *levels.begin() || level == *levels.rbegin()) continue;
        const auto differences =
            without(group_of([&](std::size_t i) { return known_.points[i][c] == level; }), all);
        for (std::size_t i = 0; i < worst.size(); ++i) {
          worst[i].first.error = std::max(worst[i].first.error, differences[i].first.error);
          worst[i].total.error = std::max(worst[i].total.error, differences[i].total.error);
        }
      }
      for (std::size_t i = 0; i < lack.size(); ++i) {
        lack[i].first.error += worst[i].first.error;
        lack[i].total.error += worst[i].total.error;
      }
    }
  }

  template <class Condition>
  Group group_of(const Condition& is_left_out) const {
    Group group;
    for (std::size_t i = 0; i < known_.points.size(); ++i)
      if (is_left_out(i)) group.push_back(i);
    return group;
  }

  /// The differences between the indices from all points and those from the points outside a group; zeros if
  /// too few points are outside.
  std::vector<SobolIndex> without(const Group& group, const SobolIndices& all) {
    std::vector<SobolIndex> differences(all.variables.size());
    if (!scales_ || group.empty() || 2 * group.size() > known_.points.size()) return differences;
    for (const double residual : kriging_.residuals_without(group)) {
      squares_ += residual * residual;
      ++residuals_;
    }
    const KnownFigures rest = known_.without(group);
    const SobolIndices found = indices_of(Kriging(rest.points, rest.values, &*scales_), kOneReplicate);
    for (std::size_t i = 0; i < differences.size(); ++i) {
      differences[i].first.error = std::abs(found.variables[i].first.value - all.variables[i].first.value);
      differences[i].total.error = std::abs(found.variables[i].total.value - all.variables[i].total.value);
    }
    return differences;
  }

  const KnownFigures& known_;
  const std::vector<Coordinate>& coordinates_;
  Kriging kriging_;
  std::optional<KrigingScales> scales_;
  double squares_ = 0;  // sum of squares of residuals at left-out points
  std::size_t residuals_ = 0;
};

/// Chooses coordinates and rows of the table for the indices. The member functions are the steps, in the
/// order of execution.
class Analysis {
 public:
  Analysis(const StudyTable& table, const Site& site, formats::Diagnostics& diagnostics)
      : table_(table), site_(site), diagnostics_(diagnostics) {
    for (std::size_t v = 0; v < table.columns.size(); ++v) add_column(v);
    if (result_.variables.empty() && !diagnostics.errors())
      diagnostics.error({}, "no variable varies, but indices compare the effects of several variables",
                        "hold fewer variables fixed with --at");
    if (!diagnostics.errors()) refuse_lists();
  }

  StudyIndices run(const std::vector<std::size_t>& figures) {
    choose_rows();
    for (const std::size_t f : figures) result_.figures.push_back(analyse(f));
    return std::move(result_);
  }

 private:
  const std::string& name(std::size_t v) const { return table_.columns[v].variable.name; }

  void add_column(std::size_t v) {
    const StudyColumn& column = table_.columns[v];
    if (site_[v]) result_.held.emplace_back(name(v), site_[v]->text);
    if (!column.is_number) return require_held(v);
    const Numbers levels = levels_of(table_, v);
    if (levels.size() < 2 || is_held_at_level(v, levels)) return;
    if (!column.is_sampled && levels.size() < kLeastLevels)
      return diagnostics_.error(
          {}, name(v) + " has two values, which do not tell what lies between them",
          fmt::format("give the study three or more values, or hold the variable fixed: --at {}=\"{}\"",
                      name(v), table_.rows.front().values[v].text));
    Coordinate c{v, levels, {}, column.is_sampled};
    if (site_[v]) c.held = site_[v]->number;
    if (!site_[v])
      result_.variables.push_back(
          {name(v), column.variable.unit, levels.front(), levels.back(), c.is_sampled});
    coordinates_.push_back(std::move(c));
  }

  void require_held(std::size_t v) {
    std::set<std::string> values;
    for (const StudyRow& row : table_.rows) values.insert(row.values[v].text);
    if (!site_[v] && values.size() > 1)
      diagnostics_.error({}, name(v) + " has values that are no numbers, so that it must be held fixed",
                         fmt::format("--at {}=\"{}\"", name(v), table_.rows.front().values[v].text));
  }

  bool is_held_at_level(std::size_t v, const Numbers& levels) const {
    return site_[v] && !table_.columns[v].is_sampled &&
           std::any_of(levels.begin(), levels.end(),
                       [&](double level) { return is_same_number(level, *site_[v]->number); });
  }

  /// Reports an error if listed values change together, row by row, so that no variable varies by itself.
  void refuse_lists() {
    std::set<Numbers> together;
    std::size_t product = 1;
    for (const StudyRow& row : table_.rows)
      if (counts(row)) together.insert(listed_of(row));
    for (const Coordinate& c : coordinates_)
      if (!c.is_sampled) product *= c.levels.size();
    if (!together.empty() && together.size() < product)
      diagnostics_.error(
          {}, "listed values go together one by one, so that none of the variables varies by itself",
          "combine = \"grid\", or a range to sample from");
  }

  Numbers listed_of(const StudyRow& row) const {
    Numbers point;
    for (const Coordinate& c : coordinates_)
      if (!c.is_sampled) point.push_back(*row.values[c.column].number);
    return point;
  }

  bool is_coordinate(std::size_t v) const {
    return std::any_of(coordinates_.begin(), coordinates_.end(),
                       [&](const auto& c) { return c.column == v; });
  }

  /// Whether the row has the values at which the request holds variables.
  bool counts(const StudyRow& row) const {
    for (std::size_t v = 0; v < site_.size(); ++v) {
      if (!site_[v] || is_coordinate(v)) continue;
      const bool same = row.values[v].number && site_[v]->number
                            ? is_same_number(*row.values[v].number, *site_[v]->number)
                            : row.values[v].text == site_[v]->text;
      if (!same) return false;
    }
    return true;
  }

  void choose_rows() {
    for (const StudyRow& row : table_.rows)
      if (counts(row))
        row.record.status == "converged" ? rows_.push_back(&row) : static_cast<void>(++result_.left_out);
    if (rows_.empty())
      throw StudyError("none of the points on which the indices would rest has a stable equilibrium");
  }

  FigureIndices analyse(std::size_t f) {
    FigureIndices figure{table_.figures[f].name, table_.figures[f].unit, 0, 0, 0, 0, {}, {}};
    const KnownFigures known = known_of(f);
    figure.points = known.points.size();
    figure.why_not = why_not(known);
    if (!figure.why_not.empty()) return figure;
    result_.beyond = std::max(result_.beyond, part_beyond(known));
    IndexEstimator(known, coordinates_).run(figure);
    return figure;
  }

  /// The points that have the figure; if there are more than kMostTablePoints, only that number of points,
  /// chosen at random.
  KnownFigures known_of(std::size_t f) const {
    std::map<Numbers, std::pair<double, std::size_t>> all;
    for (const StudyRow* row : rows_)
      if (std::isfinite(row->figures[f])) all.try_emplace(point_of(*row), row->figures[f], row->sample);
    std::vector<std::pair<Numbers, std::pair<double, std::size_t>>> chosen(all.begin(), all.end());
    scenes::Dice dice("sensitivity", 1);
    for (std::size_t i = 0; chosen.size() > kMostTablePoints && i < kMostTablePoints; ++i)
      std::swap(chosen[i], chosen[i + dice.index(chosen.size() - i)]);
    chosen.resize(std::min(chosen.size(), kMostTablePoints));
    KnownFigures known;
    for (auto& [point, value] : chosen) {
      known.points.push_back(point);
      known.values.push_back(value.first);
      known.samples.push_back(value.second);
    }
    return known;
  }

  Numbers point_of(const StudyRow& row) const {
    Numbers point;
    for (const Coordinate& c : coordinates_)
      point.push_back((*row.values[c.column].number - c.low()) / c.extent());
    return point;
  }

  std::string why_not(const KnownFigures& known) const {
    if (known.points.empty()) return "no point with these values has this figure";
    if (std::all_of(known.values.begin(), known.values.end(),
                    [&](double y) { return y == known.values.front(); }))
      return "it does not vary";
    const auto sampled = static_cast<std::size_t>(
        std::count_if(coordinates_.begin(), coordinates_.end(), [](const auto& c) { return c.is_sampled; }));
    const std::size_t samples = std::set<std::size_t>(known.samples.begin(), known.samples.end()).size();
    if (sampled && samples < sampled + 3)
      return fmt::format("{} samples are too few for {} sampled variable{}", samples, sampled,
                         sampled > 1 ? "s" : "");
    for (std::size_t c = 0; c < coordinates_.size(); ++c) {
      std::set<double> levels;
      for (const Numbers& point : known.points) levels.insert(point[c]);
      if (levels.size() < kLeastLevels)
        return fmt::format("this figure is known at only {} of {}",
                           levels.size() == 1 ? "one value" : "two values", name(coordinates_[c].column));
    }
    return {};
  }

  double part_beyond(const KnownFigures& known) const {
    std::size_t beyond = 0;
    for (const Numbers& unit : unit_points(Sampling::sobol, kHullPoints, coordinates_.size(), 1)) {
      Numbers point;
      for (std::size_t c = 0; c < unit.size(); ++c) point.push_back(coordinates_[c].at(unit[c]));
      beyond += !lies_in_hull(known.points, point);
    }
    return static_cast<double>(beyond) / static_cast<double>(kHullPoints);
  }

  const StudyTable& table_;
  const Site& site_;
  formats::Diagnostics& diagnostics_;
  std::vector<Coordinate> coordinates_;
  std::vector<const StudyRow*> rows_;
  StudyIndices result_;
};

}  // namespace

std::optional<StudyIndices> study_indices(const StudyTable& table, const IndicesRequest& request,
                                          formats::Diagnostics& diagnostics) {
  if (table.figures.empty())
    throw StudyError("no point of this study has been computed; `netloft study run` computes them");
  const Site site = read_site(table, request.at, diagnostics, SiteNeeds::nothing);
  const std::vector<std::size_t> figures = choose_figures(table, request.figures, diagnostics);
  if (diagnostics.errors()) return std::nullopt;
  Analysis analysis(table, site, diagnostics);
  if (diagnostics.errors()) return std::nullopt;
  return analysis.run(figures);
}

}  // namespace netloft::studies
