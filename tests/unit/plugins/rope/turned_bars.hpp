// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/unit/plugins/kernel_oracle.hpp"

namespace netloft {

/// Two bars of these lengths, the second turned by phi in a tilted plane.
inline State<3> turned(double phi, double l1 = 0.8, double l2 = 1.1) {
  const Vec3<double> e{0.6, 0.48, 0.64}, f{-0.8, 0.36, 0.48};  // orthonormal
  State<3> s;
  const Vec3<double> a{0.3, -0.2, -5}, b = a + l1 * e;
  s.x = {a, b, b + (l2 * std::cos(phi)) * e + (l2 * std::sin(phi)) * f}, s.wants_tangent = true;
  return s;
}

}  // namespace netloft
