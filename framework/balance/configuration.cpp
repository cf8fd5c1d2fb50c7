// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/configuration.hpp"

#include "framework/balance/scales.hpp"

namespace netloft {

void Configuration::begin(const StepProblem& step) {
  const auto size = static_cast<std::size_t>(assembler_.pattern().size);
  step_ = step;
  v_.resize(size);
  a_.resize(size);
}

void Configuration::count_from(std::vector<double> base) {
  base_ = std::move(base);
  x_low_.assign(base_.size(), 0.0);
  motion_.x_low = x_low_.data();
  base_extent_ = largest_extent(assembler_, base_);
}

void Configuration::place(std::span<const double> u) {
  if (!base_.empty()) return assembler_.place_from(base_, u, x_, x_low_);
  if (!is_in_time()) return assembler_.place(u, x_);
  for (std::size_t i = 0; i < u.size(); ++i) {
    v_[i] = step_.v0[i] + step_.cv * u[i];
    a_[i] = step_.a0[i] + step_.ca * u[i];
  }
  step_.state->set(step_.t, u, v_, a_);
  motion_ = step_.state->motion(step_.cv, step_.ca);
  x_ = step_.state->x();
  if (step_.between) place_end(u);
}

/// Places the nodes at the end of a step in time from the displacements u of its midpoint.
void Configuration::place_end(std::span<const double> u) {
  StepProblem::Ends& step = *step_.between;
  for (std::size_t i = 0; i < u.size(); ++i) a_[i] = 2 * u[i] - step.u[i];
  step.x_after = assembler_.start();  // this assignment also sets the held degrees of freedom
  assembler_.place(a_, step.x_after, step.end);
  step.ends.before = step.x_before.data();
  step.ends.after = step.x_after.data();
}

}  // namespace netloft
