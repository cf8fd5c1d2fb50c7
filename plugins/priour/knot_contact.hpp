// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/angle.hpp"

namespace netloft::priour {

/// Contact of knots limits how far a mesh can close, both towards α = 0 and towards α = 90°. The
/// model is a stiff penalty, twice continuously differentiable, also at α = 0:
///   α_k = atan(k/(2a)),  c_k = cos 2α_k                    half angle at which knots of size k touch     (1)
///   y = (|c| − c_k)/(1 − c_k), at least 0                  0 at contact, 1 for a closed mesh             (2)
///   E = (|d|/2) K y³,  K = EA a (1 − c_k)                                                               (3)
/// Here 2α is the angle between the twines, c = cos 2α as in angle.hpp (1), |d|/2 the number of bars of each
/// direction, EA [N] the stiffness of a twine and a [m] the length of a bar. Twines under the tension T close
/// a mesh with the moment 2 T a sin α per knot; contact resists with (12 K/(1 − c_k)) y² sin α cos α.
/// Equilibrium is at y = √(T/6EA), which is about 0.04 at T = EA/100; no tension below 6 EA closes the mesh.
/// Source: derived for this program; the limit (1) is that of Priour's programs.
struct KnotContact {
  /// The depth y of the contact by (2); 0 without contact.
  static double depth(const Triangle::Parameters& p, const Triangle::Data& d, const State<3>& s);
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
  template <class T>
  static T oracle(const Triangle::Parameters& p, const Triangle::Data& d, const Water&,
                  const Points<T, 3>& x) {
    const double touch = Triangle::touching_cosine(p, d);
    const T y = (abs(angle::cosine(d, x)) - touch) / T(1 - touch);
    return y < T(0) ? T(0) : Triangle::bars(p, d) * (p.EA * d.bar_length * (1 - touch)) * y * y * y;
  }
};

}  // namespace netloft::priour
