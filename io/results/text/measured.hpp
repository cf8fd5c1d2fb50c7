// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/named_scalar.hpp"

namespace netloft::results {

// A force below this fraction of the largest force in its table is round-off, and is printed as 0.
inline constexpr double kTableRoundOff = 1e-12;

/// The sum of the solver error and the mesh error; NaN unless both are known, because the mesh error is
/// usually by far the larger one.
double total_error(const NamedScalar& scalar);

/// A number with its error: "0.41 ± 0.06". Both are rounded to the first significant digit of the error, or
/// to the second if the first is 1. If the error is unknown or only round-off, the number alone is written,
/// in `format`.
std::string measured(double value, double error, const char* format = "{:.6g}");
std::string measured(const NamedScalar& scalar, const char* format = "{:.6g}");

/// A unit in its usual spelling: "m²" for "m2", an empty text for "1".
std::string unit_text(const std::string& unit);

/// A text with its unit, such as "3 kn"; the text alone if there is no unit.
std::string text_with_unit(const std::string& text, const std::string& unit);

/// The unit of a derivative: "m per kn".
std::string unit_of_ratio(const std::string& figure, const std::string& number);

}  // namespace netloft::results
