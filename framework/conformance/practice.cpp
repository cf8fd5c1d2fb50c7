// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/practice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::conformance {

namespace {

constexpr double kBarrier = 0.1, kHardening = 100;  // b [J] and q/h [1/m²] of the energy (1) in practice.hpp
constexpr double kStrength = 100, kShift = 0.025;   // F [N] and d [m] of the stiffness near one position, (1)
constexpr double kReach = 0.72;  // R [m] of (1): n² f/(2 k) of a chain with the defaults of Practice
constexpr double kPracticeTolerance = 1e-10;
constexpr int kMostIterations = 20000, kMostEvaluations = 1000000;

}  // namespace

PracticeProblem::PracticeProblem(const Practice& like)
    : like_(like), n_(like.unknowns), masses_(n_ - (n_ > 0 && like.buckling > 0 ? 1 : 0)), u_(n_, 0.0) {
  auto& p = interface_;
  p.size = sizeof p;
  p.unknowns = n_;
  p.host = this;
  p.u = u_.data();
  p.traits = like.swirl == 0 ? NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC : 0;
  p.message = message_;
  p.message_size = sizeof message_;
  p.evaluate = call<&PracticeProblem::evaluate, std::uint32_t, const double*, double*, double*>;
  p.evaluate_both = call<&PracticeProblem::evaluate_both, const double*, double*, double*, double*>;
  p.factorise = call<&PracticeProblem::factorise, int, double>;
  p.factorise_between = call<&PracticeProblem::factorise_between, double, double>;
  p.solve = call<&PracticeProblem::solve, const double*, double*>;
  p.multiply = call<&PracticeProblem::multiply, int, double, const double*, double*>;
  p.row_sums = call<&PracticeProblem::row_sums, int, double, double*>;
  p.negative_pivots = [](void*) { return -1; };
  p.progress = [](void* host, const double* u, double, const double* r, const char*) {
    return static_cast<PracticeProblem*>(host)->progress(u, r);
  };
  p.step_length = [](void* host, const double* du) {
    double most = 0;
    for (std::uint32_t i = 0; i < static_cast<PracticeProblem*>(host)->n_; ++i)
      most = std::max(most, std::abs(du[i]));
    return most;
  };
  like_.stiffening = 0;
  like_.wall = 0;
  like_.grip = 0;
  like_.runaway = 0;
  like_.buckling = -like.buckling;
  metric_ = tangent(u_.data());
  for (std::uint32_t i = 0; i < n_; ++i)  // the metric is symmetric: the swirl is left out
    for (std::uint32_t j = 0; j < i; ++j)
      metric_[i * n_ + j] = metric_[j * n_ + i] = (metric_[i * n_ + j] + metric_[j * n_ + i]) / 2;
  like_ = like;
}

bool PracticeProblem::is_inside(const double* u) const {
  return like_.wall == 0 || std::all_of(u, u + n_, [this](double v) { return v < like_.wall; });
}

/// The argument x = S (u − a)/F of γ in (1) of practice.hpp.
double PracticeProblem::gripped(std::uint32_t i, double u) const {
  const double s = (i + 1) / double(masses_);
  return like_.grip / kStrength * (u - kReach * (2 * s - s * s) - kShift);
}

double PracticeProblem::energy_of_mass(std::uint32_t i, double u) const {
  double sum = -like_.load * u;
  if (like_.wall > 0) sum -= kBarrier * std::log(1 - u / like_.wall);
  if (like_.runaway > 0) sum -= like_.load * u * u * u / (3 * like_.runaway * like_.runaway);
  if (like_.grip == 0) return sum;
  const double x = gripped(i, u);
  return sum + kStrength * kStrength / like_.grip * (x * std::atan(x) - std::log1p(x * x) / 2);
}

double PracticeProblem::force_on_mass(std::uint32_t i, double u) const {
  double force = -like_.load;
  if (like_.wall > 0) force += kBarrier / (like_.wall - u);
  if (like_.runaway > 0) force -= like_.load * u * u / (like_.runaway * like_.runaway);
  return like_.grip == 0 ? force : force + kStrength * std::atan(gripped(i, u));
}

double PracticeProblem::stiffness_of_mass(std::uint32_t i, double u) const {
  double stiffness = 0;
  if (like_.wall > 0) stiffness += kBarrier / ((like_.wall - u) * (like_.wall - u));
  if (like_.runaway > 0) stiffness -= 2 * like_.load * u / (like_.runaway * like_.runaway);
  const double x = like_.grip == 0 ? 0 : gripped(i, u);
  return stiffness + like_.grip / (1 + x * x);
}

bool PracticeProblem::is_unstable(const double* u) const {
  return masses_ < n_ && 3 * kHardening * u[masses_] * u[masses_] < 1;
}

double PracticeProblem::energy(const double* u) const {
  double sum = 0;
  for (std::uint32_t i = 0; i < masses_; ++i) {
    const double e = stretch(u, i);
    sum += like_.stiffness / 2 * e * e + like_.stiffening / 4 * e * e * e * e + energy_of_mass(i, u[i]);
  }
  if (masses_ == n_) return sum;
  const double v = u[masses_];
  return sum + like_.buckling * v * v * (kHardening / 4 * v * v - 0.5);  // (1)
}

std::vector<double> PracticeProblem::residual(const double* u, bool gradient_only) const {
  std::vector<double> r(n_, 0.0);
  for (std::uint32_t i = 0; i < masses_; ++i) {
    const double e = stretch(u, i), force = like_.stiffness * e + like_.stiffening * e * e * e;
    r[i] += force_on_mass(i, u[i]) + force;
    if (i > 0) r[i - 1] -= force;
    if (gradient_only) continue;
    r[i] += like_.swirl * ((i + 1 < masses_ ? u[i + 1] : 0) - (i > 0 ? u[i - 1] : 0));
  }
  if (masses_ < n_) r[masses_] = like_.buckling * u[masses_] * (kHardening * u[masses_] * u[masses_] - 1);
  return r;  // (2)
}

PracticeProblem::Matrix PracticeProblem::tangent(const double* u) const {
  Matrix K(std::size_t{n_} * n_, 0.0);
  for (std::uint32_t i = 0; i < masses_; ++i) {
    const double e = stretch(u, i), k = like_.stiffness + 3 * like_.stiffening * e * e;
    K[i * n_ + i] += k + stiffness_of_mass(i, u[i]);
    if (i > 0) K[(i - 1) * n_ + i - 1] += k, K[i * n_ + i - 1] -= k, K[(i - 1) * n_ + i] -= k;
    if (i + 1 < masses_) K[i * n_ + i + 1] += like_.swirl;
    if (i > 0) K[i * n_ + i - 1] -= like_.swirl;
  }
  if (masses_ < n_)
    K[masses_ * n_ + masses_] = like_.buckling * (3 * kHardening * u[masses_] * u[masses_] - 1);
  return K;
}

double PracticeProblem::imbalance(const std::vector<double>& u) const {
  if (!is_inside(u.data())) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (const double r : residual(u.data(), false))
    most = std::isfinite(r) ? std::max(most, std::abs(r)) : std::numeric_limits<double>::infinity();
  return most / like_.load;
}

int PracticeProblem::evaluate(std::uint32_t want, const double* u, double* energy_out, double* residual_out) {
  evaluations_after_stop += stopped_;
  if (++evaluations > kMostEvaluations) return NETLOFT_ERROR;
  const bool away = std::any_of(u, u + n_, [](double v) { return v != 0; });
  const bool number = std::all_of(u, u + n_, [](double v) { return std::isfinite(v); });
  if (!number || !is_inside(u) || (like_.no_number && away)) return NETLOFT_OUTSIDE_DOMAIN;
  if (energy_out) *energy_out = energy(u);
  if (residual_out) {
    const auto r = residual(u, want & NETLOFT_WANT_GRADIENT);
    std::copy(r.begin(), r.end(), residual_out);
  }
  kept_ |= want;
  if (want & (NETLOFT_WANT_TANGENT | NETLOFT_WANT_CONVEX)) matrix_ = tangent(u);
  return NETLOFT_OK;
}

int PracticeProblem::evaluate_both(const double* u, double* energy_out, double* residual_out,
                                   double* gradient_out) {
  const int status = evaluate(NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE, u, energy_out, residual_out);
  if (status == NETLOFT_OK) {
    const auto gradient = residual(u, true);
    std::copy(gradient.begin(), gradient.end(), gradient_out);
  }
  return status;
}

PracticeProblem::Matrix PracticeProblem::shifted(int matrix, double shift) const {
  const bool none = (matrix & ~NETLOFT_INDEFINITE) == NETLOFT_NONE;
  const bool convex = (matrix & ~NETLOFT_INDEFINITE) == NETLOFT_CONVEX;
  Matrix K = none || matrix_.empty() ? Matrix(metric_.size(), 0.0) : matrix_;
  if (convex && masses_ < n_)
    K.back() = std::abs(K.back());  // a tangent of the chain is also its convex
                                    // part
  for (std::size_t i = 0; i < K.size(); ++i) K[i] += shift * metric_[i];
  return K;
}

/// Gaussian elimination without pivoting: the matrices of the chain are diagonally dominant; others are
/// refused.
int PracticeProblem::factorise(int matrix, double shift) {
  ++factorisations;
  factor_ = shifted(matrix, shift);
  if (like_.no_factor) return NETLOFT_SINGULAR;
  for (std::uint32_t k = 0; k < n_; ++k) {
    const double pivot = factor_[k * n_ + k];
    if (!(std::abs(pivot) > 1e-300)) return NETLOFT_SINGULAR;
    if (pivot < 0 && like_.swirl == 0 && !(matrix & NETLOFT_INDEFINITE)) return NETLOFT_NOT_POSITIVE;
    for (std::uint32_t i = k + 1; i < n_; ++i) {
      const double l = factor_[i * n_ + k] /= pivot;
      for (std::uint32_t j = k + 1; j < n_; ++j) factor_[i * n_ + j] -= l * factor_[k * n_ + j];
    }
  }
  return NETLOFT_FACTOR_OK;
}

/// Factorises the blend of tangent and convex part, which are equal for the chain.
int PracticeProblem::factorise_between(double, double shift) {
  const bool are_kept = (kept_ & NETLOFT_WANT_TANGENT) && (kept_ & NETLOFT_WANT_CONVEX);
  return are_kept ? factorise(NETLOFT_EXACT, shift) : NETLOFT_FACTOR_FAILED;
}

int PracticeProblem::solve(const double* rhs, double* x) const {
  if (factor_.empty() && n_ > 0) return NETLOFT_ERROR;
  std::copy(rhs, rhs + n_, x);
  for (std::uint32_t i = 0; i < n_; ++i)
    for (std::uint32_t j = 0; j < i; ++j) x[i] -= factor_[i * n_ + j] * x[j];
  for (std::uint32_t i = n_; i-- > 0;) {
    for (std::uint32_t j = i + 1; j < n_; ++j) x[i] -= factor_[i * n_ + j] * x[j];
    x[i] /= factor_[i * n_ + i];
  }
  return NETLOFT_OK;
}

int PracticeProblem::multiply(int matrix, double shift, const double* x, double* y) const {
  const Matrix K = shifted(matrix, shift);
  for (std::uint32_t i = 0; i < n_; ++i) {
    y[i] = 0;
    for (std::uint32_t j = 0; j < n_; ++j) y[i] += K[i * n_ + j] * x[j];
  }
  return NETLOFT_OK;
}

int PracticeProblem::row_sums(int matrix, double shift, double* y) const {
  const Matrix K = shifted(matrix, shift);
  for (std::uint32_t i = 0; i < n_; ++i) {
    y[i] = 0;
    for (std::uint32_t j = 0; j < n_; ++j) y[i] += std::abs(K[i * n_ + j]);
  }
  return NETLOFT_OK;
}

int PracticeProblem::progress(const double* u, const double* r) {
  ++iterations;
  reported.assign(u, u + n_);
  const auto own = residual(u, false);
  for (std::uint32_t i = 0; i < n_; ++i) {
    const double error = std::abs(r[i] - own[i]) / like_.load;
    worst_report = error <= worst_report ? worst_report : error;  // NaN counts as worse
  }
  stopped_ = true;
  if (imbalance(reported) <= kPracticeTolerance) return NETLOFT_ARRIVED;
  if (iterations >= kMostIterations || iterations == like_.interrupted_after) return NETLOFT_GIVE_UP;
  stopped_ = false;
  return NETLOFT_GO_ON;
}

}  // namespace netloft::conformance
