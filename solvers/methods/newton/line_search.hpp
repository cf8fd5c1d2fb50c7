// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace netloft::newton {

/// A merit function along a line: m(t) and m'(t).
struct Sample {
  double t = 0, value = 0, slope = 0;
};

/// Least step t that is tried, the square root of the machine's epsilon: such a step changes only the lower
/// half of the digits of u.
inline constexpr double kShortest = 0x1p-26;
/// Step t for second derivatives of r by differences. The square root of kShortest balances the rounding of r
/// and the error of the difference.
inline constexpr double kDifference = 0x1p-13;

/// How far a search along a line refines its bracket.
struct Refinement {
  double margin = 0;  // least distance of a new t from each end, as a fraction of the bracket
  int most = 0;       // how many more t to evaluate, once an acceptable t is found

  double within(double fraction) const { return std::clamp(fraction, margin, 1 - margin); }
};

/// A search along a line for a t that lowers the merit enough.
struct LineSearch {
  double flatness = 0;  // fraction of the slope at the start that m' may keep
  Refinement refinement = {};

  /// The best t in (0, 1] found:
  ///   m(t) ≤ m(0), and |m'(t)| ≤ η |m'(0)|, or t = 1 and m'(1) < 0, or refinements spent      (L)
  /// η is `flatness`. The search uses secants of m' within a bracket, and parabolas while m is too high
  /// (Nocedal & Wright 2006, ch. 3). There is no condition of sufficient decrease: the usual one, with 1e-4
  /// of the slope, did not change a bit of the results of 537 hard cases. `start` is m at t = 0; `merit(t)`
  /// returns a Sample, or nullopt if forces are undefined at t, which is then shortened. Returns nullopt if
  /// no t is found.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start) const {
    std::optional<Sample> best, high;
    Sample low = start;
    int spent = 0;
    for (double t = 1; t >= kShortest;) {
      const std::optional<Sample> here = merit(t);
      if (!here) {
        t = low.t + refinement.margin * (t - low.t);
        continue;
      }
      const bool falls = here->value <= start.value;
      if (falls && (!best || here->value < best->value)) best = here;
      if (falls && (is_flat(*here, start) || (here->slope < 0 && t == 1))) return here;
      if (best && ++spent > refinement.most) return best;
      if (falls && here->slope < 0)
        low = *here;
      else
        high = here;
      if (!high) return best;
      t = low.t + refinement.within(next_fraction(low, *high)) * (high->t - low.t);
    }
    return best;
  }

 private:
  bool is_flat(const Sample& s, const Sample& start) const {
    return std::abs(s.slope) <= flatness * std::abs(start.slope);
  }
  static double next_fraction(const Sample& low, const Sample& high) {
    const double length = high.t - low.t;
    if (high.slope > 0 && high.value <= low.value) return -low.slope / (high.slope - low.slope);
    const double rise = high.value - low.value - low.slope * length;
    return rise > 0 ? -low.slope * length / (2 * rise) : 0.5;
  }
};

/// A search along a line for a t at which the merit m is flat, for use where rounding hides the changes of m
/// but not the slope of m.
struct SlopeSearch {
  double noise = 0;     // rounding error of m, by which m may rise
  double flatness = 0;  // fraction of the slope at the start that m' may keep
  Refinement refinement = {};

  /// The first t in (0, 1] found:
  ///   m(t) ≤ m(0) + noise, and |m'(t)| ≤ η |m'(0)|, or t = 1 and m'(1) ≤ 0                      (S)
  /// by secants and halves of a bracket (the approximate Wolfe conditions of W. W. Hager and H. Zhang, SIAM
  /// J. Optim. 16, 2005). `merit` and `start` are those of LineSearch. Returns nullopt if no t is found, or
  /// at the first t at which forces are undefined.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start) const {
    Sample last = start, here = start;
    for (double low = 0, high = 1, t = 1; high - low > kShortest;) {
      const std::optional<Sample> there = merit(t);
      if (!there) return {};
      const bool is_uphill = there->value > start.value + noise, is_done = t == 1 && there->slope <= 0;
      if (!is_uphill && (is_done || std::abs(there->slope) <= flatness * std::abs(start.slope))) return there;
      last = std::exchange(here, *there);
      (is_uphill || here.slope > 0 ? high : low) = t;
      t = is_uphill ? 0.5 * (low + high) : next(last, here, low, high);
    }
    return {};
  }

 private:
  /// The zero of the secant through the last two samples, which is exact once both are beyond a kink; the
  /// middle of the bracket if that zero is outside it.
  double next(const Sample& last, const Sample& here, double low, double high) const {
    const double t = here.t - here.slope * (here.t - last.t) / (here.slope - last.slope),
                 margin = refinement.margin * (high - low);
    return t > low + margin && t < high - margin ? t : 0.5 * (low + high);
  }
};

}  // namespace netloft::newton
