// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {

/// The hanging panel of cells × cells, across a current of `speed` [m/s].
Scene panel_in_current(int cells, double speed);

/// A tangent of it, out of balance as in an
/// iteration, plus `shift` times the linear stiffness.
TestMatrix tangent_of_panel(int cells, double speed, MatrixKind kind, double shift, Registry& registry);

}  // namespace netloft
