// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers that no symmetry survives, without a random generator.
#pragma once
#include <cmath>
#include <cstddef>

namespace netloft {

/// A number in [−1, 1), of a row that has a component in every direction one meets and is the same on every
/// machine: 2 frac((i + 1) φ + shift) − 1, where φ is the golden ratio, whose multiples spread most evenly
/// (H. Weyl, Math. Ann. 77, 1916).
inline double scattered(std::size_t i, double shift = 0) {
  constexpr double kGolden = 0.61803398874989485;
  const double multiple = kGolden * static_cast<double>(i + 1) + shift;
  return 2 * (multiple - std::floor(multiple)) - 1;
}

}  // namespace netloft
