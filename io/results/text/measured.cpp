// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::results {

namespace {

/// Formats a number. A negative number that rounds to zero loses its sign.
std::string plain_number(double value, const char* format) {
  std::string text = fmt::format(fmt::runtime(format), value);
  if (text.find_first_of("123456789") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
  return text;
}

/// Number of decimals to print for a value with this error.
int decimals_of(double error) {
  const double exponent = std::floor(std::log10(error));
  const bool begins_with_one = error < 1.95 * std::pow(10, exponent);
  return static_cast<int>(-exponent) + begins_with_one;
}

}  // namespace

double total_error(const NamedScalar& scalar) { return scalar.solver_error + scalar.mesh_error; }

std::string measured(double value, double error, const char* format) {
  constexpr double kNothing = 1e-9;  // a relative error below this is not shown
  constexpr int kMostDecimals = 6;
  if (!std::isfinite(value)) return "-";
  if (!std::isfinite(error) || error <= kNothing * std::abs(value)) return plain_number(value, format);
  const int decimals = decimals_of(error);
  if (decimals > kMostDecimals) return plain_number(value, format) + fmt::format(" ± {:.1g}", error);
  const int shown = std::max(decimals, 0);
  // Rounding unit if the error is large: 6500 ± 1800.
  const double unit = std::pow(10, std::max(-decimals, 0));
  const auto rounded = [&](double number) { return shown > 0 ? number : unit * std::round(number / unit); };
  return plain_number(rounded(value), fmt::format("{{:.{}f}}", shown).c_str()) +
         fmt::format(" ± {:.{}f}", rounded(error), shown);
}

std::string measured(const NamedScalar& scalar, const char* format) {
  return measured(scalar.value, total_error(scalar), format);
}

std::string unit_text(const std::string& unit) {
  return unit == "1" ? "" : unit == "m2" ? "m²" : unit == "m3" ? "m³" : unit;
}

std::string text_with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() || unit == "1" ? text : text + " " + unit;
}

std::string unit_of_ratio(const std::string& figure, const std::string& number) {
  return text_with_unit(figure.empty() ? "1" : figure,
                        number.empty() || number == "1" ? "" : "per " + number);
}

}  // namespace netloft::results
