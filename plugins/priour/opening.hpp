// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/angle.hpp"

namespace netloft::priour {

/// Resistance of the meshes to opening: a couple H(α−α₀) on each of the two twines of each knot. |d|/2 is the
/// number of knots in the triangle, 2α is the angle between the twines.
///   E = (|d|/2) H (α−α₀)²,  α = ½ ∠(Û, V̂) ∈ [0, π/2]                                            (1)
///   dE/dc = −(|d|/2) H (α−α₀)/s                                                                  (2)
///   d²E/dc² = (|d|/2) H [½ − (α−α₀) c/s]/s²              c = cos 2α, s = sin 2α by angle (1)      (3)
///   α² = Σ_k A_k e^k,  A_k = 2^(k−1) / (k² C(2k, k)),  e = 1 − c                                  (4)
/// H [N·m/rad] is given, or H = 12 EI/a from the bending stiffness EI of the twines (5): twines are clamped
/// at the knots, and each half of a bar of length a [m] is a cantilever under the shear of the other twine,
/// at small angles. α₀ [rad] is the half angle of the unloaded mesh. For α₀ = 0 the energy is smooth for
/// closed meshes, but (2) and (3) are 0/0 there; (4) replaces them for e < kSeries. E has a cusp at α = π/2
/// and, unless α₀ = 0, at α = 0. Near a cusp, states with s < kCusp are outside the domain; contact of knots
/// prevents them. Source: the trawl-gear paper, eq. (3); Priour 2001. Other programs use half the energy (1),
/// or the couple times 2 cos α.
struct Opening {
  static constexpr double kSeries = 0.1, kCusp = 1e-8;

  static Status tile(const double* stiffness, const Triangle::Lanes& lanes, netloft_tile& t);
  template <class T>
  static T oracle(const Triangle::Parameters& p, const Triangle::Data& d, const Water&,
                  const Points<T, 3>& x) {
    const T turned = 0.5 * acos(angle::cosine(d, x)) - p.opening_angle;
    return Triangle::bars(p, d) * Triangle::opening_stiffness(p, d) * turned * turned;
  }
};

struct OpeningGiven : Opening {
  static Status tile(const Family<Triangle>& family, netloft_tile& t) {
    return Opening::tile(family.lanes(t).H, family.lanes(t), t);
  }
};

/// The term with H = 12 EI/a, (5).
struct OpeningOfTwines : Opening {
  static Status tile(const Family<Triangle>& family, netloft_tile& t) {
    return Opening::tile(family.lanes(t).H_of_EI, family.lanes(t), t);
  }
};

}  // namespace netloft::priour
