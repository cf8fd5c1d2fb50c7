// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/mixed_newton.hpp"

namespace netloft::tension {

/// Brings a scene from its initial shape, such as that of a drawing, to equilibrium through softer scenes.
/// First, all stiffnesses are multiplied by a small factor. Then the stiffness of every part is limited to a
/// multiple of its tension, and at the end it is unchanged. Tensions are unknowns in all stages
/// (mixed_newton.hpp). The limit of a part depends on its own tension, because a common limit would not
/// soften parts with little tension.
class Stages {
 public:
  /// The options, which strategies.cpp explains with their sources.
  struct Parameters : MixedNewton::Parameters {
    double softest = 0;          // factor on all stiffness in the first stage
    double ratio = 0, last = 0;  // first and last limit of the stiffness of a part over its tension
    double damping = 0, turn = 0, tolerance = 0;
    std::int64_t iterations = 0;
  };

  Stages(const Parameters& parameters, netloft_members& members);

  /// Solves from u, which it changes. Returns how the last stage ended. If the first stage does not converge,
  /// or if the host stops a stage, no further stage is solved.
  MixedNewton::Ending solve(std::span<double> u);

 private:
  MixedNewton::Stage soft_stage() const;
  MixedNewton::Stage next_stage(double multiple) const;
  MixedNewton::Stage last_stage() const;

  Parameters p_;
  std::size_t parts_;
  MixedNewton newton_;
};

}  // namespace netloft::tension
