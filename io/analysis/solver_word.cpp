// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/case.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace netloft::io {

namespace {

/// Letters, digits, '_' and '-', and between them one slash.
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

[[noreturn]] void refuse(const std::string& word, const std::string& why) {
  throw std::invalid_argument("--solver " + word + ": " + why +
                              "; write NAME or NAME:key=value,key=value, such as newton:method=classic");
}

}  // namespace

std::vector<std::string> solver_overrides(const std::string& word) {
  const auto colon = word.find(':');
  const std::string name = word.substr(0, colon);
  if (!is_component_name(name)) refuse(word, "\"" + name + "\" is no name of a solver");
  std::vector<std::string> all{"analysis.solver=\"" + name + "\""};
  if (colon == std::string::npos) return all;
  if (colon + 1 == word.size()) refuse(word, "nothing follows the colon");
  std::istringstream pairs(word.substr(colon + 1));
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size())
      refuse(word, "\"" + pair + "\" is not key=value");
    all.push_back("analysis." + name.substr(0, name.find('/')) + "." + pair);
  }
  return all;
}

}  // namespace netloft::io
