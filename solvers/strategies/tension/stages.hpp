// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/tension/mixed_newton.hpp"

namespace netloft::tension {

/// Brings a scene from a drawing to its equilibrium over softer ones: at first with a small factor on all
/// stiffness, then with every part as stiff as a multiple of its own tension, then as it is; tensions are
/// unknowns all along (mixed_newton.hpp). A cap that is the same for all parts leaves what carries little as
/// stiff as it was; this one strains all parts alike.
class Stages {
 public:
  /// plugin.cpp says what each is and where it comes from.
  struct Parameters : MixedNewton::Parameters {
    double softest = 0;          // first factor
    double ratio = 0, last = 0;  // multiples of the tension
    double damping = 0, turn = 0, tolerance = 0;
    std::int64_t iterations = 0;
  };

  Stages(const Parameters& parameters, netloft_members& members);

  /// From u to where it ends: the ending of the last stage, or of the one in which the host gave up.
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
