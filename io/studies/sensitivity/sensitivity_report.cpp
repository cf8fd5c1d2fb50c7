// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/sensitivity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;

// Rows of the table of one figure: numbers with the largest effects. Paths of numbers that are listed for
// each reason why they have no derivatives.
constexpr std::size_t kRows = 8, kPaths = 3;
// A number whose effect is a smaller fraction of the largest effect on a figure is not listed: it may be
// rounding.
constexpr double kNoEffect = 1e-6;

std::string text_with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : text + " " + unit;
}

std::string unit_of_ratio(const std::string& figure, const std::string& number) {
  const std::string above = figure.empty() ? "1" : figure;
  return number.empty() || number == "1" ? above : above + " per " + number;
}

double size_of(const NumberEffect& effect, std::size_t f) { return std::abs(typical_effect(effect, f)); }

bool has_deviations(const Sensitivities& found) {
  return std::ranges::any_of(found.effects, [](const NumberEffect& e) { return e.number.deviation > 0; });
}

/// The number with its standard deviation, if that is known.
std::string value_of(const SceneNumber& number) {
  const std::string value = fmt::format("{:.4g}", number.value);
  return number.deviation > 0
             ? text_with_unit(value + fmt::format(" ± {:.2g}", number.deviation), number.unit)
             : text_with_unit(value, number.unit);
}

/// The effects on a figure, the largest first.
std::vector<const NumberEffect*> ranked(const Sensitivities& found, std::size_t f) {
  std::vector<const NumberEffect*> effects;
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty() && size_of(effect, f) > 0) effects.push_back(&effect);
  std::ranges::stable_sort(effects, std::ranges::greater{},
                           [&](const NumberEffect* effect) { return size_of(*effect, f); });
  while (!effects.empty() && size_of(*effects.back(), f) < kNoEffect * size_of(*effects.front(), f))
    effects.pop_back();
  return effects;
}

std::string row_of(const Sensitivities& found, const NumberEffect& effect, std::size_t f) {
  const results::NamedScalar& figure = found.figures[f];
  const double change = typical_effect(effect, f);
  const std::string share =
      figure.value != 0 ? fmt::format("{:+.2g} %", 100 * change / std::abs(figure.value)) : "";
  return fmt::format(
      "  {:<44} {:>18} {:>16} {:>10}   {}{}\n", effect.number.path, value_of(effect.number),
      text_with_unit(fmt::format("{:+.3g}", change), figure.unit), share,
      fmt::format("{:+.3g} {}", effect.per_unit[f], unit_of_ratio(figure.unit, effect.number.unit)),
      depends_on_step(found, effect, f) ? "   depends on the step" : "");
}

std::string table_of(const Sensitivities& found, std::size_t f) {
  const results::NamedScalar& figure = found.figures[f];
  const double deviation = propagated_deviation(found, f);
  std::string text =
      fmt::format("\n{} = {}\n", figure.name,
                  text_with_unit(fmt::format("{:.4g}", figure.value) +
                                     (deviation > 0 ? fmt::format(" ± {:.2g}", deviation) : std::string()),
                                 figure.unit));
  const auto effects = ranked(found, f);
  if (effects.empty()) return text + "  depends on none of these numbers\n";
  text += fmt::format("  {:<44} {:>18} {:>16} {:>10}   {}\n", "number", "value",
                      has_deviations(found) ? "a deviation more" : "1 % more of it", "", "one unit more");
  for (std::size_t i = 0; i < std::min(kRows, effects.size()); ++i) text += row_of(found, *effects[i], f);
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty() && !std::isfinite(effect.per_unit[f]))
      text += "  " + effect.number.path + ": the figure is not defined a little beside this number\n";
  return text;
}

std::string left_out_text(const Sensitivities& found) {
  std::map<std::string, std::vector<std::string>> paths;
  for (const NumberEffect& effect : found.effects)
    if (!effect.why_not.empty()) paths[effect.why_not].push_back(effect.number.path);
  std::string text;
  for (const auto& [why, all] : paths) {
    text += fmt::format("  {}", all.front());
    for (std::size_t i = 1; i < std::min(kPaths, all.size()); ++i) text += ", " + all[i];
    if (all.size() > kPaths) text += fmt::format(" and {} more", all.size() - kPaths);
    text += ": " + why + "\n";
  }
  return text.empty() ? text : "\nNumbers without derivatives\n" + text;
}

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::string sensitivity_text(const Sensitivities& found, const std::vector<std::size_t>& figures) {
  std::string text;
  for (const std::size_t f : figures) text += table_of(found, f);
  return text + left_out_text(found);
}

formats::BarChart sensitivity_bars(const Sensitivities& found, const std::vector<std::size_t>& figures) {
  formats::BarChart chart{"change [%]", {has_deviations(found) ? "one deviation more" : "1 % more"}, {}};
  for (const std::size_t f : figures) {
    const results::NamedScalar& figure = found.figures[f];
    if (figure.value == 0 || !std::isfinite(figure.value)) continue;
    auto& group = chart.groups.emplace_back(formats::BarChart::Group{figure.name, {}});
    for (const NumberEffect* effect : ranked(found, f)) {
      if (group.rows.size() == kRows) break;
      const double percent = 100 * typical_effect(*effect, f) / std::abs(figure.value);
      group.rows.push_back({effect->number.path, {{percent, 0}}});
    }
  }
  return chart;
}

std::string sensitivity_json(const Sensitivities& found, const std::vector<std::size_t>& figures,
                             const std::string& status) {
  Json of = Json::array(), to = Json::array();
  for (const std::size_t f : figures) {
    const results::NamedScalar& figure = found.figures[f];
    of.push_back({{"name", figure.name}, {"value", json_of(figure.value)}, {"unit", figure.unit}});
    if (has_deviations(found)) of.back()["deviation"] = json_of(propagated_deviation(found, f));
  }
  for (const NumberEffect& effect : found.effects) {
    Json row{{"path", effect.number.path}, {"value", effect.number.value}, {"unit", effect.number.unit}};
    if (effect.number.deviation > 0) row["deviation"] = effect.number.deviation;
    if (!effect.why_not.empty()) {
      row["why_not"] = effect.why_not;
    } else {
      row["per_unit"] = Json::array();
      for (const std::size_t f : figures) row["per_unit"].push_back(json_of(effect.per_unit[f]));
      if (!effect.by_long_step.empty()) {
        row["depends_on_step"] = Json::array();
        for (const std::size_t f : figures)
          row["depends_on_step"].push_back(depends_on_step(found, effect, f));
      }
    }
    to.push_back(std::move(row));
  }
  return Json{{"status", status}, {"figures", std::move(of)}, {"numbers", std::move(to)}}.dump(
      2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::studies
