// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace netloft::pictures {

namespace {

using Settings = std::map<std::string, std::string>;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Reads the options --set: "gear.nodes" and "500".
Settings settings_of_command(const SweepInput& result) {
  Settings settings;
  const auto& words = result.command;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string text;
    if (words[i] == "--set" && i + 1 < words.size()) text = words[i + 1];
    if (words[i].starts_with("--set=")) text = words[i].substr(6);
    if (const auto at = text.find('='); at != std::string::npos)
      settings[trimmed(text.substr(0, at))] = trimmed(text.substr(at + 1));
  }
  return settings;
}

/// Reads values on lines of their own in the scene, by table and key. Other values are ignored, because the
/// purpose is to name the varied setting, not to read scenes.
Settings settings_of_scene(const SweepInput& result) {
  Settings settings;
  std::istringstream text(result.scene);
  std::string line, table;
  while (std::getline(text, line)) {
    line = trimmed(line.substr(0, line.find('#')));
    const auto equals = line.find('=');
    if (line.starts_with('[') && line.ends_with(']'))
      table = line.substr(line.find_first_not_of('['), line.find(']') - line.find_first_not_of('[')) + ".";
    else if (equals != std::string::npos)
      settings[table + trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  return settings;
}

/// The leading number of "2.5 kn" or 12, and the unit after it.
struct Quantity {
  double number = NAN;
  std::string unit = {};
};

Quantity quantity_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? Quantity{} : Quantity{value, trimmed(end)};
}

std::string unquoted(const std::string& text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2)
                                                                      : text;
}

Varied varied_among(const std::vector<Settings>& all) {
  for (const auto& [name, first] : all.front()) {
    Varied varied{name, {}, {}};
    std::set<double> different;
    std::set<std::string> units;
    for (const auto& settings : all) {
      const auto at = settings.find(name);
      varied.values.push_back(at == settings.end() ? "" : unquoted(at->second));
      const Quantity quantity = quantity_in(varied.values.back());
      varied.numbers.push_back(quantity.number);
      units.insert(quantity.unit);
      if (std::isfinite(quantity.number)) different.insert(quantity.number);
    }
    if (units.size() == 1) varied.unit = *units.begin();
    if (different.size() == all.size()) return varied;
  }
  return {};
}

}  // namespace

Varied varied_setting(const std::vector<SweepInput>& results) {
  if (results.empty()) return {};
  for (const auto settings_of : {settings_of_command, settings_of_scene}) {
    std::vector<Settings> all;
    for (const auto& result : results) all.push_back(settings_of(result));
    if (const Varied varied = varied_among(all); !varied.name.empty()) return varied;
  }
  return {};
}

}  // namespace netloft::pictures
