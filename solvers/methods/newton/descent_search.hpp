// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/methods/newton/line_search.hpp"

namespace netloft::newton {

/// How far to go along a line that curves downwards, where nothing tells how far it does. t = 1 is as far as
/// the direction at t = 0 says something: an element. Falls, at t:
///   m'(t) < 0 and m(t) ≤ m(0) + noise                                                       (D)
/// The largest t found that falls: a small t is halved until one falls, or doubled until one does not, and
/// secants of m' go on between. t stays below
///   1/margin:                                                                               (E)
/// a longer bracket keeps its new points, `margin` of it from either end, farther than 1 from the start, and
/// what is nearer would not be seen.
struct DescentSearch {
  Refinement refinement = {};
  double longest() const { return 1 / refinement.margin; }  // (E)

  /// `merit(t)` gives a Sample, or nothing where elements are not defined. Empty: m does not fall at all.
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
  /// Stands for a t without forces, so that the secant halves the bracket.
  static Sample as_steep_uphill(double t, const Sample& low) { return {t, low.value, -low.slope}; }
};

}  // namespace netloft::newton
