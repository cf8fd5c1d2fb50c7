// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/newton/line_search.hpp"

namespace netloft::newton {

/// How far to go along a line that curves downwards, where nothing tells how far it does. Falls, at t:
///   m'(t) < 0 and m(t) ≤ m(0) + noise                                                       (D)
/// The largest t found that falls, by t that grow until one does not, and secants of m' between.
struct DescentSearch {
  double first_t = 1e-3, shortest = 1e-7, longest = 10;
  double growth = 4, shrinkage = 0.1;  // of t while (D) holds; while it has not held yet
  int refinements = 4;                 // evaluations spent once (D) has failed
  double least = 0.1, most = 0.9;      // a new t within its bracket

  /// `merit(t)` gives a Sample, or nothing where elements are not defined. Empty: m does not fall at all.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start, double noise) const {
    const auto falls = [&](const Sample& s) { return s.slope < 0 && s.value <= start.value + noise; };
    Sample low = start;
    std::optional<Sample> high;
    const auto has_fallen = [&] { return low.t > start.t; };
    for (double t = first_t; t > shortest && t < longest && !high; t *= has_fallen() ? growth : shrinkage) {
      const std::optional<Sample> here = merit(t);
      if (here && falls(*here))
        low = *here;
      else if (has_fallen())
        high = here ? *here : as_steep_uphill(t, low);
    }
    for (int i = 0; i < refinements && high; ++i) {
      const double fraction = std::clamp(low.slope / (low.slope - high->slope), least, most);
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
