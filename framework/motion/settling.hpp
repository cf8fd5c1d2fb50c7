// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

namespace netloft {

/// A static equilibrium by dynamics: an integrator with the artificial damping −c M v, until the residual is
/// within the tolerance. The host calls it as a solver, so that statistics and verdict are those of any
/// solver.
struct Settling {
  AssembledScene scene;
  StepMethods methods;
  Limits limits;  // of the problem of one step
  MarchSettings march;
  std::int64_t steps_per_check = 20;  // steps between evaluations of the static residual
  /// The descriptor of this as a solver; its parameters are `this`.
  SolverType as_solver() const;
};

}  // namespace netloft
