// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace netloft {

enum class MatrixKind { none, exact, convex, metric };

/// The motion of a scene during an evaluation: velocities and accelerations over all dofs (nullptr at rest),
/// the factors of the matrix cu ∂r/∂x + cv ∂r/∂v + ca ∂r/∂a, and, if known, the digits that rounding removes
/// from the positions.
struct Kinematics {
  double time = 0;                          // [s]
  const double *v = nullptr, *a = nullptr;  // [m/s], [m/s²]
  double cu = 1, cv = 0, ca = 0;
  const double* x_low = nullptr;  // over all dofs: positions are x + x_low [m]
};

/// The ends of a step in time over which forces are averaged (netloft_motion::solve_between). Positions are
/// over all dofs [m].
struct StepEnds {
  const double *before = nullptr, *after = nullptr;
  double length = 0;   // length h of the step [s]
  double damping = 0;  // damping χ of members, (3) of mean_of_members.hpp
};

/// The sums that an evaluation computes. A sum that is nullptr or `none` is not computed.
struct Request {
  double* energy = nullptr;        // the energy, one number [J]
  bool conservative_only = false;  // leave out nonconservative forces; the residual is then the gradient
  std::uint32_t without = 0;       // leave out terms with any of these traits
  double* residual = nullptr;      // over all dofs, +dE/dx [N]: of unknowns, then of held dofs (reactions)
  double* gradient = nullptr;      // residual of the conservative forces, over all dofs [N]
  MatrixKind matrix = MatrixKind::none;
  double* values = nullptr;  // values of the matrix, Assembler::value_slots() long [N/m]
  Kinematics motion = {};
  const StepEnds* between = nullptr;  // the step whose mean forces are computed, with x in its middle;
                                      // nullptr: forces at x
};

}  // namespace netloft
