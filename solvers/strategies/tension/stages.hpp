// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/mixed_newton.hpp"

namespace netloft::tension {

/// Brings a scene from a drawing to its equilibrium through softer scenes: first with a small factor on all
/// stiffness, then with the stiffness of every part limited to a multiple of its tension, then unchanged.
/// Tensions are unknowns in all stages (mixed_newton.hpp). A common cap for all parts would not soften parts
/// that carry little; this one strains all parts alike.
class Stages {
 public:
  /// The options, which strategies.cpp explains with their sources.
  struct Parameters : MixedNewton::Parameters {
    double softest = 0;          // first factor
    double ratio = 0, last = 0;  // multiples of the tension
    double damping = 0, turn = 0, tolerance = 0;
    std::int64_t iterations = 0;
  };

  Stages(const Parameters& parameters, netloft_members& members);

  /// Solves from u, which it changes. Returns the ending of the last stage, or of the stage that the host
  /// ended.
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
