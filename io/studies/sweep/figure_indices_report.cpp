// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/figure_indices.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;
using Out = std::back_insert_iterator<std::string>;

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : name + " [" + unit + "]";
}

void head_text(const std::string& study, const StudyIndices& s, Out out) {
  fmt::format_to(out, "{}: Sobol indices over", study);
  for (std::size_t v = 0; v < s.variables.size(); ++v) {
    const auto& [name, unit, from, to, is_sampled] = s.variables[v];
    fmt::format_to(out, "{} {} {:.6g} to {:.6g}{}{}", v ? "," : "", name, from, to, unit.empty() ? "" : " ",
                   unit);
  }
  for (const auto& [name, value] : s.held) fmt::format_to(out, ", at {} {}", name, value);
  fmt::format_to(out, "\n");
}

std::string index_text(const WithError& index) {
  return fmt::format("{:>7.3f} ± {:.3f}", index.value, index.error);
}

void figure_text(const StudyIndices& s, const FigureIndices& figure, Out out) {
  fmt::format_to(out, "{}", with_unit(figure.name, figure.unit));
  if (!figure.why_not.empty()) {
    fmt::format_to(out, ": {}\n", figure.why_not);
    return;
  }
  fmt::format_to(out,
                 ": mean {:.6g}, deviation {:.3g}; predictions of points that are left out are off by {:.2g} "
                 "deviations\n",
                 figure.mean, figure.deviation, figure.off);
  fmt::format_to(out, "  {:<24} {:>15} {:>17}\n", "", "first order", "total");
  for (std::size_t v = 0; v < s.variables.size(); ++v)
    fmt::format_to(out, "  {:<24} {} {}\n", s.variables[v].name, index_text(figure.variables[v].first),
                   "  " + index_text(figure.variables[v].total));
}

Json index_json(const WithError& index) { return {{"value", index.value}, {"error", index.error}}; }

Json figure_json(const StudyIndices& s, const FigureIndices& figure) {
  if (!figure.why_not.empty()) return {{"unit", figure.unit}, {"why_not", figure.why_not}};
  Json variables = Json::object();
  for (std::size_t v = 0; v < s.variables.size(); ++v)
    variables[s.variables[v].name] = {{"first", index_json(figure.variables[v].first)},
                                      {"total", index_json(figure.variables[v].total)}};
  return {{"unit", figure.unit}, {"mean", figure.mean},     {"deviation", figure.deviation},
          {"off", figure.off},   {"points", figure.points}, {"variables", std::move(variables)}};
}

}  // namespace

std::string indices_text(const std::string& study, const StudyIndices& s) {
  std::string text;
  const Out out(text);
  head_text(study, s, out);
  for (const FigureIndices& figure : s.figures) figure_text(s, figure, out);
  if (s.beyond > 0)
    fmt::format_to(out,
                   "{:.0f} % of the sample lies beyond the points, where the response is an extrapolation\n",
                   100 * s.beyond);
  if (s.left_out) fmt::format_to(out, "left out: {} without a stable equilibrium\n", s.left_out);
  text.pop_back();
  return text;
}

std::string indices_json(const std::string& study, const StudyIndices& s) {
  Json held = Json::object(), variables = Json::object(), figures = Json::object();
  for (const auto& [name, value] : s.held) held[name] = value;
  for (const auto& [name, unit, from, to, is_sampled] : s.variables)
    variables[name] = {{"unit", unit}, {"from", from}, {"to", to}, {"sampled", is_sampled}};
  for (const FigureIndices& figure : s.figures) figures[figure.name] = figure_json(s, figure);
  const Json json = {{"study", study},
                     {"at", std::move(held)},
                     {"variables", std::move(variables)},
                     {"figures", std::move(figures)},
                     {"beyond", s.beyond},
                     {"left_out", s.left_out}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

formats::BarChart indices_bars(const StudyIndices& s) {
  formats::BarChart chart{"part of the variance", {"first order", "total"}, {}};
  for (const FigureIndices& figure : s.figures) {
    if (!figure.why_not.empty()) continue;
    formats::BarChart::Group& group = chart.groups.emplace_back(formats::BarChart::Group{figure.name, {}});
    for (std::size_t v = 0; v < s.variables.size(); ++v) {
      const auto& [first, total] = figure.variables[v];
      group.rows.push_back({s.variables[v].name, {{first.value, first.error}, {total.value, total.error}}});
    }
  }
  return chart;
}

}  // namespace netloft::studies
