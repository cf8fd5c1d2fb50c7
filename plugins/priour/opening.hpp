// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/angle.hpp"

namespace netloft::priour {

/// Resistance of the meshes to opening: a couple H(α−α₀) on each of the two twines of each knot.
///   E = (|d|/2) H (α−α₀)²,  α = ½ ∠(Û, V̂) ∈ [0, π/2]                                            (1)
///   dE/dc = −(|d|/2) H (α−α₀)/s                                                                  (2)
///   d²E/dc² = (|d|/2) H [½ − (α−α₀) c/s]/s²              c = cos 2α, s = sin 2α by angle (1)      (3)
///   α² = Σ_k A_k e^k,  A_k = 2^(k−1) / (k² C(2k, k)),  e = 1 − c                                  (4)
/// H [N·m/rad] is given, or H = 12 EI/a from the bending stiffness EI of the twines (5). Twines are clamped
/// at the knots, and each half of a bar of length a [m] is a cantilever under the shear of the other twine,
/// at small angles. α₀ [rad] half angle of the unloaded mesh. For α₀ = 0 the energy is smooth for closed
/// meshes, where (2), (3) are 0/0: (4) replaces them below e = kSeries. E has a cusp at α = 0 (unless α₀ = 0)
/// and at α = π/2: there, states with s < kCusp are outside the domain; knot contact prevents them. Source:
/// the trawl-gear paper, eq. (3); Priour 2001. Other programs use half of (1), or 2 cos α times the couple.
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

/// The term with H given.
struct OpeningGiven : Opening {
  static Status tile(const Family<Triangle>& family, netloft_tile& t) {
    return Opening::tile(family.lanes(t).H, family.lanes(t), t);
  }
};

/// The term with H by (5).
struct OpeningOfTwines : Opening {
  static Status tile(const Family<Triangle>& family, netloft_tile& t) {
    return Opening::tile(family.lanes(t).H_of_EI, family.lanes(t), t);
  }
};

}  // namespace netloft::priour
