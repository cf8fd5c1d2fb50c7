// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/achieved_accuracy.hpp"

#include <netloft/scatter.hpp>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// Ratio r of the steps of the second march to those of the first (achieved_accuracy.hpp): kShorter if
// stability limits the steps, otherwise kLonger.
constexpr double kLonger = 2, kShorter = 0.5;
// Least relative difference between the mean steps of both marches. Steps that differ by less give no
// estimate of the error.
constexpr double kLeastDifference = 0.1;
// Displacement of a disturbed start, divided by the length of the longest element: far below anything that
// can be measured on a gear. limits_of_comparison() makes the tolerance of steps at least as small.
constexpr double kDisturbance = 1e-7;

double distance(const std::vector<double>& here, const std::vector<double>& there, std::size_t first) {
  return std::hypot(here[first] - there[first], here[first + 1] - there[first + 1],
                    here[first + 2] - there[first + 2]);
}

}  // namespace

MarchSettings settings_of_comparison(const MarchSettings& settings, bool is_bounded_by_stability) {
  MarchSettings s = settings;
  s.check = s.judged = false;
  s.disturb = true;
  s.pace = is_bounded_by_stability ? kShorter : kLonger;
  if (s.step > 0) s.step *= s.pace;
  s.longest_step *= s.pace;
  s.output_interval *= s.pace;
  return s;
}

Limits limits_of_comparison(const Limits& limits) {
  Limits l = limits;
  l.tolerance = std::min(l.tolerance, kDisturbance);
  return l;
}

MarchSettings settings_of_disturbed(const MarchSettings& settings) {
  MarchSettings s = settings;
  s.disturb = false;
  return s;
}

void disturb(MarchState& start, double element) {
  for (std::size_t i = 0; i < start.u.size(); ++i) start.u[i] += kDisturbance * element * scattered(i);
}

void note_step_error(const StepControl& control, const Numbering& numbering, std::span<const double> error,
                     double t, MarchState& state) {
  const double largest = control.error_over_tolerated(error) * control.allowed();
  state.error_sum += largest;
  if (largest <= state.largest_error) return;
  state.largest_error = largest;
  state.largest_at = t;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < error.size(); ++i)
    if (std::abs(error[i]) > std::abs(error[worst])) worst = i;
  state.largest_of = numbering.node(Dof(worst));
}

void note_path_error(const std::vector<double>& here, const std::vector<double>& there, double t,
                     double longer, MarchState& state) {
  if (!(std::abs(longer - 1) >= kLeastDifference)) return;  // written so that a NaN counts, too
  for (std::size_t i = 0; i < here.size(); i += 3) {
    const double apart = distance(here, there, i);
    const double error = apart == 0 ? 0 : apart / std::min(1.0, std::abs(longer - 1));  // (1)
    if (!(error <= state.path_error)) {
      state.path_error = error;
      state.path_at = t;
      state.path_of = i / 3;
    }
  }
}

void note_parting(const std::vector<double>& here, const std::vector<double>& there, double t, double allowed,
                  MarchState& state) {
  for (std::size_t i = 0; i < here.size(); i += 3)
    if (!(distance(here, there, i) <= allowed)) state.parted_at = std::min(state.parted_at, t);
}

AchievedAccuracy achieved_accuracy(const AssembledScene& of, const MarchSettings& settings,
                                   const StepControl& control, const MarchState& state) {
  AchievedAccuracy a{
      .asked = settings.accuracy, .element = control.element_size(), .allowed = control.allowed()};
  a.largest = state.largest_error;
  a.t = state.largest_at;
  a.sum = state.error_sum;
  if (a.largest > 0) a.node = of.assembler.node_name(of.scene, static_cast<std::uint32_t>(state.largest_of));
  if (!settings.check) return a;
  a.is_checked = true;
  a.path = state.path_error / control.element_size();
  a.path_at = state.path_at;
  if (!state.other.empty()) a.unpredictable_from = state.other[0].parted_at;
  a.path_of =
      std::isfinite(a.path) ? of.scene.node_name(static_cast<std::uint32_t>(state.path_of)) : state.why_lost;
  return a;
}

}  // namespace netloft
