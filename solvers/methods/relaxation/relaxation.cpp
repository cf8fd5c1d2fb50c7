// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/relaxation/relaxation.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace netloft::relaxation {

namespace {

/// The limit of λ in (5) of relaxation.hpp. If λ exceeds it, masses are raised such that λ becomes
/// kWantedRate. This is half the limit, the bound of λ for the linear stiffness with the masses (1).
constexpr double kLargestRate = 4, kWantedRate = 2;
/// Least mass as a fraction of the heaviest, half of the digits of a double. Without this bound, nodes
/// without linear stiffness would have no mass and would move too far.
constexpr double kLightest = 0x1p-26;
/// Limit of the increase of all masses, because heavier masses would move by less than rounding in a step. If
/// forces are undefined even at this limit, the method fails.
constexpr double kMostHeavier = 1 / std::numeric_limits<double>::epsilon();

class Motion {
 public:
  Motion(const Relaxation::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        r_(problem.size()),
        v_(problem.size()),
        m_(problem.size()),
        rest_(problem.size()) {}

  Outcome run() {
    if (!evaluate()) return Outcome::left_domain;
    fit_masses();
    start_from_rest();
    while (report()) {
      for (std::int64_t step = 0; step < p_.steps; ++step)
        if (!advance()) return Outcome::left_domain;
    }
    return Outcome::stopped;
  }

 private:
  bool evaluate() { return problem_.evaluate(problem_.u(), energy_, r_) == Evaluation::ok; }

  bool report() {
    const char* note = note_;
    note_ = "";
    return problem_.progress(problem_.u(), energy_, r_, note);
  }

  /// Computes the masses (1) of relaxation.hpp, each at least kLightest times the heaviest.
  void fit_masses() {
    problem_.row_sums(Matrix::none, 1, m_);
    const double heaviest = m_.empty() ? 0 : *std::max_element(m_.begin(), m_.end());
    const double least = heaviest > 0 ? kLightest * heaviest : 1;
    for (double& m : m_) m = 0.5 * std::max(m, least);
  }

  /// Takes one step of the motion. Returns false if forces are undefined at its end, even with the heaviest
  /// masses.
  bool advance() {
    move();
    if (!evaluate()) return return_to_rest();
    if (is_too_fast()) {
      make_heavier(rate_ / kWantedRate);
      start_from_rest();
      return true;
    }
    accelerate();
    return is_past_peak() ? return_to_peak() : true;
  }

  void move() {
    work_ = dot(r_, v_);
    axpy(1, v_, problem_.u());
  }

  /// Updates the velocity by (2) and the kinetic energy by (3) of relaxation.hpp.
  void accelerate() {
    double sum = 0;
    for (std::size_t i = 0; i < v_.size(); ++i) {
      v_[i] -= r_[i] / m_[i];
      sum += m_[i] * v_[i] * v_[i];
    }
    kinetic_ = {kinetic_[1], kinetic_[2], 0.5 * sum};
  }

  /// Starts from rest by (2) with half of the acceleration, because velocities belong to the middle of a
  /// step.
  void start_from_rest() {
    std::copy(problem_.u().begin(), problem_.u().end(), rest_.begin());
    double sum = 0;
    for (std::size_t i = 0; i < v_.size(); ++i) {
      v_[i] = -0.5 * r_[i] / m_[i];
      sum += m_[i] * v_[i] * v_[i];
    }
    kinetic_ = {0, 0, 0.5 * sum};
  }

  bool is_past_peak() const { return kinetic_[2] < kinetic_[1]; }

  /// Returns to the peak of the kinetic energy by (4). The v of (4) is the velocity before the last update
  /// (2), v + r/m.
  bool return_to_peak() {
    const auto [before, peak, after] = kinetic_;
    const double q = (peak - after) / (2 * peak - after - before);
    for (std::size_t i = 0; i < v_.size(); ++i) problem_.u()[i] -= q * (v_[i] + r_[i] / m_[i]);
    if (!evaluate()) return return_to_rest();
    start_from_rest();
    return true;
  }

  /// Whether λ exceeds the limit of stability, (5) of relaxation.hpp.
  bool is_too_fast() {
    rate_ = (dot(r_, v_) - work_) / (2 * kinetic_[2]);
    return rate_ > kLargestRate;
  }

  void make_heavier(double factor) {
    note_ = "heavier masses";
    heavier_ *= factor;
    for (double& m : m_) m *= factor;
  }

  /// Restarts the motion from its beginning with heavier masses.
  bool return_to_rest() {
    std::copy(rest_.begin(), rest_.end(), problem_.u().begin());
    make_heavier(kLargestRate);
    if (!evaluate() || heavier_ > kMostHeavier) return false;
    start_from_rest();
    return true;
  }

  const Relaxation::Parameters& p_;
  Problem& problem_;
  std::vector<double> r_, v_, m_, rest_;
  std::array<double, 3> kinetic_{};  // kinetic energy (3) of the last three half steps, the oldest first
  double energy_ = 0, work_ = 0, rate_ = 0, heavier_ = 1;
  const char* note_ = "";
};

}  // namespace

Outcome Relaxation::solve(const Parameters& parameters, Problem& problem) {
  return Motion(parameters, problem).run();
}

}  // namespace netloft::relaxation
