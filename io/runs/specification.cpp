// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/prepared_scene.hpp"
#include "io/scenes/reading/analysis.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>

namespace netloft::runs {

namespace {

/// Whether a name is one word, or two words with a slash between them, of letters, digits, '_' and '-'.
bool is_component_name(const std::string& name) {
  const auto is_word = [](std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
      return std::isalnum(c) || c == '_' || c == '-';
    });
  };
  const auto slash = name.find('/');
  return is_word(std::string_view(name).substr(0, slash)) &&
         (slash == std::string::npos || is_word(std::string_view(name).substr(slash + 1)));
}

const char* example_of(const std::string& key) {
  if (key == "integrator") return "newmark:corrector=fixed-point";
  return key == "solver" ? "newton:method=classic" : "auto:restarts=6";
}

[[noreturn]] void refuse(const std::string& key, const std::string& specification, const std::string& why) {
  throw std::invalid_argument("--" + key + " " + specification + ": " + why +
                              "; write NAME or NAME:key=value,key=value, such as " + example_of(key));
}

}  // namespace

std::vector<formats::Change> choose_method(const std::string& key, const std::string& specification) {
  const auto colon = specification.find(':');
  const std::string name = specification.substr(0, colon);
  if (!is_component_name(name)) refuse(key, specification, "\"" + name + "\" is no name of a " + key);
  std::vector<formats::Change> all{formats::read_change("analysis." + key + "=\"" + name + "\"")};
  if (colon == std::string::npos) return all;
  if (colon + 1 == specification.size()) refuse(key, specification, "nothing follows the colon");
  std::set<std::string> keys;
  std::istringstream pairs(specification.substr(colon + 1));
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size())
      refuse(key, specification, "\"" + pair + "\" is not key=value");
    if (!keys.insert(pair.substr(0, equals)).second)
      refuse(key, specification, pair.substr(0, equals) + " is given twice");
    const scenes::ComponentTable at = scenes::table_of_component(name);
    all.push_back(formats::read_change("analysis." + at.plugin +
                                       (at.component.empty() ? "" : "." + at.component) + "." + pair));
  }
  return all;
}

}  // namespace netloft::runs
