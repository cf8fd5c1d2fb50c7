// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::axial {

/// A straight elastic twine or rope, where w [m] is the vector between its ends. Slack bars have a small
/// stiffness:
///   l = ‖w‖,  t = w/l                                          (1)
///   T = EA (l − l₀)/l₀  if l ≥ l₀,  else EA_c (l − l₀)/l₀      (2)  tension [N]
///   ψ = ½ T (l − l₀)                                           (3)  energy [J], dψ/dl = T
///   A = ∂(T t)/∂w = k t tᵀ + g (I − t tᵀ),  k = dT/dl,  g = T/l (4)  stiffness [N/m]
///   A₊: A with max(g, 0) for g, positive semi-definite          (5)
///   M = (max(EA, EA_c)/l₀) I, upper bound of A₊ for every w     (6)
/// EA, EA_c [N] are the stiffness in tension and in compression; l₀ [m] is the unstretched length. The
/// direction t does not exist at l = 0; for l < kCollapsed l₀, w/(kCollapsed l₀) replaces it. Source: the
/// linear spring of the trawl-gear paper, section 2.3; for the reduced stiffness of a slack twine, Priour, A
/// Finite Element Method for Netting (Springer 2013).
inline constexpr double kCollapsed = 1e-9;

struct Material {
  double EA, EA_compression;  // [N]
};

/// The scalars of (1)–(4) in one bar.
struct Bar {
  double l;        // current length [m]
  double inverse;  // 1/l [1/m]
  double T;        // tension [N]
  double k;        // stiffness dT/dl [N/m]
  double energy;   // elastic energy ψ [J]
};

inline Bar stretch(double wx, double wy, double wz, double l0, double EA, double EA_compression) {
  Bar b;
  b.l = std::sqrt(wx * wx + wy * wy + wz * wz);
  b.inverse = 1 / std::max(b.l, kCollapsed * l0);
  const double elongation = b.l - l0;
  b.k = (elongation >= 0 ? EA : EA_compression) / l0;
  b.T = b.k * elongation;
  b.energy = 0.5 * b.T * elongation;
  return b;
}

/// The six numbers xx, yx, yy, zx, zy, zz of A, A₊ or M, times `factor`.
struct Block {
  double v[6];
};

/// Computes A if `lowest_T` is −∞, and A₊ if it is 0.
inline Block stiffness(const Bar& b, double wx, double wy, double wz, double factor, double lowest_T) {
  const double g = factor * std::max(b.T, lowest_T) * b.inverse;
  const double s = (factor * b.k - g) * b.inverse * b.inverse;
  return {{s * wx * wx + g, s * wy * wx, s * wy * wy + g, s * wz * wx, s * wz * wy, s * wz * wz + g}};
}

/// Index of (row, column) of a symmetric 3 × 3 block among its six numbers.
inline constexpr int kPlace[3][3] = {{0, 1, 3}, {1, 2, 4}, {3, 4, 5}};

/// ψ of (3) for any number type. Tests compare its derivatives, computed with dual numbers, with the
/// functions above.
template <class T>
T energy(const Vec3<T>& w, double l0, const Material& m) {
  const T elongation = norm(w) - l0;
  return (0.5 * (elongation >= T(0) ? m.EA : m.EA_compression) / l0) * elongation * elongation;
}

}  // namespace netloft::axial
