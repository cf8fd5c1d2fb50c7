// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/cutting.hpp"

#include "framework/parameters/nearest.hpp"

#include <cctype>

namespace netloft::gears {

namespace {

constexpr int kMostInARow = 999;

/// Parses a rate that consists of one kind of cut, such as "AB" (all bars).
std::optional<CuttingRate> parse_all(char letter) {
  if (letter == 'B') return CuttingRate{.bars = 1};
  if (letter == 'N' || letter == 'P') return CuttingRate{.points = 1};
  if (letter == 'M' || letter == 'T') return CuttingRate{.meshes = 1};
  return {};
}

/// Reads the digits at `at` as a number; 0 if there are no digits or the number is too large.
int read_number(std::string_view text, std::size_t& at) {
  int number = 0;
  for (; at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) && number <= kMostInARow;
       ++at)
    number = 10 * number + (text[at] - '0');
  return number <= kMostInARow ? number : 0;
}

/// Adds a group such as "5B" or "1P" to a rate. Returns false if the letter is unknown or the kind was given
/// before.
bool add_group(CuttingRate& rate, int number, char letter) {
  int* count = letter == 'B'                    ? &rate.bars
               : letter == 'N' || letter == 'P' ? &rate.points
               : letter == 'M' || letter == 'T' ? &rate.meshes
                                                : nullptr;
  if (!count || *count || number == 0) return false;
  *count = number;
  return true;
}

}  // namespace

std::optional<CuttingRate> parse_rate(std::string_view text) {
  if (text.size() == 2 && text[0] == 'A') return parse_all(text[1]);
  CuttingRate rate;
  int groups = 0;
  for (std::size_t at = 0; at < text.size(); ++groups) {
    const int number = read_number(text, at);
    if (at >= text.size() || !add_group(rate, number, text[at++])) return {};
  }
  const bool mixes_both = rate.points > 0 && rate.meshes > 0;
  if (groups != 2 || mixes_both) return {};  // a rate of one kind is written AB, AN or AM
  return rate;
}

std::vector<std::string> rates_near(const std::string& text) {
  std::vector<std::string> near;
  const auto add = [&](const std::string& rate) {
    if (detail::edit_distance(text, rate) == 1) near.push_back(rate);
  };
  for (const char* all : {"AB", "AN", "AP", "AM", "AT"}) add(all);
  for (int bars = 1; bars <= 12; ++bars)
    for (int others = 1; others <= 12; ++others)
      for (const char* letter : {"P", "M", "N", "T"}) {
        const std::string b = std::to_string(bars) + "B", o = std::to_string(others) + letter;
        add(b + o);
        add(o + b);
      }
  return near;
}

}  // namespace netloft::gears
