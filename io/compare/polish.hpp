// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/case.hpp"

namespace netloft::io {

/// An answer brought down to the round-off floor, as far as the host's own Newton steps bring it.
struct Polished {
  std::vector<double> x, u, residuals;  // as in Solution
  double residual = 0, load = 0;        // recomputed there, with what x rounds off [N]
  double energy = 0;                    // [J]
  /// Largest nodal move of the last step, which lowered the residual no more, or the last digit of x: what x
  /// is known to [m].
  double uncertainty = std::numeric_limits<double>::quiet_NaN();
  bool evaluated = false;  // false: there are no forces at the answer
};

/// Takes Newton steps from displacements `u` for as long as they lower the largest nodal residual. It is a
/// matter of digits, not of finding an equilibrium: who found `u` has chosen which one. `fresh` has solved
/// nothing.
Polished polish(Case& fresh, const std::vector<double>& u);

/// CPU seconds of one numeric factorisation of the exact tangent at `u`, the least of several: what work is
/// counted in when seconds of one machine mean nothing on another.
double factorisation_seconds(Case& fresh, const std::vector<double>& u);

}  // namespace netloft::io
