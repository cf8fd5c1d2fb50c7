// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"

namespace netloft {

/// A static equilibrium by dynamics: an integrator with artificial damping −c M v until what is left of the
/// residual is no more than the tolerance allows. It stands before the host as any other solver, so that the
/// statistics and the verdict are the same.
struct Settling {
  AssembledScene scene;
  StepMethods methods;
  Limits limits;  // of one step's problem
  MarchSettings march;
  std::int64_t look_every = 20;  // steps between looks at the residual

  /// The descriptor; `this` is what its parameters are.
  SolverType as_solver() const;
};

}  // namespace netloft
