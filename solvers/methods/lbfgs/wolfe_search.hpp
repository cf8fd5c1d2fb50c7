// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

namespace netloft::lbfgs {

/// A value φ(t) and a slope φ'(t) of a function along a line. `value` is infinite if φ is not defined at t.
struct Sample {
  double t = 0, value = 0, slope = 0;
};

/// Finds a t > 0 at which φ is lower and flatter than at 0; φ'(0) must be negative.
///   φ(t) ≤ φ(0) + c₁ t φ'(0)                                                             (1)
///   |φ'(t)| ≤ c₂ |φ'(0)|                                                                 (2)
///   φ'(t) ≤ (2 c₁ − 1) φ'(0)   in place of (1) where |φ(t) − φ(0)| ≤ noise              (3)
/// (1), (2): the strong Wolfe conditions, by bracketing and zoom as in J. Nocedal and S. J. Wright,
/// "Numerical Optimization", 2nd ed., Springer 2006, alg. 3.5 and 3.6. (3): W. W. Hager and H. Zhang, SIAM J.
/// Optim. 16 (2005) 170-192, eq. 4.1: near a minimum, changes of φ have no significant digits, but φ' still
/// has some. For a parabola, (3) and (1) are equivalent.
struct LineSearch {
  double decrease = 1e-4, curvature = 0.9;  // c₁ < ½, c₁ < c₂ < 1
  double noise = 0;                         // values that differ by less cannot be told apart
  int most_samples = 30;

  /// `sample(t)` returns φ and φ' at t. The returned sample is the last one taken; it satisfies (1) or (3),
  /// and (2) unless the limit of samples was reached. Returns nullopt if no t lowers φ.
  template <class Function>
  std::optional<Sample> find(const Sample& start, double first, Function&& sample) const {
    Sample low = start;          // lowest sample that satisfies (1) or (3)
    std::optional<Sample> high;  // a sample such that a suitable t is between it and `low`
    double t = first;
    for (int i = 0; i < most_samples; ++i, t = high ? between(low, *high) : kStretch * low.t) {
      const Sample at = sample(t);
      if (!lowers(start, at) || at.value > low.value + noise) {
        high = at;
        continue;
      }
      if (std::abs(at.slope) <= curvature * -start.slope) return at;  // (2)
      if (at.slope * (high ? high->t - low.t : 1) >= 0) high = low;
      low = at;
    }
    if (low.t == 0) return std::nullopt;
    return sample(low.t);
  }

 private:
  static constexpr double kStretch = 4;
  /// Distance of the next sample from the ends of the interval, as a fraction of its length.
  static constexpr double kMargin = 0.1;

  bool lowers(const Sample& start, const Sample& at) const {
    return at.value <= start.value + decrease * at.t * start.slope ||  // (1)
           (std::abs(at.value - start.value) <= noise &&
            at.slope <= (2 * decrease - 1) * start.slope);  // (3)
  }

  double between(const Sample& a, const Sample& b) const {
    const double width = b.t - a.t;
    const double share = (std::abs(a.value - b.value) <= noise ? secant(a, b) : cubic(a, b)) / width;
    return a.t + width * (share > 0 ? std::clamp(share, kMargin, 1 - kMargin) : kMargin);
  }
  /// Distance from a to the zero of a linear slope.
  static double secant(const Sample& a, const Sample& b) {
    return -a.slope * (b.t - a.t) / (b.slope - a.slope);
  }
  /// Distance from a to the minimum of the cubic through values and slopes: Nocedal and Wright, eq. 3.59.
  static double cubic(const Sample& a, const Sample& b) {
    const double width = b.t - a.t;
    const double d1 = a.slope + b.slope - 3 * (b.value - a.value) / width;
    const double d2 = std::copysign(std::sqrt(d1 * d1 - a.slope * b.slope), width);
    return width * (1 - (b.slope + d2 - d1) / (b.slope - a.slope + 2 * d2));
  }
};

}  // namespace netloft::lbfgs
