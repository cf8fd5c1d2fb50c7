// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/energy_watch.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

// If no energy budget is kept and steps are short, one step in this many is examined.
constexpr int kStepsPerExamination = 16;

}  // namespace

EnergyWatch::EnergyWatch(Assembler& assembler, const MarchSettings& settings, bool makes_short_steps)
    : settings_(settings), makes_short_steps_(makes_short_steps), budget_(assembler, settings.mass_damping) {}

bool EnergyWatch::begin(const MarchState& from, double negligible) {
  if (settings_.budget || settings_.watches_energy())
    if (!budget_.begin(from.t, from.u, from.v, from.a)) return false;
  if (!from.budget.empty()) budget_.set_sums(from.budget);
  if (from.judged.empty())
    judge_.begin(budget_.totals(), negligible);
  else
    judge_.set_sums(from.judged);
  return true;
}

/// Number of steps that an examined step represents.
double EnergyWatch::steps_per_examination() const {
  return settings_.budget || !makes_short_steps_ ? 1 : kStepsPerExamination;
}

bool EnergyWatch::watches_step_after(const MarchState& state) const {
  const auto every = static_cast<std::int64_t>(steps_per_examination());
  return settings_.budget || (settings_.watches_energy() && (state.steps + 1) % every == 0);
}

bool EnergyWatch::examine(TransientProblem& problem, const MarchState& from, const MarchState& to, double t,
                          double& error) {
  if (!settings_.budget && !budget_.begin(from.t, from.u, from.v, from.a)) return false;
  const EnergyBudget::Totals before = budget_.totals();
  const MeanStep* mean = problem.mean_step(to.u);
  if (problem.is_between() && !mean) return false;
  if (!budget_.advance(t, to.u, to.v, to.a, mean)) return false;
  const EnergyBudget::Totals after = budget_.totals();
  tried_ = judge_;
  tried_.note(before, after, steps_per_examination());
  if (!settings_.adaptive) return true;
  error = std::max(error, std::abs(after.numerical - before.numerical) / tolerated());
  if (error > 1) budget_.retract();
  return true;
}

/// The allowed energy error of a step, the right side of (1) in energy_watch.hpp, times
/// `pace`, the factor on all step lengths.
double EnergyWatch::tolerated() const { return settings_.accuracy * settings_.pace * tried_.scale(); }

bool EnergyWatch::restate(const MarchState& state) {
  return !settings_.budget || budget_.restate(state.t, state.u, state.v, state.a);
}

void EnergyWatch::keep_in(MarchState& state, bool refreshes) {
  if (settings_.budget && refreshes) budget_.refresh();  // without a memory, forces are the same as before
  if (settings_.budget) state.budget = budget_.sums();
  state.judged = judge_.sums();
}

}  // namespace netloft
