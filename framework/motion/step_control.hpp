// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_scheme.hpp"
#include "framework/motion/transient_problem.hpp"

namespace netloft {

/// How long the steps of a march are: by the error of each, and by stability where the scheme is not stable
/// at any length. With error control, a step is rejected if its estimate exceeds the accuracy, and the next
/// one is
///   h ← h · 0.9 (accuracy/error)^(1/order), within [1/5, 2] h                              (1)
/// Where the error of a step is of order p in h, sums over the steps of a path fall with the power (p − 1)/p
/// of what is allowed for one. Paths shall be as accurate as is asked, so that below a, 1e-2,
///   allowed = a (accuracy/a)^(p/(p − 1)),  p = 2 with members that go slack and taut     (2)
/// (tolerance proportionality: M. Calvo, D. J. Higham, J. I. Montijano, L. Rández, "Stepsize selection for
/// tolerance proportionality in explicit Runge-Kutta codes", Adv. Comput. Math. 7, 1997).
class StepControl {
 public:
  /// `element_size`: the longest element [m], of which the accuracy is a fraction.
  StepControl(const MarchSettings& settings, const StepScheme& scheme, double element_size)
      : settings_(settings), scheme_(scheme), element_size_(element_size) {}

  /// (2), over the longest element, and in metres.
  double allowed() const;
  double tolerated() const { return allowed() * element_size_; }
  double element_size() const { return element_size_; }
  double error_over_tolerated(std::span<const double> error) const;

  /// As given; else the time in which the acceleration a leads as far as a step's error may be.
  double first_step(std::span<const double> a) const;
  /// After a step h with this error over what is tolerated (1), accepted or not.
  double next_step(double h, double error) const;
  double shorter_step(double h, double error) const;

  /// Longest step that is stable: with all members taut, and by a tangent of the last kBelieved steps, which
  /// has what members do not bound.
  void find_limit(TransientProblem& problem, MarchState& state);
  /// After so many steps it has to be found anew.
  void follow_tangent(TransientProblem& problem, MarchState& state);
  double limit() const { return limit_; }
  /// With all members taut; zero: any step is stable [s].
  double stable_step() const { return stable_; }

 private:
  double growth(double error) const;
  bool is_bounded() const { return stable_ > 0 && (settings_.adaptive || settings_.step == 0); }
  void ask_tangent(TransientProblem& problem, MarchState& state) const;
  void bound_by(const MarchState& state);

  const MarchSettings& settings_;
  const StepScheme& scheme_;
  double element_size_;
  double limit_ = 0, stable_ = 0;  // [s]
};

}  // namespace netloft
