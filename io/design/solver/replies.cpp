// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/replies.hpp"

#include "io/design/texts/literal.hpp"
#include "io/design/texts/written_value.hpp"
#include "io/formats/units/units.hpp"
#include "io/pictures/view/packed_array.hpp"
#include "io/results/figures/key_figures.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::design {

namespace {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// The size of the unit of a number in the unit of its range: 0.514 (m/s) for a knot.
double size_of_unit(const studies::SceneNumber& number, const std::string& of_range) {
  if (number.unit.empty()) return 1;
  const formats::Quantity one = formats::to_si("1 " + number.unit, of_range);
  return one.ok() && one.value > 0 ? one.value : 1;
}

void put_words(const studies::SceneNumber& number, const formats::NumberWords& words, Json& json) {
  const double unit = size_of_unit(number, words.unit);
  if (number.unit.empty() && words.unit != "1") json["unit"] = words.unit;
  json["least"] = number_or_null(words.range.lo / unit);
  json["largest"] = number_or_null(words.range.hi / unit);
  json["whole"] = words.is_whole;
  json["doc"] = words.doc;
}

/// The description of the number, or of the array to which it belongs.
const formats::NumberWords* words_of(const std::string& path,
                                     const std::map<std::string, formats::NumberWords>& words) {
  const auto at = words.find(path);
  return at == words.end() ? nullptr : &at->second;
}

}  // namespace

Json words_json(const formats::NumberWords& words) {
  return {{"unit", words.unit},
          {"doc", words.doc},
          {"lo", number_or_null(words.range.lo)},
          {"hi", number_or_null(words.range.hi)},
          {"whole", words.is_whole}};
}

formats::NumberWords words_in(const Json& json) {
  formats::NumberWords words{json["unit"], json["doc"], {}, json["whole"]};
  words.range.lo = json["lo"].is_null() ? -INFINITY : json["lo"].get<double>();
  words.range.hi = json["hi"].is_null() ? INFINITY : json["hi"].get<double>();
  return words;
}

Json messages_json(const formats::Diagnostics& diagnostics) {
  Json all = Json::array();
  for (const formats::Diagnostic& one : diagnostics.sorted()) {
    Json json = {{"severity", one.severity == formats::Severity::error ? "error" : "warning"},
                 {"file", diagnostics.where({one.place.file, 0, 0})},
                 {"line", one.place.line},
                 {"column", one.place.column},
                 {"length", one.place.length},
                 {"message", one.message},
                 {"hint", one.hint},
                 {"changes", one.changes}};
    all.push_back(std::move(json));
  }
  return all;
}

Json edit_json(const Edit& edit, const formats::StoredTexts& texts) {
  const std::string_view before = std::string_view(texts.at(edit.file)).substr(0, edit.at);
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t begin = before.rfind('\n') + 1;
  const auto column = 1 + std::ranges::count_if(before.substr(begin), [](char c) {
                        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
                      });
  return {{"file", edit.file},
          {"line", line},
          {"column", column},
          {"before", edit.before},
          {"after", edit.after}};
}

Json numbers_json(const formats::Document& document,
                  const std::map<std::string, formats::NumberWords>& words) {
  Json all = Json::array();
  for (const studies::SceneNumber& number : studies::numbers_of(document.root())) {
    Json json = {{"path", number.path}, {"value", number_or_null(number.value)}, {"unit", number.unit}};
    if (const auto* known = words_of(number.path, words)) put_words(number, *known, json);
    const formats::Change change = formats::read_change(number.path + "=0");
    const formats::Place& place = follow(document.root(), change.steps).value->place;
    if (place.file >= 0) json["file"] = document.files().at(static_cast<std::size_t>(place.file)).path;
    json["line"] = place.line;
    json["column"] = place.column;
    all.push_back(std::move(json));
  }
  return all;
}

Json figures_json(const results::Result& result) {
  const auto keys = studies::chosen_figures(result, {});
  const auto figures = studies::all_figures(result);
  Json all = Json::array();
  for (std::size_t f = 0; f < figures.size(); ++f) {
    const results::NamedScalar& one = figures[f];
    all.push_back({{"name", one.name},
                   {"unit", one.unit},
                   {"doc", one.doc},
                   {"value", number_or_null(one.value)},
                   {"error", number_or_null(one.solver_error)},
                   {"mesh_error", number_or_null(one.mesh_error)},
                   {"key", std::ranges::find(keys, f) != keys.end()}});
  }
  return all;
}

Json verdict_json(const Outcome& outcome) {
  Json json = {{"status", name_of(outcome.status)},
               {"sentence", outcome.sentence},
               {"at_fault", outcome.at_fault},
               {"messages", messages_json(outcome.diagnostics)},
               {"same_mesh", outcome.has_same_mesh},
               {"own_mesh", outcome.has_own_mesh},
               {"as_run", outcome.is_as_run},
               {"ghost_off", outcome.ghost_off ? Json(*outcome.ghost_off) : Json(nullptr)},
               {"jump", nullptr},
               {"seconds", {{"reading", outcome.reading_seconds}, {"solving", outcome.solving_seconds}}}};
  if (outcome.jump)
    json["jump"] = {{"off", outcome.jump->off}, {"moved", outcome.jump->moved}, {"why", outcome.jump->why}};
  return json;
}

Json outcome_json(const Outcome& outcome, const LiveScene& scene) {
  Json json = verdict_json(outcome);
  if (outcome.status != Outcome::Status::converged) return json;
  json["points"] = pictures::packed(scene.last()->points);
  json["figures"] = figures_json(scene.last()->result);
  return json;
}

Json points_json(const LiveScene& scene) {
  Json points = Json::array();
  for (const auto& [name, node] : scene.points_of_plan()) {
    const double* at = &scene.last()->points[3 * static_cast<std::size_t>(node)];
    points.push_back({{"name", name}, {"node", node}, {"at", {at[0], at[1], at[2]}}});
  }
  return {{"points", points}};
}

Json tangents_json(const Tangents& tangents, const Equilibrium& at) {
  const studies::NumberEffect& effect = tangents.effect;
  Json json = {{"path", effect.number.path}, {"value", effect.number.value},
               {"unit", effect.number.unit}, {"why_not", effect.why_not},
               {"motion", nullptr},          {"slopes", Json::object()}};
  if (tangents.motion.empty()) return json;
  json["motion"] = pictures::packed(tangents.motion);
  const auto figures = studies::all_figures(at.result);
  for (std::size_t f = 0; f < figures.size(); ++f)
    json["slopes"][figures[f].name] = number_or_null(effect.per_unit[f]);
  return json;
}

}  // namespace netloft::design
