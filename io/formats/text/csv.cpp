// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "io/formats/text/printable.hpp"

namespace netloft::formats {
namespace {

bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

bool begins_formula(const std::string& text) {
  constexpr const char* kBeginnings = "=+-@\t";  // some programs skip a tab
  return !text.empty() && std::string(kBeginnings).find(text.front()) != std::string::npos &&
         !is_number(text);
}

}  // namespace

std::string csv_field(const std::string& text) {
  const std::string cell = (begins_formula(text) ? "'" : "") + printable(text);
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

}  // namespace netloft::formats
