// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/moving_state.hpp"
#include "framework/motion/march_state.hpp"

namespace netloft {

/// The state of a motion at an output time, which is the end of a step or between its ends.
class ShownState {
 public:
  ShownState(const Assembler& assembler, double mass_damping) : moving_(assembler, mass_damping) {}

  void show(const MarchState& at);
  /// Shows the state at a time t within a step, by cubic interpolation of the positions and velocities at
  /// both ends of the step.
  void show_between(const MarchState& begin, const MarchState& end, double t);

  std::span<const double> u() const { return u_; }
  /// Positions and velocities over all degrees of freedom [m], [m/s].
  const std::vector<double>& x() const { return moving_.x(); }
  const std::vector<double>& v() const { return moving_.v(); }

 private:
  MovingState moving_;
  std::vector<double> u_;
};

}  // namespace netloft
