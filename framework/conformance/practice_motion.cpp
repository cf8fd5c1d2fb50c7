// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/practice_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace netloft::conformance {

namespace {

constexpr double kMass = 2, kNone = std::numeric_limits<double>::quiet_NaN();

bool all_finite(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

double largest_component(const std::vector<double>& x) {
  double most = 0;
  for (const double value : x) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

PracticeMotion::PracticeMotion(const PracticeSwing& like) : like_(like), n_(like.unknowns) {
  for (std::size_t i = 0; i < n_; ++i) start_.push_back(1 / (1 + static_cast<double>(i)));
  u = start_;
  v.assign(n_, 0.0);
  a.assign(n_, 0.0);
  rates_.assign(n_, 0.0);
  for (std::size_t i = 0; i < n_; ++i) a[i] = -omega(i) * omega(i) * u[i];
  for (auto* out : {&next_u_, &next_v_, &next_a_, &error_}) out->resize(n_);
  interface_.size = sizeof interface_;
  interface_.unknowns = like.unknowns;
  interface_.host = this;
  interface_.message = message_;
  interface_.message_size = sizeof message_;
  interface_.residual =
      call<&PracticeMotion::residual, int, double, const double*, const double*, const double*, double*>;
  interface_.accelerate =
      call<&PracticeMotion::accelerate, int, double, const double*, const double*, double*>;
  interface_.solve =
      call<&PracticeMotion::solve, int, double, const double*, double, const double*, double, double*>;
  interface_.solve_between = call<&PracticeMotion::solve_between, int, const double*, double, const double*,
                                  double, double, double, double*>;
  interface_.scratch = call<&PracticeMotion::scratch, double*, std::uint32_t>;
}

int PracticeMotion::run(const netloft_integrator& scheme, const void* parameters,
                        const std::vector<double>& lengths, double end) {
  for (std::size_t k = 0; end - t > 1e-9 * end; ++k) {
    const double h = std::min(lengths[k % lengths.size()], end - t);
    if (const int status = step(scheme, parameters, h); status != NETLOFT_OK) return status;
  }
  return NETLOFT_OK;
}

int PracticeMotion::step(const netloft_integrator& scheme, const void* parameters, double h) {
  for (auto* out : {&next_u_, &next_v_, &next_a_}) std::fill(out->begin(), out->end(), kNone);
  std::fill(error_.begin(), error_.end(), 0.0);
  if (clears_scratch) forget_scratch();
  const auto before = std::array{u, v, a};
  memory_ = 0;
  netloft_motion& m = interface_;
  m.t = t;
  m.h = h;
  m.u = u.data();
  m.v = v.data();
  m.a = a.data();
  m.u_new = next_u_.data();
  m.v_new = next_v_.data();
  m.a_new = next_a_.data();
  m.error = error_.data();
  const int status = scheme.step(parameters, &m);
  left_alone_ = left_alone_ && before == std::array{u, v, a};
  if (status != NETLOFT_OK) return status;
  note_quarter(h);
  for (std::size_t i = 0; i < n_; ++i) rates_[i] += memory_ * ((next_u_[i] - u[i]) / h - rates_[i]);  // (4)
  u = next_u_;
  v = next_v_;
  a = next_a_;
  estimate = largest_component(error_);
  estimated += estimate;
  t += h;
  return NETLOFT_OK;
}

void PracticeMotion::note_quarter(double h) {
  for (std::size_t i = 0; i < n_; ++i) {
    const double quarter = (27 * u[i] + 5 * next_u_[i]) / 32 + h * (9 * v[i] - 3 * next_v_[i]) / 64;  // (3)
    error_between = std::max(error_between, std::abs(quarter - exact(i, t + 0.25 * h)));
  }
}

double PracticeMotion::exact(std::size_t i, double time) const {
  const double w = omega(i), decay = like_.damping * w,
               turn = w * std::sqrt(1 - like_.damping * like_.damping);
  const double drift = like_.push / (w * w);
  const double B = (decay * start_[i] - drift) / turn;  // follows from the masses being at rest at t = 0
  return std::exp(-decay * time) * (start_[i] * std::cos(turn * time) + B * std::sin(turn * time)) +
         drift * time;  // (2)
}

double PracticeMotion::error() const {
  double most = 0;
  for (std::size_t i = 0; i < n_; ++i) most = std::max(most, std::abs(u[i] - exact(i, t)));
  return is_finite() ? most : std::numeric_limits<double>::infinity();
}

double PracticeMotion::energy() const {
  double now = 0, then = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    now += v[i] * v[i] + std::pow(omega(i) * u[i], 2);
    then += std::pow(omega(i) * start_[i], 2);
  }
  return std::isfinite(now) ? now / then : std::numeric_limits<double>::infinity();
}

bool PracticeMotion::is_finite() const { return all_finite(u) && all_finite(v) && all_finite(a); }

/// Returns F of (1) in practice_motion.hpp.
double PracticeMotion::force(std::size_t i, double time, double u_i, double v_i, double a_i) const {
  const double w = omega(i);
  return kMass * (a_i + 2 * like_.damping * w * v_i + w * w * u_i - like_.push * time);
}

int PracticeMotion::residual(double time, const double* u_at, const double* v_at, const double* a_at,
                             double* r) {
  for (std::size_t i = 0; i < n_; ++i) r[i] = force(i, time, u_at[i], v_at[i], a_at[i]);
  return like_.fails;
}

int PracticeMotion::accelerate(double time, const double* u_at, const double* v_at, double* a_at) {
  for (std::size_t i = 0; i < n_; ++i) a_at[i] = -force(i, time, u_at[i], v_at[i], 0) / kMass;
  return like_.fails;
}

/// Solves F = 0, which is linear in u: u ← u − F/(dF/du).
int PracticeMotion::solve(double time, const double* v0, double cv, const double* a0, double ca,
                          double* u_at) {
  ++solves;
  for (std::size_t i = 0; i < n_; ++i) {
    const double w = omega(i), stiffness = kMass * (ca + 2 * like_.damping * w * cv + w * w);
    u_at[i] -= force(i, time, u_at[i], v0[i] + cv * u_at[i], a0[i] + ca * u_at[i]) / stiffness;
  }
  return like_.fails;
}

int PracticeMotion::solve_between(const double* v0, double cv, const double* a0, double ca, double damping,
                                  double memory, double* u_at) {
  ++solves;
  memory_ = memory;
  const double h = interface_.h;
  for (std::size_t i = 0; i < n_; ++i) {
    const double w = omega(i), extra = kMass * w * w * damping / 2;
    const double stiffness = kMass * (ca + 2 * like_.damping * w * cv + w * w / 2) + extra;
    const double middle = (u[i] + u_at[i]) / 2;
    const double mean = force(i, t + h / 2, middle, v0[i] + cv * u_at[i], a0[i] + ca * u_at[i]) +
                        extra * (u_at[i] - u[i] - h * rates_[i]);  // (4)
    u_at[i] -= mean / stiffness;
  }
  return like_.fails;
}

double* PracticeMotion::scratch(std::uint32_t index) {
  while (scratch_.size() <= index) scratch_.emplace_back(n_, kNone);
  return scratch_[index].data();
}

void PracticeMotion::forget_scratch() {
  for (auto& kept : scratch_) std::fill(kept.begin(), kept.end(), kNone);
}

}  // namespace netloft::conformance
