// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <string>

namespace netloft::gears {

/// Coordinates u, v of a point of an undeformed panel along both twine directions [bars]; at knots, both are
/// whole numbers (Priour 2013). U [meshes] is the coordinate across, outwards; V [meshes] is the coordinate
/// deep, aft:
///   diamond  u = U + V,  v = V − U;   T90  u = V + U,  v = U − V;   square  u = U,  v = V        (1)
/// Opened to a square, a mesh of diamond or T90 netting is √2 bars wide and √2 bars deep. Square netting is
/// counted in bars. If the netting is turned in its panel by φ, from outwards towards aft, with meshes opened
/// to squares, (1) uses U′, V′ instead of U, V:
///   U′ = U cos φ + V sin φ,  V′ = V cos φ − U sin φ                                              (2)
/// Diamond netting turned by 45° is therefore square netting that is counted in units of √2 bars.
inline std::array<double, 2> twine_coordinates(const std::string& orientation, double angle, double U,
                                               double V) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double across = angle == 0 ? U : U * c + V * s, deep = angle == 0 ? V : V * c - U * s;  // (2)
  if (orientation == "square") return {across, deep};
  return {across + deep, orientation == "t90" ? across - deep : deep - across};  // (1)
}

/// Length of the twines between two points of a panel when all twines are pulled straight, in stretched
/// meshes of two bars:
///   s = (|Δu| + |Δv|)/2                                                                          (3)
/// Along a cutting, s is the total length of its bars, points and meshes (cutting.hpp).
inline double stretched_meshes(const std::array<double, 2>& from_to) {
  return (std::abs(from_to[0]) + std::abs(from_to[1])) / 2;
}

}  // namespace netloft::gears
