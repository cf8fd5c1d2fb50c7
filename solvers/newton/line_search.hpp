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

/// What a step along a line must do.
struct LineSearch {
  double decrease = 1e-4;          // fraction of the slope at the start by which m must fall
  double flatness = 0.2;           // fraction of the slope at the start that m' may keep
  double shortest = 1e-4;          // t below which none is tried
  int refinements = 4;             // evaluations spent on flatness once m has fallen
  double least = 0.1, most = 0.9;  // a new t within its bracket

  /// The best t in (0, 1] found:
  ///   m(t) ≤ m(0) + c t m'(0), and |m'(t)| ≤ η |m'(0)|, or t = 1 and m'(1) < 0, or refinements spent   (L)
  /// with c `decrease` and η `flatness`, by secants of m' within a bracket, by parabolas while m is too high
  /// (Nocedal & Wright 2006, ch. 3). `start` is m at t = 0; `merit(t)` gives a Sample, or nothing where there
  /// are no forces: t is then shortened. Empty: no t will do.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start) const {
    std::optional<Sample> best, high;
    Sample low = start;
    int spent = 0;
    for (double t = 1; t >= shortest;) {
      const std::optional<Sample> here = merit(t);
      if (!here) {
        t = low.t + 0.25 * (t - low.t);
        continue;
      }
      const bool falls = here->value <= start.value + decrease * t * start.slope;
      if (falls && (!best || here->value < best->value)) best = here;
      if (falls && (is_flat(*here, start) || (here->slope < 0 && t == 1))) return here;
      if (best && ++spent > refinements) return best;
      if (falls && here->slope < 0)
        low = *here;
      else
        high = here;
      if (!high) return best;
      t = low.t + next_share(low, *high) * (high->t - low.t);
    }
    return best;
  }

 private:
  bool is_flat(const Sample& s, const Sample& start) const {
    return std::abs(s.slope) <= flatness * std::abs(start.slope);
  }
  double next_share(const Sample& low, const Sample& high) const {
    const double length = high.t - low.t;
    if (high.slope > 0 && high.value <= low.value)
      return std::clamp(-low.slope / (high.slope - low.slope), least, most);
    const double rise = high.value - low.value - low.slope * length;
    return std::clamp(rise > 0 ? -low.slope * length / (2 * rise) : 0.5, least, 0.5);
  }
};

/// A step along a line where rounding hides how m changes, and its slope still has significant digits.
struct SlopeSearch {
  double noise = 0;        // by so much m may rise: rounding
  double flatness = 0.1;   // fraction of the slope at the start that m' may keep
  double shortest = 1e-9;  // bracket that is not divided any more

  /// The first t in (0, 1] found:
  ///   m(t) ≤ m(0) + noise, and |m'(t)| ≤ η |m'(0)|, or t = 1 and m'(1) ≤ 0                      (S)
  /// by secants and halves of a bracket (the approximate Wolfe conditions of W. W. Hager and H. Zhang, SIAM
  /// J. Optim. 16, 2005). `merit` and `start` as above. Empty: no t will do, or one has no forces.
  template <class Merit>
  std::optional<Sample> operator()(Merit&& merit, const Sample& start) const {
    Sample last = start, here = start;
    for (double low = 0, high = 1, t = 1; high - low > shortest;) {
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
  /// By a secant through the last two, which behind a kink is exact; else the middle.
  static double next(const Sample& last, const Sample& here, double low, double high) {
    const double t = here.t - here.slope * (here.t - last.t) / (here.slope - last.slope),
                 margin = 0.01 * (high - low);
    return t > low + margin && t < high - margin ? t : 0.5 * (low + high);
  }
};

}  // namespace netloft::newton
