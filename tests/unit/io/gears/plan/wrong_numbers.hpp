// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/spelled_value.hpp"

#include <cctype>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft::test {

/// A message in which a placeholder replaces each number.
inline std::string without_numbers(const std::string& message) {
  std::istringstream words(message);
  std::string text;
  for (std::string word; words >> word;) {
    const bool is_number = std::isdigit(static_cast<unsigned char>(word[word[0] == '-' || word[0] == '+']));
    text += is_number ? "# " : word + " ";
  }
  return text;
}

/// Draws changes of one number of a plan: a count, a cutting, a depth, a length, a ratio, a number of floats.
/// The same seed gives the same changes with every compiler.
class NumberDraw {
 public:
  explicit NumberDraw(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return random_() % n; }

  formats::Change wrong_number(const formats::Value& root) {
    std::vector<Number> numbers;
    collect(root, "", "", numbers);
    const Number& number = numbers[below(numbers.size())];
    return formats::read_change(number.path + "=" + formats::spell_value(changed(*number.value)));
  }

 private:
  struct Number {
    std::string path;
    const formats::Value* value;
  };

  static bool is_wanted(const std::string& path, const std::string& key) {
    const bool is_of_plan = path.starts_with("panels.") || path.starts_with("hang[") ||
                            path.starts_with("join[") || path.starts_with("floats.") ||
                            path.starts_with("ropes.");
    for (const char* wanted : {"fore", "aft", "round", "depth", "meshes", "sides", "outer", "inner", "cut",
                               "length", "ratio", "take_up", "spread"})
      if (is_of_plan && key == wanted) return true;
    return false;
  }

  static void collect(const formats::Value& value, const std::string& path, const std::string& key,
                      std::vector<Number>& numbers) {
    if (const auto* table = value.as<formats::Table>()) {
      for (const auto& member : table->members)
        collect(member.value, formats::join_path(path, member.key), member.key, numbers);
    } else if (const auto* array = value.as<formats::Array>()) {
      for (std::size_t i = 0; i < array->items.size(); ++i)
        collect(array->items[i], path + "[" + std::to_string(i) + "]", "", numbers);
    } else if (is_wanted(path, key)) {
      numbers.push_back({path, &value});
    }
  }

  double factor() {
    constexpr double kFactors[] = {0.5, 0.7, 0.8, 0.9, 0.95, 1.05, 1.1, 1.25, 1.5, 2, 10};
    return kFactors[below(std::size(kFactors))];
  }

  formats::Value changed(const formats::Value& value) {
    if (const auto* whole = value.as<std::int64_t>())
      return {{}, static_cast<std::int64_t>(std::ceil(factor() * static_cast<double>(*whole)))};
    if (const auto* real = value.as<double>()) return {{}, std::round(factor() * *real * 1e4) / 1e4};
    return {{}, changed(*value.as<std::string>())};
  }

  /// Changes a text that is a cutting rate or begins with a number.
  std::string changed(const std::string& text) {
    std::size_t digits = 0;
    try {
      const double number = std::stod(text, &digits);
      const std::string rest = text.substr(digits);
      if (!rest.starts_with(' ')) return cutting();
      std::ostringstream changed;
      changed << (rest.starts_with(" along") || rest.starts_with(" at") ? std::ceil(factor() * number)
                                                                        : factor() * number)
              << rest;
      return changed.str();
    } catch (const std::invalid_argument&) {
      return cutting();
    }
  }

  std::string cutting() {
    constexpr const char* kRates[] = {"AN",       "AB in",    "AB out",  "1N1B in",  "1N2B in",
                                      "1N2B out", "2N1B in",  "5B1P in", "5B1P out", "1N4B in",
                                      "3B1M out", "1N1B out", "1N3B in", "SB1P in",  "1N22 in"};
    return kRates[below(std::size(kRates))];
  }

  std::mt19937 random_;
};

}  // namespace netloft::test
