// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

namespace netloft {

/// Positions and rates of all degrees of freedom at one moment, computed from those of the unknowns and of
/// the guides (given paths of held nodes). Mass-proportional damping is a force c M v. It equals the inertia
/// force of an acceleration c v, which is therefore added to a.
class MovingState {
 public:
  MovingState(const Assembler& assembler, double mass_damping)
      : assembler_(assembler),
        mass_damping_(mass_damping),
        x_(assembler.start()),
        v_(x_.size()),
        a_(x_.size()) {}

  /// The damping rate c [1/s].
  double mass_damping() const { return mass_damping_; }
  void set(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a) {
    t_ = t;
    assembler_.place(u, x_, t);
    assembler_.move(t, x_, v, a, v_, a_);
    for (std::size_t i = 0; i < a_.size(); ++i) a_[i] += mass_damping_ * v_[i];
  }
  double t() const { return t_; }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& v() const { return v_; }
  /// The motion of the nodes, for an evaluation by the assembler. A matrix is then ∂F/∂u with the derivatives
  /// dv/du = cv and da/du = ca.
  Kinematics motion(double cv = 0, double ca = 0) const {
    return {t_, v_.data(), a_.data(), 1, cv, ca + mass_damping_ * cv};
  }

 private:
  const Assembler& assembler_;
  double mass_damping_, t_ = 0;
  std::vector<double> x_, v_, a_;
};

/// Midpoint of a step whose mean forces the time scheme balances (netloft_motion::solve_between).
struct MeanStep {
  double t = 0;                   // [s]
  std::vector<double> u, v, a;    // state of the unknowns, as the time scheme sets it [m], [m/s], [m/s²]
  std::vector<double> reactions;  // mean reactions of held nodes, over all dofs [N]; empty: no node is guided
};

}  // namespace netloft
