// SPDX-License-Identifier: BSD-3-Clause
//
// Irregular numbers that are the same in every run. Displacements made of them break every symmetry of a
// scene.
#pragma once
#include <cmath>
#include <cstddef>

namespace netloft {

/// Returns the i-th number of a sequence in [−1, 1) that is the same on every machine: 2 frac((i + 1) φ +
/// shift) − 1. φ is the golden ratio, whose multiples are distributed most evenly (H. Weyl, Math. Ann. 77,
/// 1916). A vector of these numbers has a component along every displacement that occurs in practice.
inline double scattered(std::size_t i, double shift = 0) {
  constexpr double kGolden = 0.61803398874989485;
  const double multiple = kGolden * static_cast<double>(i + 1) + shift;
  return 2 * (multiple - std::floor(multiple)) - 1;
}

}  // namespace netloft
