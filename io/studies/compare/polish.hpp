// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

namespace netloft::studies {

/// A solver's answer, improved by Newton steps until only round-off is left.
struct Polished {
  std::vector<double> x, u, residuals;  // x, u, residuals: as in Solution
  double residual = 0, load = 0;        // largest residual and load of a node at x [N]
  double energy = 0;                    // [J]
  /// The accuracy of x [m]: the largest displacement of a node in the first step that did not lower the
  /// residual, or the rounding unit of x, whichever is larger.
  double uncertainty = std::numeric_limits<double>::quiet_NaN();
  bool evaluated = false;  // false: forces cannot be evaluated at the answer
};

/// Takes Newton steps from displacements `u`, the answer of a solver, as long as they lower the largest nodal
/// residual. These steps stay at the equilibrium that the solver found, and only improve its accuracy.
/// `fresh` is a prepared scene that has not been solved yet.
Polished polish(runs::PreparedScene& fresh, const std::vector<double>& u);

/// Processor time of one numeric factorisation of the exact tangent at `u` [s], the least of several
/// measurements. It is used as a unit of work that makes different machines comparable.
double factorisation_seconds(runs::PreparedScene& fresh, const std::vector<double>& u);

}  // namespace netloft::studies
