// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::studies {

/// An answer brought down to the round-off floor by the host's own Newton steps.
struct Polished {
  std::vector<double> x, u, residuals;  // as in Solution
  double residual = 0, load = 0;        // recomputed there, with the low-order part of x [N]
  double energy = 0;                    // [J]
  /// Largest nodal move of the last step, the first that no longer lowered the residual, or the rounding unit
  /// of x if that is larger: the accuracy to which x is known [m].
  double uncertainty = std::numeric_limits<double>::quiet_NaN();
  bool evaluated = false;  // false: forces cannot be evaluated at the answer
};

/// Takes Newton steps from displacements `u` for as long as they lower the largest nodal residual. This gains
/// accuracy only: which equilibrium is approached was decided by the solver that found `u`. `fresh` must not
/// have solved anything.
Polished polish(runs::PreparedScene& fresh, const std::vector<double>& u);

/// CPU seconds of one numeric factorisation of the exact tangent at `u`, the least of several. It serves as
/// the unit of work that can be compared between machines.
double factorisation_seconds(runs::PreparedScene& fresh, const std::vector<double>& u);

}  // namespace netloft::studies
