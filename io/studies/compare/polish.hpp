// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::studies {

/// An answer improved to the round-off floor by Newton steps of the host.
struct Polished {
  std::vector<double> x, u, residuals;  // as in Solution
  double residual = 0, load = 0;        // recomputed at x, with its low-order part [N]
  double energy = 0;                    // [J]
  /// The accuracy of x [m]: the largest displacement of a node in the last step, which is the first that no
  /// longer lowered the residual, or the rounding unit of x if that is larger.
  double uncertainty = std::numeric_limits<double>::quiet_NaN();
  bool evaluated = false;  // false: forces cannot be evaluated at the answer
};

/// Takes Newton steps from displacements `u` for as long as they lower the largest nodal residual. They
/// improve the accuracy only: the solver that found `u` has decided which equilibrium it is. `fresh` must not
/// have solved anything.
Polished polish(runs::PreparedScene& fresh, const std::vector<double>& u);

/// CPU seconds of one numeric factorisation of the exact tangent at `u`, the least of several. It is a unit
/// of work that can be compared between machines.
double factorisation_seconds(runs::PreparedScene& fresh, const std::vector<double>& u);

}  // namespace netloft::studies
