// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/scheme_probe.hpp"

#include <netloft/vectors.hpp>

#include "framework/motion/march_ending.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace netloft {

namespace {

// Forces up to this fraction of the load may be unbalanced at the start, because of the tolerance with which
// the start was found.
constexpr double kDrives = 1e-3;
// A distance counts as rounding error if it is less than this many rounding errors of the largest
// displacement.
constexpr double kRoundings = 1e4;
// Shortest step, relative to the step of the march. For the motions of the library, whose stiffest modes are
// far faster than the steps of a march, the shipped schemes pass with 1e-3 or longer steps.
constexpr double kShortest = 1e-7;
// Largest relative error in either half of (1). For the motions of the library, the forces that the shipped
// schemes leave are a smaller fraction with steps of 0.1 to 0.001 of the step of the march, and the error of
// their displacements is at most 0.36 even at 0.1. A scheme that does nothing has an error of 1 in both
// halves, with any step.
constexpr double kMissed = 0.5;

}  // namespace

SchemeProbe::SchemeProbe(Assembler& assembler, double mass_damping, SolverChoice solver,
                         const MakeFactorisation& make, const Limits& limits)
    : problem_(assembler, mass_damping, solver, make, limits) {
  for (auto* vector : {&a_, &force_, &mean_a_, &next_u_, &next_v_, &next_a_, &error_})
    vector->assign(problem_.size(), 0.0);
}

std::string SchemeProbe::fault_of(const StepScheme& scheme, const MarchState& at) {
  if (!find_forces(at) || !(is_driven_ || is_moving_)) return {};
  bool has_taken_one = false;
  double left = 0, path = 0, h = 0.1 * at.h;
  for (; h >= kShortest * at.h; h *= 0.1) {
    if (!takes_step(scheme, at, h)) continue;
    has_taken_one = true;
    left = left_over(at, h);
    path = moved(at, h);
    if ((!is_driven_ || left <= kMissed * driving_) && (!is_moving_ || std::abs(path - 1) <= kMissed))
      return {};
  }
  if (!has_taken_one) return {};
  char text[320];
  std::snprintf(text, sizeof text,
                "the integrator %s does not follow the equation of motion: a step of %s leaves %.3g N of "
                "%.3g N out of balance, and moves the gear by %.3g times the correct displacement",
                scheme.name().c_str(), seconds_text(10 * h).c_str(), left, driving_, path);
  return text;
}

bool SchemeProbe::find_forces(const MarchState& at) {
  problem_.set_least_load(at.least_load);
  if (problem_.start(at.t, at.u, at.v, a_) != NETLOFT_OK) return false;
  mass_ = problem_.masses();
  std::fill(mean_a_.begin(), mean_a_.end(), 0.0);
  driving_ = largest_force(at, mean_a_);
  is_driven_ = driving_ > kDrives * problem_.least_load();
  is_moving_ = largest_of(at.v) * kShortest * at.h >
               kRoundings * std::numeric_limits<double>::epsilon() * std::max(1.0, largest_of(at.u));
  return true;
}

/// The largest of the forces F(t, u, v, a) on unknowns with mass [N]; infinite if they cannot be computed.
double SchemeProbe::largest_force(const MarchState& at, std::span<const double> a) {
  netloft_motion& m = problem_.interface();
  if (m.residual(m.host, at.t, at.u.data(), at.v.data(), a.data(), force_.data()) != NETLOFT_OK)
    return std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mass_.size(); ++i)
    if (mass_[i] == 0) force_[i] = 0;
  return largest_of(force_);
}

/// The largest force that remains unbalanced at the velocities of the last step [N], by the first half of (1)
/// in scheme_probe.hpp.
double SchemeProbe::left_over(const MarchState& at, double h) {
  for (std::size_t i = 0; i < mass_.size(); ++i) mean_a_[i] = mass_[i] == 0 ? 0 : (next_v_[i] - at.v[i]) / h;
  return largest_force(at, mean_a_);
}

/// The length of the last step along v: (u_new − u)·v as a fraction of its limit h v·v in (1) of
/// scheme_probe.hpp.
double SchemeProbe::moved(const MarchState& at, double h) const {
  double went = 0, due = 0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    if (mass_[i] == 0) continue;
    went += (next_u_[i] - at.u[i]) * at.v[i];
    due += h * at.v[i] * at.v[i];
  }
  return due > 0 ? went / due : 1;
}

bool SchemeProbe::takes_step(const StepScheme& scheme, const MarchState& at, double h) {
  std::fill(error_.begin(), error_.end(), 0.0);
  netloft_motion& m = problem_.interface();
  m.t = at.t;
  m.h = h;
  m.u = at.u.data();
  m.v = at.v.data();
  m.a = a_.data();
  m.u_new = next_u_.data();
  m.v_new = next_v_.data();
  m.a_new = next_a_.data();
  m.error = error_.data();
  return scheme.step(m) == NETLOFT_OK;
}

}  // namespace netloft
