// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/named_scalar.hpp"

namespace netloft::results {

// Numbers below this part of the largest in a table of forces are its round-off, and print as 0.
inline constexpr double kTableRoundOff = 1e-12;

/// The error of a number, of solver and mesh together; NaN unless both are known, because the error of the
/// mesh is by far the larger one as a rule.
double total_error(const NamedScalar& scalar);

/// A number with its error, both rounded to the first digit of the error (the second, if the first is 1):
/// "0.41 ± 0.06". Without a known error, or if that is round-off, the number alone in `format`.
std::string measured(double value, double error, const char* format = "{:.6g}");
std::string measured(const NamedScalar& scalar, const char* format = "{:.6g}");

/// A unit as people write it: "m²" for "m2", nothing for "1".
std::string unit_text(const std::string& unit);

}  // namespace netloft::results
