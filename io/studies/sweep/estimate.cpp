// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/estimate.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/studies/sweep/site.hpp"
#include "io/studies/sweep/study_plots.hpp"
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

// Limit of points: only the nearest points are used. Kriging of n points takes n³/3 operations, a tenth of a
// second for each figure with 600 points, and distant points add little information.
constexpr std::size_t kMostFittedPoints = 600;
constexpr double kSolveError = 1e-9;  // relative error of solves, the last term of (1) in estimate.hpp

using Numbers = std::vector<double>;

/// The values of one figure in the selected rows of the table, by point; coordinates are scaled to [0, 1].
struct Known {
  std::vector<Numbers> points;
  std::vector<Numbers> samples;  // for each point: one number, or one for every sample
};

double squared_distance(const Numbers& a, const Numbers& b) {
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += (a[j] - b[j]) * (a[j] - b[j]);
  return sum;
}

/// Estimates one number at a place, with the error (1) of estimate.hpp.
class NumberEstimate {
 public:
  /// The first `listed` coordinates belong to variables with listed values; the others are sampled.
  NumberEstimate(const std::vector<Numbers>& points, const Numbers& values, const Numbers& place,
                 std::size_t listed, const KrigingScales* scales = nullptr)
      : points_(points), place_(place), listed_(listed), kriging_(points, values, scales) {}

  WithError run() const {
    const KrigingValue found = kriging_.at(place_);
    double left_out = 0;
    for (std::size_t j = 0; j < listed_; ++j) {
      double worst = 0;
      for (const double level : inner_levels(j))
        worst = std::max(worst, error_without(points_with(j, j + 1, {level})));
      left_out += worst;
    }
    left_out += error_without_samples();
    return {found.value,
            std::max({2 * found.deviation, left_out, kSolveError * std::abs(found.value)})};  // (1)
  }

 private:
  using Group = std::vector<std::size_t>;  // indices of points

  double error_without_samples() const {
    const std::size_t sampled = place_.size() - listed_;
    double worst = 0;
    for (const Numbers& sample : nearest_samples(sampled ? sampled + 1 : 0))
      worst = std::max(worst, error_without(points_with(listed_, place_.size(), sample)));
    return worst;
  }

  /// The two values of a variable that are nearest to the place, without its first and last value.
  Numbers inner_levels(std::size_t j) const {
    std::set<double> levels;
    for (const Numbers& point : points_) levels.insert(point[j]);
    Numbers inner(levels.begin(), levels.end());
    if (inner.size() < 3) return {};
    inner = Numbers(inner.begin() + 1, inner.end() - 1);
    std::stable_sort(inner.begin(), inner.end(),
                     [&](double a, double b) { return std::abs(a - place_[j]) < std::abs(b - place_[j]); });
    inner.resize(std::min<std::size_t>(inner.size(), 2));
    return inner;
  }

  std::vector<Numbers> nearest_samples(std::size_t most) const {
    std::set<Numbers> all;
    for (const Numbers& point : points_) all.insert(coordinates(point, listed_, point.size()));
    std::vector<Numbers> samples(all.begin(), all.end());
    const Numbers here = coordinates(place_, listed_, place_.size());
    std::stable_sort(samples.begin(), samples.end(), [&](const Numbers& a, const Numbers& b) {
      return squared_distance(a, here) < squared_distance(b, here);
    });
    samples.resize(std::min(samples.size(), most));
    return samples;
  }

  static Numbers coordinates(const Numbers& point, std::size_t from, std::size_t to) {
    return {point.begin() + static_cast<std::ptrdiff_t>(from),
            point.begin() + static_cast<std::ptrdiff_t>(to)};
  }

  Group points_with(std::size_t from, std::size_t to, const Numbers& wanted) const {
    Group group;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (coordinates(points_[i], from, to) == wanted) group.push_back(i);
    return group;
  }

  /// The largest error of the estimates at points of a group that are made from all points outside the group.
  /// Only the points of the group nearest to the place count, as many as a cell between listed values has
  /// corners.
  double error_without(const Group& group) const {
    const Numbers residuals = kriging_.residuals_without(group);
    std::vector<std::size_t> order(group.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return squared_distance(points_[group[a]], place_) < squared_distance(points_[group[b]], place_);
    });
    const std::size_t corners = std::size_t{1} << std::min<std::size_t>(listed_, 10);
    order.resize(std::min(order.size(), corners));
    double worst = 0;
    for (const std::size_t k : order) worst = std::max(worst, std::abs(residuals[k]));
    return worst;
  }

  const std::vector<Numbers>& points_;
  const Numbers& place_;
  std::size_t listed_;
  Kriging kriging_;
};

/// Chooses rows of the table and estimates figures from them. The member functions are the steps, in the
/// order of execution.
class Estimator {
 public:
  Estimator(const StudyTable& table, const Site& site) : table_(table), site_(site) {
    find_free();
    choose_rows();
  }

  StudyEstimate run(const std::vector<std::size_t>& figures) {
    for (const std::size_t f : figures) result_.figures.push_back(estimate_figure(f));
    for (std::size_t v = 0; v < site_.size(); ++v)
      if (site_[v]) result_.at.emplace_back(table_.columns[v].variable.name, site_[v]->text);
    say_events();
    return std::move(result_);
  }

 private:
  /// Finds the free variables, along which figures are interpolated: first the listed variables whose
  /// requested value lies between listed values, then the sampled variables.
  void find_free() {
    for (const bool sampled : {false, true})
      for (std::size_t v = 0; v < site_.size(); ++v)
        if (table_.columns[v].is_sampled == sampled && site_[v] && table_.columns[v].is_number &&
            (sampled || !is_level(v))) {
          free_.push_back(v);
          listed_ += !sampled;
        }
    for (const std::size_t v : free_) {
      const Numbers levels = levels_of(table_, v);
      lows_.push_back(levels.front());
      extents_.push_back(levels.back() > levels.front() ? levels.back() - levels.front() : 1);
      place_.push_back((*site_[v]->number - lows_.back()) / extents_.back());
      const Interval around = neighbours_of(levels, *site_[v]->number);
      neighbours_.push_back(
          {(around.low - lows_.back()) / extents_.back(), (around.high - lows_.back()) / extents_.back()});
    }
    is_over_samples_ = std::any_of(table_.columns.begin(), table_.columns.end(),
                                   [](const StudyColumn& c) { return c.is_sampled; }) &&
                       listed_ == free_.size();
  }

  bool is_level(std::size_t v) const {
    const Numbers levels = levels_of(table_, v);
    return std::any_of(levels.begin(), levels.end(),
                       [&](double level) { return is_same_number(level, *site_[v]->number); });
  }

  void choose_rows() {
    std::set<std::size_t> samples;
    for (const StudyRow& row : table_.rows) {
      if (!counts(row)) continue;
      if (row.record.status == "converged") {
        rows_.push_back(&row);
        samples.insert(row.sample);
      } else
        result_.left_out.push_back({row.item, row.point, row.record.status, row.record.reason});
    }
    if (is_over_samples_) result_.samples = samples.size();
    if (!rows_.empty()) return;
    if (result_.left_out.empty()) throw StudyError("the study has no point with this combination of values");
    const LeftOutRow& first = result_.left_out.front();
    throw StudyError(
        fmt::format("none of the points on which the estimate would rest has a stable equilibrium; item {}, "
                    "point {}: {}{}",
                    first.item, first.point, first.status, first.reason.empty() ? "" : ": " + first.reason));
  }

  /// Whether the row has the requested values of all variables that are not free.
  bool counts(const StudyRow& row) const {
    for (std::size_t v = 0; v < site_.size(); ++v) {
      if (!site_[v] || std::find(free_.begin(), free_.end(), v) != free_.end()) continue;
      const bool same = row.values[v].number && site_[v]->number
                            ? is_same_number(*row.values[v].number, *site_[v]->number)
                            : row.values[v].text == site_[v]->text;
      if (!same) return false;
    }
    return true;
  }

  Numbers coordinates_of(const StudyRow& row) const {
    Numbers point;
    for (std::size_t k = 0; k < free_.size(); ++k)
      point.push_back((*row.values[free_[k]].number - lows_[k]) / extents_[k]);
    return point;
  }

  Known known_of(std::size_t f, const std::vector<const StudyRow*>& rows) const {
    std::map<Numbers, Numbers> samples;
    for (const StudyRow* row : rows)
      if (std::isfinite(row->figures[f])) samples[coordinates_of(*row)].push_back(row->figures[f]);
    std::vector<std::pair<Numbers, Numbers>> all(samples.begin(), samples.end());
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
      return squared_distance(a.first, place_) < squared_distance(b.first, place_);
    });
    all.resize(std::min(all.size(), kMostFittedPoints));
    Known known;
    for (auto& [point, sample] : all) {
      known.points.push_back(std::move(point));
      known.samples.push_back(std::move(sample));
    }
    return known;
  }

  EstimatedFigure estimate_figure(std::size_t f) {
    EstimatedFigure figure{table_.figures[f].name, table_.figures[f].unit, {}, {}, {}, 0, 0, {}};
    const Known known = known_of(f, rows_);
    figure.points = known.points.size();
    figure.why_not = why_not(known);
    if (!figure.why_not.empty()) return figure;
    if (!lies_in_hull(known.points, place_)) result_.is_extrapolated = true;
    if (is_over_samples_)
      estimate_over_samples(f, known, figure);
    else
      figure.value = estimate_number(known, nullptr);
    return figure;
  }

  void estimate_over_samples(std::size_t f, const Known& known, EstimatedFigure& figure) const {
    const auto scales = scales_of(known);
    Numbers found, low, high;
    for (const auto& [sample, rows] : rows_by_sample()) {
      const Known of_sample = known_of(f, rows);
      if (!why_too_few(of_sample).empty()) continue;
      const WithError number = estimate_number(of_sample, scales ? &*scales : nullptr);
      found.push_back(number.value);
      low.push_back(number.value - number.error);
      high.push_back(number.value + number.error);
    }
    figure.samples = found.size();
    if (found.empty()) {
      figure.why_not = "no sample has this figure at three values of every variable";
      return;
    }
    const auto at = [&](double p) {
      const double y = quantile_of(found, p);
      return WithError{y, std::max(quantile_of(high, p) - y, y - quantile_of(low, p))};  // (2)
    };
    figure.low = at(kBandLow);
    figure.value = at(0.5);
    figure.high = at(kBandHigh);
  }

  std::map<std::size_t, std::vector<const StudyRow*>> rows_by_sample() const {
    std::map<std::size_t, std::vector<const StudyRow*>> rows;
    for (const StudyRow* row : rows_) rows[row->sample].push_back(row);
    return rows;
  }

  /// The correlation lengths that kriging finds for the medians over the samples.
  std::optional<KrigingScales> scales_of(const Known& known) const {
    if (free_.empty()) return std::nullopt;
    return Kriging(known.points, medians_of(known)).scales();
  }

  static Numbers medians_of(const Known& known) {
    Numbers medians;
    for (const Numbers& sample : known.samples) medians.push_back(quantile_of(sample, 0.5));
    return medians;
  }

  std::string why_not(const Known& known) const {
    const std::size_t sampled = free_.size() - listed_;
    if (!known.points.empty() && sampled && count_samples() < sampled + 3)
      return fmt::format("{} samples are too few for {} sampled variable{}", count_samples(), sampled,
                         sampled > 1 ? "s" : "");
    return why_too_few(known);
  }

  std::string why_too_few(const Known& known) const {
    if (known.points.empty()) return "no point with these values has this figure";
    for (std::size_t k = 0; k < free_.size(); ++k) {
      std::set<double> levels;
      for (const Numbers& point : known.points) levels.insert(point[k]);
      if (levels.size() < 3)
        return fmt::format("this figure is known at only {} of {}",
                           levels.size() == 1 ? "one value" : "two values",
                           table_.columns[free_[k]].variable.name);
    }
    return {};
  }

  std::size_t count_samples() const {
    std::set<std::size_t> samples;
    for (const StudyRow* row : rows_) samples.insert(row->sample);
    return samples.size();
  }

  WithError estimate_number(const Known& known, const KrigingScales* scales) const {
    const Numbers values = medians_of(known);
    if (free_.empty()) return {values.front(), kSolveError * std::abs(values.front())};
    return NumberEstimate(known.points, values, place_, listed_, scales).run();
  }

  /// Reports folds and jumps at the points around the place, that is, within the neighbouring values in each
  /// variable.
  void say_events() {
    std::set<std::string> said;
    for (const StudyRow* row : rows_)
      if (is_around(*row))
        for (const std::string& event : row->record.events)
          if (said.insert(event).second)
            result_.events.push_back(fmt::format("item {}, point {}: {}", row->item, row->point, event));
  }

  bool is_around(const StudyRow& row) const {
    const Numbers point = coordinates_of(row);
    for (std::size_t k = 0; k < listed_; ++k)
      if (const auto [below, above] = neighbours_[k]; point[k] < below || point[k] > above) return false;
    return true;
  }

  /// The nearest values of a listed variable below and above the place, which must be within its range.
  static Interval neighbours_of(const Numbers& levels, double place) {
    Interval found{levels.front(), levels.back()};
    for (const double level : levels)
      if (level <= place)
        found.low = level;
      else
        return {found.low, level};
    return found;
  }

  const StudyTable& table_;
  const Site& site_;
  std::vector<std::size_t> free_;  // columns of the variables along which figures are interpolated
  std::size_t listed_ = 0;         // number of listed variables, which come first in free_
  // Least values, ranges and requested values of the variables in free_; place_ is scaled to [0, 1].
  Numbers lows_, extents_, place_;
  std::vector<Interval> neighbours_;  // values around the place, of listed variables, scaled to [0, 1]
  bool is_over_samples_ = false;
  std::vector<const StudyRow*> rows_;
  StudyEstimate result_;
};

}  // namespace

std::vector<std::size_t> choose_figures(const StudyTable& table, const std::vector<std::string>& wanted,
                                        formats::Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const StudyFigure& figure : table.figures) names.push_back(figure.name);
  std::vector<std::size_t> chosen;
  for (const std::string& one : wanted) {
    const auto at = std::find(names.begin(), names.end(), one);
    const auto near = nearest(one, names);
    if (at == names.end())
      diagnostics.error(
          {}, "--figure: the study has no figure \"" + one + "\"",
          near ? "did you mean \"" + *near + "\"?" : "`netloft study collect` makes a table of all");
    else
      chosen.push_back(static_cast<std::size_t>(at - names.begin()));
  }
  for (std::size_t f = 0; f < names.size() && wanted.empty(); ++f)
    if (names[f].find("_by_part/") == std::string::npos) chosen.push_back(f);
  return chosen;
}

std::optional<StudyEstimate> estimate(const StudyTable& table, const EstimateRequest& request,
                                      formats::Diagnostics& diagnostics) {
  if (table.figures.empty())
    throw StudyError("no point of this study has been computed; `netloft study run` computes them");
  const Site site = read_site(table, request.at, diagnostics);
  const std::vector<std::size_t> figures = choose_figures(table, request.figures, diagnostics);
  if (diagnostics.errors()) return std::nullopt;
  return Estimator(table, site).run(figures);
}

}  // namespace netloft::studies
