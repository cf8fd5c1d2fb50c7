// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/measured.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;
using results::text_with_unit, results::unit_of_ratio;

// kRows: number of rows in the table of a figure. kPaths: number of paths that are listed for each reason why
// numbers have no derivatives.
constexpr std::size_t kRows = 8, kPaths = 3;

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
  const auto effects = ranked_effects(found, f);
  if (effects.empty()) return text + "  depends on none of these numbers\n";
  text += fmt::format("  {:<44} {:>18} {:>16} {:>10}   {}\n", "number", "value",
                      has_deviations(found) ? "a deviation more" : "1 % more of it", "", "one unit more");
  for (std::size_t i = 0; i < std::min(kRows, effects.size()); ++i) text += row_of(found, *effects[i], f);
  for (const NumberEffect& effect : found.effects)
    if (effect.why_not.empty() && !std::isfinite(effect.per_unit[f]))
      text += "  " + effect.number.path +
              ": the figure is undefined for slightly different values of this number\n";
  return text;
}

std::size_t sum_of(const std::map<std::string, std::size_t>& by_part) {
  std::size_t sum = 0;
  for (const auto& [part, count] : by_part) sum += count;
  return sum;
}

/// Says how many of `all` switch, and in which parts most of these are: "nodes: 8, 1.2 % (headrope 5,
/// footrope 3)".
std::string text_of(const std::map<std::string, std::size_t>& by_part, std::size_t all,
                    const std::string& what) {
  std::vector<std::pair<std::string, std::size_t>> parts(by_part.begin(), by_part.end());
  std::ranges::stable_sort(parts, std::ranges::greater{}, [](const auto& part) { return part.second; });
  const std::size_t sum = sum_of(by_part);
  std::string text =
      fmt::format("{}: {}, {:.2g} % (", what, sum, 100 * static_cast<double>(sum) / static_cast<double>(all));
  for (std::size_t i = 0; i < std::min(kPaths, parts.size()); ++i)
    text += fmt::format("{}{} {}", i ? ", " : "", parts[i].first, parts[i].second);
  return text + (parts.size() > kPaths ? ", …)" : ")");
}

std::string sides_text(const SwitchSides& sides) {
  std::string text;
  if (sides.members) text += fmt::format("{} of {} bars and twines are slack", sides.slack, sides.members);
  if (sides.nodes)
    text += fmt::format("{}{} of {} nodes touch the ground", text.empty() ? "" : ", ", sides.touching,
                        sides.nodes);
  return text;
}

std::string row_of_switches(const NumberEffect& effect, const SwitchSides& sides) {
  std::string text;
  if (const auto& members = effect.switches.members; !members.empty())
    text = text_of(members, sides.members, "bars and twines");
  if (const auto& nodes = effect.switches.nodes; !nodes.empty())
    text += (text.empty() ? "" : "; ") + text_of(nodes, sides.nodes, "nodes");
  return fmt::format("  {:<44} {:>18}   {}\n", effect.number.path, value_of(effect.number), text);
}

/// Says which members are slack and which nodes touch the ground at the equilibrium, and lists the numbers
/// whose typical changes switch most members and nodes.
std::string reach_text(const Sensitivities& found) {
  const std::string sides = sides_text(found.sides);
  if (sides.empty()) return "";
  std::vector<const NumberEffect*> effects;
  for (const NumberEffect& effect : found.effects)
    if (effect.switches.any()) effects.push_back(&effect);
  const auto size = [](const NumberEffect* e) {
    return sum_of(e->switches.members) + sum_of(e->switches.nodes);
  };
  std::ranges::stable_sort(effects, std::ranges::greater{}, size);
  const std::string change = has_deviations(found) ? "a deviation" : "1 %";
  std::string text = "\nThe derivatives are valid as long as this does not change: " + sides + "\n";
  if (effects.empty()) return text + "  no change of a number by " + change + " changes it, to first order\n";
  text += "  it changes with " + change + " more or less of these numbers, to first order:\n";
  for (std::size_t i = 0; i < std::min(kRows, effects.size()); ++i)
    text += row_of_switches(*effects[i], found.sides);
  if (effects.size() > kRows)
    text += fmt::format("  {} other numbers change less of it\n", effects.size() - kRows);
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
  return text + reach_text(found) + left_out_text(found);
}

formats::BarChart sensitivity_bars(const Sensitivities& found, const std::vector<std::size_t>& figures) {
  formats::BarChart chart{"change [%]", {has_deviations(found) ? "one deviation more" : "1 % more"}, {}};
  for (const std::size_t f : figures) {
    const results::NamedScalar& figure = found.figures[f];
    if (figure.value == 0 || !std::isfinite(figure.value)) continue;
    auto& group = chart.groups.emplace_back(formats::BarChart::Group{figure.name, {}});
    for (const NumberEffect* effect : ranked_effects(found, f)) {
      if (group.rows.size() == kRows) break;
      const double percent = 100 * typical_effect(*effect, f) / std::abs(figure.value);
      group.rows.push_back({effect->number.path, {{percent, 0}}});
    }
  }
  return chart;
}

namespace {

Json json_of(const SwitchSides& sides) {
  return {{"members", sides.members},
          {"slack", sides.slack},
          {"ground_nodes", sides.nodes},
          {"touching", sides.touching}};
}

/// Adds what limits the range of a derivative: the switches within the typical change of the number, part by
/// part, and a near fold.
void add_reach(const NumberEffect& effect, Json& row) {
  if (std::isfinite(effect.fold_at)) row["fold_at"] = effect.fold_at;
  if (!effect.switches.members.empty()) row["switching_members"] = effect.switches.members;
  if (!effect.switches.nodes.empty()) row["switching_nodes"] = effect.switches.nodes;
}

}  // namespace

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
    add_reach(effect, row);
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
  return Json{{"status", status},
              {"frozen", json_of(found.sides)},
              {"figures", std::move(of)},
              {"numbers", std::move(to)}}
      .dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::studies
