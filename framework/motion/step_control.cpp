// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

/// Steps are at most this fraction of the longest stable step of the stiffest state, because members that
/// alternate between slack and taut create energy near the limit. A chain and a mooring line with such
/// members failed at 0.9; the chain created energy at 0.67 and none at 0.45.
constexpr double kFractionOfLimit = 0.6;
/// The accuracy a of (2) in step_control.hpp. Most scenes set an accuracy of 1e-2 or more, for which (2)
/// changes nothing. For a ball caught by a rope and a net hit by a gust, errors were proportional to the
/// accuracy to the power 0.5 and 0.8 with p = 3 (the order of the schemes), and to the power 1.1 and 1.3 with
/// p = 2.
constexpr double kProportional = 1e-2;
/// Number of steps after which the stable step is determined from the tangent again. In 64 steps, a wave
/// passes at most 64 elements, and an object that moves at a hundredth of the wave speed passes less than one
/// element. The examination costs as much as two steps. The hard motions of tests/bench/motions take a tenth
/// longer with 16 steps; with 256 steps, the step lengths agree with those for 64 within 1e-3.
constexpr int kStepsPerTangent = 64;

}  // namespace

double StepControl::allowed() const {
  const double asked = settings_.accuracy;
  return (asked >= kProportional ? asked : asked * asked / kProportional) *
         std::pow(settings_.pace, scheme_.order());
}

double StepControl::error_over_tolerated(std::span<const double> error) const {
  double largest = 0;
  for (const double e : error) largest = std::max(largest, std::abs(e));
  return largest / tolerated();
}

double StepControl::first_step(std::span<const double> a) const {
  if (settings_.step > 0) return std::min(settings_.step, settings_.adaptive ? limit_ : settings_.step);
  double fastest = 0;
  for (const double one : a) fastest = std::max(fastest, std::abs(one));
  const double h = std::sqrt(2 * tolerated() / std::max(fastest, 1e-6));
  return std::clamp(h, settings_.shortest_step, std::min(limit_, settings_.duration));
}

double StepControl::next_step(double h, double error) const {
  return std::min(h * growth(error), settings_.longest_step);
}

double StepControl::shorter_step(double h, double error) const { return h * std::max(0.2, growth(error)); }

double StepControl::growth(double error) const {  // (1)
  return std::min(2.0, 0.9 * std::pow(std::max(error, 1e-12), -1 / scheme_.order()));
}

void StepControl::find_limit(TransientProblem& problem, MarchState& state) {
  limit_ = settings_.longest_step;
  if (!scheme_.has_limit()) return;
  stable_ = scheme_.stable_step(problem.highest_frequency());
  if (is_bounded() && state.stable_step == 0) update_by_tangent(problem, state);
  if (is_bounded()) bound_by(state);
}

void StepControl::follow_tangent(TransientProblem& problem, MarchState& state) {
  if (is_bounded() && state.steps % kStepsPerTangent == 0) {
    update_by_tangent(problem, state);
    bound_by(state);
  }
}

void StepControl::update_by_tangent(TransientProblem& problem, MarchState& state) const {
  state.stable_step = scheme_.stable_step(problem.highest_frequency_at(state.u));
}

void StepControl::bound_by(const MarchState& state) {
  const double bound = kFractionOfLimit * settings_.pace;
  limit_ = std::min(settings_.longest_step, bound * std::min(stable_, state.stable_step));
}

}  // namespace netloft
