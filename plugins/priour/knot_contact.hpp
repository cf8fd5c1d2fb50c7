// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/angle.hpp"

namespace netloft::priour {

/// Knots that touch: a mesh cannot close further than its knots let it, nor open further than that the other
/// way. A stiff penalty, twice continuously differentiable and without a direction to lose at α = 0:
///   α_k = atan(k/(2a)),  c_k = cos 2α_k                    half angle at which knots of size k touch     (1)
///   y = (|c| − c_k)/(1 − c_k), at least 0                  0 at touch, 1 with the twines side by side    (2)
///   E = (|d|/2) K y³,  K = EA a (1 − c_k)                                                               (3)
/// c = cos 2α by angle (1); a [m] the bar. A mesh under tension T closes with 2 T a sin α per knot against
/// (12 K/(1 − c_k)) y² sin α cos α: it rests at y = √(T/6EA), about 4 % above 1 − c_k at T = EA/100, and the
/// ratio of the two only grows as it closes: no tension below 6 EA pushes it through. Source: derived for
/// this program; the limit (1) is that of Priour's programs.
struct KnotContact {
  /// y of (2): 0 without contact.
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
