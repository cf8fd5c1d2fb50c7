// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/methods/newton/line_search.hpp"

namespace netloft::newton {

/// A search along a line of negative curvature, where no model predicts the best length of a step. m is the
/// merit ((3) of newton.hpp), and t = 1 moves the farthest node by one element. A step t is accepted if
///   m'(t) < 0 and m(t) ≤ m(0) + noise                                                       (D)
/// A small first t is halved until it is accepted. Then t is doubled until it is refused or reaches its limit
///   1/margin                                                                                (E)
/// Secants of m' refine the bracket between the last accepted and the first refused t. The search returns the
/// largest accepted t.
struct DescentSearch {
  Refinement refinement = {};
  double longest() const { return 1 / refinement.margin; }  // limit (E) of t

  /// `merit(t)` gives a Sample, or nullopt if forces are undefined at t. Returns nullopt if no t is accepted.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start, double noise) const {
    const auto falls = [&](const Sample& s) { return s.slope < 0 && s.value <= start.value + noise; };
    Sample low = start;
    std::optional<Sample> high;
    const auto has_fallen = [&] { return low.t > start.t; };
    for (double t = kDifference; t > kShortest && t < longest() && !high; t *= has_fallen() ? 2 : 0.5) {
      const std::optional<Sample> here = merit(t);
      if (here && falls(*here))
        low = *here;
      else if (has_fallen())
        high = here ? *here : as_steep_uphill(t, low);
    }
    for (int i = 0; i < refinement.most && high; ++i) {
      const double fraction = refinement.within(low.slope / (low.slope - high->slope));
      const std::optional<Sample> here = merit(low.t + fraction * (high->t - low.t));
      if (!here) break;
      if (falls(*here))
        low = *here;
      else
        high = here;
    }
    return has_fallen() ? std::optional(low) : std::nullopt;
  }

 private:
  /// The sample for a t at which forces are undefined. Its slope is chosen such that the secant halves the
  /// bracket.
  static Sample as_steep_uphill(double t, const Sample& low) { return {t, low.value, -low.slope}; }
};

}  // namespace netloft::newton
