// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

/// The rounding unit of positions [m]. Smaller errors count as zero.
double floor_of(const Comparison& c) { return std::numeric_limits<double>::epsilon() * c.size; }

/// Adds a point. If several tolerances lead to the same error, only the point with the least work is kept.
void add(std::vector<formats::PlotSeries::Point>& points, formats::PlotSeries::Point p) {
  if (!points.empty() && points.back().x == p.x)
    points.back().y = std::min(points.back().y, p.y);
  else
    points.push_back(p);
}

std::string with_times_signs(std::string text) {
  for (auto at = text.find(" x "); at != std::string::npos; at = text.find(" x ")) text.replace(at, 3, " × ");
  return text;
}

/// The text " (lost at 1e-01, 1e-02)": the tolerances at which a motion did not end. They have no points in
/// the plot.
std::string lost_at(const MethodResult& m) {
  std::string text;
  for (const Trial& t : m.trials)
    if (!t.converged()) text += fmt::format("{}{:.0e}", text.empty() ? " (lost at " : ", ", t.tolerance);
  if (!text.empty()) text += ")";
  return m.reference ? text : text + " (no reference)";
}

formats::PlotSeries series_of(const Comparison& c, const MethodResult& m) {
  formats::PlotSeries series{c.is_of_motions ? m.method.name() : m.method.specification, {}};
  for (const Trial& t : m.trials)
    if (t.converged() && std::isfinite(t.error))
      add(series.points, {std::max(t.error, floor_of(c)), t.cpu_seconds});
  if (c.is_of_motions)
    series.name += lost_at(m);
  else if (m.other)
    series.name += " (other equilibrium)";
  else if (series.points.empty())
    series.name += m.reference ? " (not converged)" : " (no reference)";
  return series;
}

}  // namespace

formats::LinePlot comparison_plot(const Comparison& c) {
  formats::LinePlot plot{with_times_signs(c.scene + ", " + c.mesh),
                         c.is_of_motions ? "error of the path: largest node distance [m]"
                                         : "solver error: largest node distance [m]",
                         "CPU time [s]",
                         {},
                         {}};
  for (const auto& m : c.methods)
    if (!m.is_absent) plot.series.push_back(series_of(c, m));
  if (c.discretisation)
    for (const auto& level : c.discretisation->levels)
      if (std::isfinite(level.error))
        plot.marks.push_back({level.error, std::to_string(level.cells) + " cells"});
  if (!plot.marks.empty()) plot.x_label = "solver error (dashed: discretisation error) [m]";
  return plot;
}

}  // namespace netloft::studies
