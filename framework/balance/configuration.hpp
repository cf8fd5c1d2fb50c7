// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/moving_state.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace netloft {

/// A step in time as a problem in u: rates follow u, everything else is known.
///   F(t, u, v₀ + cv u, a₀ + ca u) = 0                                            (1)
struct StepProblem {
  double t;
  std::span<const double> v0, a0;
  double cv, ca;
  std::span<const double> mass;  // of each unknown [kg]: ca times it is a stiffness that rounding meets
  MovingState* state;            // where positions and rates of the moment are kept
  double least_load;             // [N] that tolerances are a part of, at the least
  /// The step whose mean forces F has (netloft_motion::solve_between): u is then its middle, and `after` is
  /// kept up with it. Null: forces at u.
  struct Ends {
    StepEnds ends;
    double begin = 0, end = 0;                 // [s]
    std::vector<double> u, x_before, x_after;  // at the beginning; over all dofs
  };
  Ends* between = nullptr;
};

/// Where the nodes are at displacements u of the unknowns, and how they move: at rest, displaced from the
/// start; in a step in time (1), with rates that follow u; or displaced from positions next to the
/// equilibrium, of which differences then have the digits that positions round off.
class Configuration {
 public:
  explicit Configuration(Assembler& assembler) : assembler_(assembler), x_(assembler.start()) {}

  /// From now on u is that of a step, until the next.
  void begin(const StepProblem& step);
  /// From now on u counts from positions `base`. Not where bodies carry nodes.
  void count_from(std::vector<double> base);
  /// Lets nodes be where u [m] has them.
  void place(std::span<const double> u);

  /// Over all degrees of freedom, as u was last placed [m].
  const std::vector<double>& x() const { return x_; }
  /// What x rounds off [m]; empty where displacements count from the start.
  const std::vector<double>& low_digits() const { return x_low_; }
  const Kinematics& motion() const { return motion_; }
  /// Of the step whose mean forces are asked for; null: forces are those at u.
  const StepEnds* between() const { return step_.between ? &step_.between->ends : nullptr; }
  bool is_in_time() const { return step_.state != nullptr; }
  /// Displacements from the start of a scene at rest.
  bool is_from_start() const { return base_.empty() && !is_in_time(); }
  /// Loads of a motion that tolerances are a part of, at the least [N].
  double least_load() const { return step_.least_load; }
  /// What the inertia of an unknown adds to its stiffness [N/m].
  double stiffness_of_inertia(std::size_t unknown) const {
    return is_in_time() ? step_.ca * step_.mass[unknown] : 0;
  }
  /// Length whose last digit is the rounding of an unknown that has the coordinate x: the coordinate, or the
  /// difference of two, where positions keep all their digits [m].
  double rounded_length(double x) const { return base_.empty() ? std::abs(x) : base_extent_; }

 private:
  void place_end(std::span<const double> u);

  Assembler& assembler_;
  StepProblem step_{};
  Kinematics motion_;
  std::vector<double> x_, v_, a_;
  std::vector<double> base_, x_low_;  // empty: u counts from the start
  double base_extent_ = 0;            // of elements there [m]
};

}  // namespace netloft
