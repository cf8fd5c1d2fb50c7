// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/scene_numbers.hpp"

#include "io/formats/text/likely_path.hpp"
#include "io/formats/units/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>

namespace netloft::studies {

namespace {

constexpr std::array kNotOfTheScene{"analysis", "results", "catalogue", "accept", "gear.nodes"};

class NumberCollector {
 public:
  void collect(const formats::Value& value, const std::string& path) {
    if (std::ranges::find(kNotOfTheScene, path) != kNotOfTheScene.end()) return;
    if (const auto* table = value.as<formats::Table>()) {
      for (const auto& [key, place, member] : table->members) collect(member, formats::join_path(path, key));
    } else if (const auto* array = value.as<formats::Array>()) {
      for (std::size_t i = 0; i < array->items.size(); ++i)
        collect(array->items[i], path + "[" + std::to_string(i) + "]");
    } else if (const auto* real = value.as<double>()) {
      numbers_.push_back({path, *real, ""});
    } else if (const auto* whole = value.as<std::int64_t>()) {
      numbers_.push_back({path, static_cast<double>(*whole), ""});
    } else if (const auto* text = value.as<std::string>()) {
      const auto written = formats::read_as_written(*text);
      if (written.ok() && !written.unit.empty()) numbers_.push_back({path, written.number, written.unit});
    }
  }
  std::vector<SceneNumber> take() { return std::move(numbers_); }

 private:
  std::vector<SceneNumber> numbers_;
};

bool is_below(const std::string& path, const std::string& table) {
  return path.starts_with(table) &&
         (path.size() == table.size() || path[table.size()] == '.' || path[table.size()] == '[');
}

/// The error message for a path that does not lead to a number.
std::string no_number(const std::string& path, const std::vector<SceneNumber>& numbers) {
  std::vector<std::string> paths;
  for (const SceneNumber& number : numbers) paths.push_back(number.path);
  const auto near = formats::likely_path(path, paths);
  return "the scene states no number \"" + path + "\"; " +
         (near ? "did you mean \"" + *near + "\"?"
               : "write it into the scene, or state it with --set " + path + "=VALUE");
}

/// Reads the standard deviation of a number: "0.1 kn", or "10 %" of the number.
double read_deviation(const std::string& text, const SceneNumber& number) {
  const bool is_percent = text.ends_with('%');
  const auto read =
      number_in_unit(is_percent ? text.substr(0, text.size() - 1) : text, is_percent ? "" : number.unit);
  if (!read || !(*read > 0))
    throw std::invalid_argument(
        number.path + " = " + formats::format(number.value) + (number.unit.empty() ? "" : " " + number.unit) +
        " cannot have the standard deviation \"" + text + "\"; give a positive number" +
        (number.unit.empty() ? "" : " with a unit such as " + number.unit) + ", or 5% of it");
  return is_percent ? 0.01 * *read * std::abs(number.value) : *read;
}

/// Adds those parameters of a part or law that are reals with a value.
void add_reals(const netloft::Values& values, const std::vector<netloft_parameter>& parameters,
               const std::string& path, std::vector<SceneNumber>& numbers) {
  for (const netloft_parameter& parameter : parameters) {
    const auto at = values.find(parameter.name);
    const double* real = at == values.end() ? nullptr : std::get_if<double>(&at->second);
    if (!real || parameter.kind != NETLOFT_REAL) continue;
    const std::string unit = parameter.unit == std::string_view("1") ? "" : parameter.unit;
    numbers.push_back({path + "." + parameter.name, *real, unit, {}, 0, parameter.doc});
  }
}

}  // namespace

std::vector<formats::Change> SceneNumber::to(double other) const {
  std::vector<formats::Change> all;
  for (const FollowingKey& key : keys.empty() ? std::vector<FollowingKey>{{path, 1, 0}} : keys) {
    const std::string text = formats::format(key.offset + key.factor * other);
    all.push_back(
        formats::read_change(key.path + "=" + (unit.empty() ? text : '"' + text + ' ' + unit + '"')));
  }
  return all;
}

SceneNumber number_of(const Variable& variable, double value) {
  return {variable.name, value, variable.unit, variable.keys};
}

std::vector<SceneNumber> numbers_of(const formats::Value& tables) {
  NumberCollector all;
  all.collect(tables, "");
  return all.take();
}

std::vector<SceneNumber> parameters_of(const scenes::LoadedScene& loaded, Registry& registry) {
  std::set<std::uint32_t> of_plan;
  if (const auto& gear = loaded.gear)
    for (const auto* parts : {&gear->panels, &gear->ropes, &gear->pieces})
      of_plan.insert(parts->begin(), parts->end());
  std::vector<SceneNumber> numbers;
  for (std::uint32_t p = 0; p < loaded.scene.parts.size(); ++p) {
    const Part& part = loaded.scene.parts[p];
    if (part.companion) continue;
    const std::string path = formats::join_path(of_plan.contains(p) ? "elements" : "parts", part.name);
    add_reals(part.parameters, registry.element(part.type).parameters, path, numbers);
    for (const auto& [slot, law] : part.laws)
      add_reals(law.parameters, registry.law(law.type).parameters, formats::join_path(path, slot), numbers);
  }
  return numbers;
}

std::vector<SceneNumber> chosen_numbers(runs::PreparedScene& scene, const std::vector<std::string>& paths) {
  formats::Diagnostics said;  // unused: errors were reported when the scene was read
  auto numbers = numbers_of(scene.source().scene.tables(scene.source().changes, said));
  if (paths.empty()) return numbers;
  const std::size_t written = numbers.size();
  for (SceneNumber& parameter : parameters_of(scene.loaded(), scene.registry()))
    if (std::ranges::find(numbers, parameter.path, &SceneNumber::path) == numbers.end())
      numbers.push_back(std::move(parameter));
  std::vector<bool> is_chosen(numbers.size(), false);
  for (const std::string& words : paths) {
    const std::string path = words.substr(0, words.find('='));
    const bool is_part = path.find('.') != std::string::npos;
    bool is_known = false;
    for (std::size_t n = 0; n < (is_part ? numbers.size() : written); ++n) {
      if (!is_below(numbers[n].path, path)) continue;
      is_chosen[n] = is_known = true;
      if (path != words) numbers[n].deviation = read_deviation(words.substr(path.size() + 1), numbers[n]);
    }
    if (!is_known) throw std::invalid_argument(no_number(path, numbers));
  }
  std::vector<SceneNumber> some;
  for (std::size_t n = 0; n < numbers.size(); ++n)
    if (is_chosen[n]) some.push_back(std::move(numbers[n]));
  return some;
}

}  // namespace netloft::studies
