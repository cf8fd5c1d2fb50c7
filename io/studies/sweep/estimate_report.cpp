// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/estimate.hpp"
#include "io/studies/sweep/study_plots.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;
using Out = std::back_insert_iterator<std::string>;

constexpr std::size_t kMostSentences = 5;  // limit of sentences in the text; JSON has all

constexpr const char* kExtrapolated =
    "these values lie beyond the points that have a stable equilibrium: the estimates and their errors are "
    "extrapolations";
constexpr const char* kEvents = "equilibria fold or jump next to these values: figures may jump there, too";

/// Value and error, the error with two digits.
std::string number_text(const WithError& number) {
  return fmt::format("{:>12.6g} ± {:<8.2g}", number.value, number.error);
}

std::string left_out_text(const LeftOutRow& row) {
  return fmt::format("item {}, point {}: {}{}{}", row.item, row.point, row.status,
                     row.reason.empty() ? "" : ": ", row.reason);
}

void head_text(const std::string& study, const StudyEstimate& e, Out out) {
  fmt::format_to(out, "{} at", study);
  for (std::size_t v = 0; v < e.at.size(); ++v)
    fmt::format_to(out, "{} {} {}", v ? "," : "", e.at[v].first, e.at[v].second);
  if (e.samples) fmt::format_to(out, "{} over {} samples", e.at.empty() ? "" : ",", e.samples);
  fmt::format_to(out, "\n");
}

void figures_text(const StudyEstimate& e, Out out) {
  fmt::format_to(out, "  {:<40} {:>23}", "figure", e.samples ? "median" : "");
  if (e.samples) fmt::format_to(out, " {:>21} % {:>21} %", 100 * kBandLow, 100 * kBandHigh);
  fmt::format_to(out, "  unit\n");
  for (const EstimatedFigure& figure : e.figures) {
    if (!figure.why_not.empty()) {
      fmt::format_to(out, "  {:<40} {}\n", figure.name, figure.why_not);
      continue;
    }
    fmt::format_to(out, "  {:<40} {}", figure.name, number_text(figure.value));
    if (figure.low) fmt::format_to(out, " {} {}", number_text(*figure.low), number_text(*figure.high));
    fmt::format_to(out, "  {}\n", figure.unit == "1" ? "" : figure.unit);
  }
}

/// Writes at most kMostSentences sentences as a list, and the number of the rest.
template <class Items, class Text>
void list_text(const Items& items, const char* head, const Text& text, Out out) {
  if (items.empty()) return;
  fmt::format_to(out, "{}\n", head);
  for (std::size_t i = 0; i < std::min(items.size(), kMostSentences); ++i)
    fmt::format_to(out, "  {}\n", text(items[i]));
  if (items.size() > kMostSentences) fmt::format_to(out, "  and {} more\n", items.size() - kMostSentences);
}

Json number_json(const WithError& number) { return {{"value", number.value}, {"error", number.error}}; }

Json figure_json(const EstimatedFigure& figure) {
  if (!figure.why_not.empty()) return {{"unit", figure.unit}, {"why_not", figure.why_not}};
  Json json = number_json(figure.value);
  json["unit"] = figure.unit;
  json["points"] = figure.points;
  if (figure.samples) json["samples"] = figure.samples;
  if (figure.low) {
    json["low"] = number_json(*figure.low);
    json["high"] = number_json(*figure.high);
  }
  return json;
}

}  // namespace

std::string estimate_text(const std::string& study, const StudyEstimate& e) {
  std::string text;
  const Out out(text);
  head_text(study, e, out);
  figures_text(e, out);
  if (e.is_extrapolated) fmt::format_to(out, "warning: {}\n", kExtrapolated);
  list_text(
      e.events, (std::string("warning: ") + kEvents).c_str(), [](const auto& event) { return event; }, out);
  list_text(e.left_out, fmt::format("left out: {} without a stable equilibrium", e.left_out.size()).c_str(),
            left_out_text, out);
  text.pop_back();
  return text;
}

std::string estimate_json(const std::string& study, const StudyEstimate& e) {
  Json at = Json::object(), figures = Json::object(), left_out = Json::array();
  for (const auto& [variable, value] : e.at) at[variable] = value;
  for (const EstimatedFigure& figure : e.figures) figures[figure.name] = figure_json(figure);
  for (const LeftOutRow& row : e.left_out)
    left_out.push_back(
        {{"item", row.item}, {"point", row.point}, {"status", row.status}, {"reason", row.reason}});
  const Json json = {{"study", study},
                     {"at", std::move(at)},
                     {"samples", e.samples},
                     {"extrapolated", e.is_extrapolated},
                     {"figures", std::move(figures)},
                     {"events", e.events},
                     {"left_out", std::move(left_out)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::studies
