// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/convergence.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// If the ratio of successive residuals is below this value, the iteration still converges. The value is
// chosen: an iteration that converges, even if only linearly, halves the residual in a step, whereas rounding
// errors go up and down.
constexpr double kRealReduction = 0.5;

}  // namespace

Convergence convergence_of(const Imbalance& i, double tolerance) {
  const double matters = kMatters * i.load;
  if (!std::isfinite(i.load)) return Convergence::none;
  if (!i.is_driven && i.load <= i.rounding && i.residual <= i.rounding)  // (4)
    return i.residual <= tolerance * i.load ? Convergence::within_tolerance : Convergence::at_round_off;
  if (!i.is_in_time && !(i.rounding <= matters)) return Convergence::none;            // (3)
  if (i.residual <= tolerance * i.load) return Convergence::within_tolerance;         // (1)
  if (i.residual <= std::min(i.rounding, matters)) return Convergence::at_round_off;  // (2)
  return Convergence::none;
}

bool may_stop(Convergence c, double residual, double residual_before) {
  if (c == Convergence::at_round_off) return !(residual < kRealReduction * residual_before);
  return c == Convergence::within_tolerance;
}

bool has_nothing_to_gain(const Imbalance& i, double gain, double size) {
  const double matters = kMatters * i.load;
  return std::isfinite(i.load) && i.rounding <= matters && i.residual <= matters &&
         gain <= kTolerance * i.load * size;
}

}  // namespace netloft
