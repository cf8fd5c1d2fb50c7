// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/moving_state.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace netloft {

/// A step in time as an equation for the displacements u. With v₀, a₀, cv and ca from the time scheme,
/// velocity and acceleration are linear in u:
///   F(t, u, v₀ + cv u, a₀ + ca u) = 0                                            (1)
struct StepProblem {
  double t;
  std::span<const double> v0, a0;
  double cv, ca;
  std::span<const double> mass;  // mass of each unknown [kg]; ca × mass acts like a stiffness
  MovingState* state;            // receives positions and rates
  double least_load;             // lower bound of the load to which tolerances are relative [N]
  /// The two ends of the step, for schemes that use the mean force over the step as F
  /// (netloft_motion::solve_between); u is then the displacement at the midpoint of the step, and `after`
  /// follows from u. If nullptr, F is the force at u.
  struct Ends {
    StepEnds ends;
    double begin = 0, end = 0;                 // [s]
    std::vector<double> u, x_before, x_after;  // u at the beginning [m]; x over all dofs [m]
  };
  Ends* between = nullptr;
};

/// Positions and rates of the nodes at displacements u of the unknowns. In a step in time (1), the rates
/// follow from u. At rest, u is relative to the start of the scene or to positions near the equilibrium. If
/// it is relative to positions near the equilibrium, x_low has the digits that rounding removes from the
/// positions x, so that differences of positions are more accurate.
class Configuration {
 public:
  explicit Configuration(Assembler& assembler) : assembler_(assembler), x_(assembler.start()) {}

  /// Begins a step in time: from now on, u are displacements in this step.
  void begin(const StepProblem& step);
  /// Makes displacements u relative to the positions `base` from now on. Not allowed if bodies carry nodes.
  void count_from(std::vector<double> base);
  void place(std::span<const double> u);

  /// Positions over all degrees of freedom after the last call of `place` [m].
  const std::vector<double>& x() const { return x_; }
  /// Digits that rounding removes from the positions x [m]; empty if displacements are relative to the start.
  const std::vector<double>& x_low() const { return x_low_; }
  const Kinematics& motion() const { return motion_; }
  /// The step in time whose mean forces are evaluated; nullptr if forces are evaluated at u.
  const StepEnds* between() const { return step_.between ? &step_.between->ends : nullptr; }
  bool is_in_time() const { return step_.state != nullptr; }
  /// Whether the scene is at rest and displacements are relative to its start.
  bool is_from_start() const { return base_.empty() && !is_in_time(); }
  /// Lower bound of the load to which tolerances are relative, in a motion [N].
  double least_load() const { return step_.least_load; }
  /// Stiffness that the inertia of an unknown adds in a step in time [N/m].
  double stiffness_of_inertia(std::size_t unknown) const {
    return is_in_time() ? step_.ca * step_.mass[unknown] : 0;
  }
  /// The rounding error of the coordinate x of an unknown is proportional to this length [m]: |x|, or the
  /// extent of an element if x_low has the digits that rounding removes.
  double rounded_length(double x) const { return base_.empty() ? std::abs(x) : base_extent_; }

 private:
  void place_end(std::span<const double> u);

  Assembler& assembler_;
  StepProblem step_{};
  Kinematics motion_;
  std::vector<double> x_, v_, a_;
  std::vector<double> base_, x_low_;  // empty: u is relative to the start
  double base_extent_ = 0;            // largest extent of an element at base_ [m]
};

}  // namespace netloft
