// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_scheme.hpp"
#include "framework/motion/transient_problem.hpp"

namespace netloft {

/// Chooses the lengths of the steps of a march (an integration in time) from the error of each step and, if
/// the scheme is stable for short steps only, from its stability. A step is rejected if its estimated error
/// exceeds the allowed error. The length of the next attempt is
///   h ← h · 0.9 (allowed/error)^(1/order), within [1/5, 2] h                               (1)
/// If the error of a step is O(h^p), the sum of errors over a path is proportional to the power (p − 1)/p of
/// the error allowed for a step. Accuracies below a = 1e-2 therefore need
///   allowed = a (accuracy/a)^(p/(p − 1)),  p = 2 with members that go slack and taut     (2)
/// (tolerance proportionality: M. Calvo, D. J. Higham, J. I. Montijano, L. Rández, "Stepsize selection for
/// tolerance proportionality in explicit Runge-Kutta codes", Adv. Comput. Math. 7, 1997).
class StepControl {
 public:
  /// `element_size`: extent of the longest element [m], to which the accuracy is relative.
  StepControl(const MarchSettings& settings, const StepScheme& scheme, double element_size)
      : settings_(settings), scheme_(scheme), element_size_(element_size) {}

  /// Allowed error of a step by (2), relative to the longest element.
  double allowed() const;
  /// Allowed error of a step in metres.
  double tolerated() const { return allowed() * element_size_; }
  double element_size() const { return element_size_; }
  double error_over_tolerated(std::span<const double> error) const;

  /// The step length of the settings or, if they give none, the time in which the acceleration a moves a node
  /// by the allowed error.
  double first_step(std::span<const double> a) const;
  /// Length of the next step by (1), after a step of length h whose error was `error` times the allowed one.
  double next_step(double h, double error) const;
  /// Length of the next attempt by (1), after a step of length h was rejected for the error `error`.
  double shorter_step(double h, double error) const;
  /// Determines the longest stable step from two matrices: the linear stiffness, in which all members are
  /// taut, and the tangent, which includes stiffnesses that the linear stiffness does not bound.
  void find_limit(TransientProblem& problem, MarchState& state);
  /// Every kStepsPerTangent steps, updates the longest stable step from the current tangent.
  void follow_tangent(TransientProblem& problem, MarchState& state);
  double limit() const { return limit_; }
  /// Longest stable step with all members taut [s]; zero: any step is stable.
  double stable_step() const { return stable_; }

 private:
  double growth(double error) const;
  bool is_bounded() const { return stable_ > 0 && (settings_.adaptive || settings_.step == 0); }
  void update_by_tangent(TransientProblem& problem, MarchState& state) const;
  void bound_by(const MarchState& state);

  const MarchSettings& settings_;
  const StepScheme& scheme_;
  double element_size_;
  double limit_ = 0, stable_ = 0;  // [s]
};

}  // namespace netloft
