// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace netloft::test {

/// Two bars lean against each other, 2 b wide and h high without load, with a load at the top (R. von Mises
/// 1923):
///   f(z) = 2 EA (1/l₀ − 1/l) z,   l = (b² + z²)^½                                         (1)
///   f'(z) = 2 EA (1/l₀ − b²/l³)                                                           (2)
/// f is the upward load in equilibrium at the height z. Under a downward load the bars snap through at the
/// fold of (1), where f' vanishes, so that l³ = b² l₀.
inline constexpr const char* kTruss = R"([water]
density = 0
[parts.truss]
type = "rope/bar"
cells = 2
length = 2.0396078054371140
sketch = [[-1, 0, 0], [0, 0, 0.2], [1, 0, 0]]
rope = { diameter = "10 mm", EA = 10000, EA_compression = 10000, density = 1e-6 }
[parts.load]
type = "force/constant"
on = "truss.middle"
force = { z = 0 }
[[hold]]
on = ["truss.start", "truss.end"]
[[hold]]
on = "truss.middle"
axes = "y"
[results]
z = { of = "truss.middle", take = "z" }
)";
inline constexpr double kEA = 1e4, kL0 = 1.0198039027185570;

inline double load_of(double z) { return 2 * kEA * (1 / kL0 - 1 / std::hypot(1, z)) * z; }            // (1)
inline double slope_of(double z) { return 2 * kEA * (1 / kL0 - 1 / std::pow(std::hypot(1, z), 3)); }  // (2)
inline double load_of_fold() {
  const double l = std::cbrt(kL0);
  return load_of(std::sqrt(l * l - 1));
}

/// The height under a load between zero and the load at the fold, by bisection between the height at the fold
/// and the height without load.
inline double height_at(double load) {
  double low = std::sqrt(std::pow(kL0, 2.0 / 3) - 1), high = 0.2;
  for (int i = 0; i < 60; ++i) (load_of(0.5 * (low + high)) < load ? low : high) = 0.5 * (low + high);
  return low;
}

}  // namespace netloft::test
