// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/scene_numbers.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/formats/units/units.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

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

std::vector<std::string> paths_of(const std::vector<SceneNumber>& numbers) {
  std::vector<std::string> paths;
  for (const SceneNumber& number : numbers) paths.push_back(number.path);
  return paths;
}

}  // namespace

formats::Change SceneNumber::to(double other) const {
  const std::string text = formats::format(other);
  return formats::read_change(path + "=" + (unit.empty() ? text : '"' + text + ' ' + unit + '"'));
}

std::vector<SceneNumber> numbers_of(const formats::Value& tables) {
  NumberCollector all;
  all.collect(tables, "");
  return all.take();
}

std::vector<SceneNumber> chosen(const std::vector<SceneNumber>& numbers,
                                const std::vector<std::string>& paths) {
  if (paths.empty()) return numbers;
  for (const std::string& path : paths) {
    if (std::ranges::any_of(numbers, [&](const SceneNumber& n) { return is_below(n.path, path); })) continue;
    const auto near = nearest(path, paths_of(numbers));
    throw std::invalid_argument("the scene states no number \"" + path + "\"; " +
                                (near
                                     ? "did you mean \"" + *near + "\"?"
                                     : "write it into the scene, or state it with --set " + path + "=VALUE"));
  }
  std::vector<SceneNumber> some;
  for (const SceneNumber& number : numbers)
    if (std::ranges::any_of(paths, [&](const std::string& path) { return is_below(number.path, path); }))
      some.push_back(number);
  return some;
}

}  // namespace netloft::studies
