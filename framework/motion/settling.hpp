// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

namespace netloft {

/// Finds a static equilibrium by dynamics: integrates in time with the artificial damping −c M v until the
/// residual is within the tolerance. The host calls it like any solver, with the same statistics and verdict.
struct Settling {
  AssembledScene scene;
  StepMethods methods;
  Limits limits;  // limits for the solution of one step
  MarchSettings march;
  std::int64_t steps_per_check = 20;  // steps between evaluations of the static residual
  /// Describes this object as a solver; its parameters are a pointer to this object.
  SolverType as_solver() const;
};

}  // namespace netloft
