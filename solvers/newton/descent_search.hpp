// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/newton/line_search.hpp"

namespace netloft::newton {

/// How far to go along a line that curves downwards, where nothing tells how far it does:
///   m'(t) < 0 and m(t) ≤ m(0) + noise up to the t sought, and not far beyond                 (1)
/// by steps that grow until (1) fails, and secants of m' between.
struct DescentSearch {
  double first = 1e-3, shortest = 1e-7, longest = 10;  // t
  double growth = 4, shrinkage = 0.1;                  // of t while (1) holds, while it never did
  int refinements = 4;                                 // evaluations spent once (1) has failed
  double least = 0.1, most = 0.9;                      // a new t within its bracket

  /// `merit(t)` gives a Sample, or nothing where there are no forces. Empty: m does not fall at all.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start, double noise) const {
    Sample low = start;
    std::optional<Sample> high;
    for (double t = first; t > shortest && t < longest && !high; t *= low.t > start.t ? growth : shrinkage) {
      const std::optional<Sample> here = merit(t);
      if (here && here->slope < 0 && here->value <= start.value + noise)
        low = *here;
      else if (low.t > start.t)
        high = here ? here : Sample{t, start.value, -low.slope};
    }
    for (int i = 0; i < refinements && high; ++i) {
      const double share = std::clamp(low.slope / (low.slope - high->slope), least, most);
      const std::optional<Sample> here = merit(low.t + share * (high->t - low.t));
      if (!here) break;
      (here->slope < 0 && here->value <= start.value + noise ? low : *high) = *here;
    }
    return low.t > start.t ? std::optional(low) : std::nullopt;
  }
};

}  // namespace netloft::newton
