// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/key_figures.hpp"

#include "io/pictures/view/report_html.hpp"
#include "io/results/text/gear_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace netloft::pictures {

namespace {

constexpr std::size_t kMostKeyFigures = 9;

/// A figure and what people call it.
struct KeyFigure {
  std::string words;
  const results::NamedScalar* figure;
};

/// Of a gear height, spreads, area and drag, what the ship pulls, and the pulls of its rigging; of other
/// scenes what they ask for.
std::vector<KeyFigure> key_figures_of(const results::StoredResult& result) {
  std::vector<KeyFigure> keys;
  const auto add = [&](std::string_view group, std::string_view what) {
    for (const auto& figure : result.figures)
      if (figure.name.starts_with(group) && figure.name.ends_with(what))
        keys.push_back({results::principal_name(figure.name), &figure});
  };
  for (const auto* what :
       {"headline_height", "upper_wing_spread", "lower_wing_spread", "door_spread", "area"})
    add("mouth/", what);
  add("pairs/", "/spread");
  add("drag/all/x", "");
  add("towing/pull", "");
  add("rigging/", "/tension_start");
  for (const auto& scalar : result.scalars) keys.push_back({spoken(scalar.name), &scalar});
  if (keys.size() > kMostKeyFigures) keys.resize(kMostKeyFigures);
  return keys;
}

/// "1.99 m", "22.1 kN"
std::string value_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  if (unit == "N" && std::abs(value) >= 1000) return fmt::format("{:.3g} kN", value / 1000);
  return fmt::format("{:.3g}", value) + (unit == "1"    ? ""
                                         : unit == "m2" ? " m²"
                                         : unit == "m3" ? " m³"
                                                        : " " + unit);
}

std::string box_html(const KeyFigure& key, const results::NamedScalar* after) {
  const results::NamedScalar& figure = *key.figure;
  std::string text = value_text(figure.value, figure.unit);
  if (after) text += " → " + value_text(after->value, after->unit);
  return "<div><dt>" + in_html(key.words) + "</dt><dd title=\"" + in_html(figure.doc) +
         "\"><span data-figure=\"" + in_html(figure.name) + "\">" + in_html(text) + "</span> <small>" +
         in_html(results::error_text(after ? *after : figure)) + "</small></dd></div>\n";
}

}  // namespace

std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string badge_html(const results::StoredResult& result) {
  std::string words = result.outcome.empty() ? "the run has not ended" : result.outcome;
  if (!result.stability.empty() && result.stability != "unknown")
    words += ", " + result.stability + " equilibrium";
  return std::string("<span class=\"badge") + (result.is_answer() ? " answer" : "") + "\">" + in_html(words) +
         "</span>\n";
}

std::string key_figures_html(const std::vector<const results::StoredResult*>& results) {
  std::string html;
  for (const auto& key : key_figures_of(*results.front())) {
    const auto* after = results.size() == 2 ? results[1] : nullptr;
    const results::NamedScalar* same =
        after ? results::find_scalar(after->figures, key.figure->name) : nullptr;
    if (after && !same) same = results::find_scalar(after->scalars, key.figure->name);
    html += box_html(key, same);
  }
  return html.empty() ? "" : "<dl id=\"keys\">\n" + html + "</dl>\n";
}

}  // namespace netloft::pictures
