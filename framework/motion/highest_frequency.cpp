// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/highest_frequency.hpp"

#include <netloft/vectors.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace netloft {

namespace {

constexpr int kMostLanczosSteps = 60;
/// Least number of Lanczos steps. In the first vector, every mode other than the known one has only the
/// fraction kPartOfOthers/√n and has to grow before it is visible. With fewer steps, the residual could
/// become small before that.
constexpr int kLeastSteps = 12;
constexpr double kPartOfOthers = 0.1, kResidual = 0.05;
/// If the length β of a new vector in (1) of highest_frequency.hpp is at most this fraction of the largest α,
/// the vector is rounding error: the previous vectors already span all modes that the first vector contains.
/// Further steps would give copies of modes, for which the QR algorithm can fail to converge.
constexpr double kExhausted = 1e-10;

/// Pseudo-random numbers in [−1, 1), always the same (Knuth's MMIX generator).
std::vector<double> noise(std::size_t size) {
  std::vector<double> x(size);
  std::uint64_t seed = 1;
  for (double& v : x) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    v = static_cast<double>(static_cast<std::int64_t>(seed)) * 0x1p-63;
  }
  return x;
}

/// The Lanczos iteration, (1) of highest_frequency.hpp. It stores M q together with q, so that each step
/// solves only one system with M.
class Lanczos {
 public:
  Lanczos(const Pencil& pencil, std::vector<double> start)
      : pencil_(pencil), q_(std::move(start)), p_(q_.size()), before_(q_.size()), w_(q_.size()) {
    pencil.mass(q_, p_);
    const double length = std::sqrt(dot(q_, p_));
    ended_ = !(length > 0);
    for (std::size_t i = 0; i < q_.size() && !ended_; ++i) {
      q_[i] /= length;
      p_[i] /= length;
    }
  }
  bool has_ended() const { return ended_; }
  const std::vector<double>& vector() const { return q_; }

  void step() {
    pencil_.stiffness(q_, w_);
    alpha_.push_back(dot(q_, w_));
    const double back = beta_.empty() ? 0 : beta_.back();
    for (std::size_t i = 0; i < w_.size(); ++i) w_[i] -= alpha_.back() * p_[i] + back * before_[i];
    before_.swap(p_);
    pencil_.divide_by_mass(w_, q_);
    beta_.push_back(std::sqrt(std::max(0.0, dot(q_, w_))));
    scale_ = std::max(scale_, std::abs(alpha_.back()));
    ended_ = !(beta_.back() > kExhausted * scale_);
    for (std::size_t i = 0; i < w_.size() && !ended_; ++i) {
      q_[i] /= beta_.back();
      p_[i] = w_[i] / beta_.back();
    }
  }

  struct Ritz {
    double value = 0, residual = 0;
    Eigen::VectorXd vector;  // coefficients of the vectors q of the steps
  };
  Ritz largest() const {
    const auto count = static_cast<Eigen::Index>(alpha_.size());
    if (count == 0) return {};
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all;
    all.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(alpha_.data(), count),
                               Eigen::Map<const Eigen::VectorXd>(beta_.data(), count - 1));
    if (all.info() != Eigen::Success) return {bound(), 0, Eigen::VectorXd::Unit(count, 0)};
    const Eigen::VectorXd s = all.eigenvectors().col(count - 1);
    return {all.eigenvalues()(count - 1), beta_.back() * std::abs(s(count - 1)), s};
  }

 private:
  /// Upper bound of the Ritz values, by Gershgorin's circles.
  double bound() const {
    double largest = 0;
    for (std::size_t k = 0; k < alpha_.size(); ++k)
      largest = std::max(largest, alpha_[k] + (k > 0 ? beta_[k - 1] : 0) + beta_[k]);
    return largest;
  }

  const Pencil& pencil_;
  std::vector<double> q_, p_, before_, w_;  // p = M q, before_ = M q₋
  std::vector<double> alpha_, beta_;
  double scale_ = 0;  // largest α
  bool ended_ = false;
};

double frequency(const Lanczos::Ritz& ritz) { return std::sqrt(std::max(0.0, ritz.value + ritz.residual)); }

void scale(const Pencil& pencil, std::vector<double>& x, double to) {
  std::vector<double> p(x.size());
  pencil.mass(x, p);
  const double length = std::sqrt(dot(x, p));
  for (double& v : x) v *= length > 0 ? to / length : 0;
}

}  // namespace

/// The iteration runs a second time to sum up the mode, so that the vectors of the first run need not be
/// stored.
HighestMode find_highest_mode(const Pencil& pencil) {
  Lanczos first(pencil, noise(pencil.size));
  for (int k = 0; k < kMostLanczosSteps && !first.has_ended(); ++k) first.step();
  const Lanczos::Ritz ritz = first.largest();
  HighestMode mode{frequency(ritz), std::vector<double>(pencil.size, 0.0)};
  Lanczos again(pencil, noise(pencil.size));
  for (Eigen::Index k = 0; k < ritz.vector.size(); ++k) {
    const std::vector<double>& q = again.vector();
    for (std::size_t i = 0; i < q.size(); ++i) mode.shape[i] += ritz.vector(k) * q[i];
    if (k + 1 < ritz.vector.size()) again.step();
  }
  return mode;
}

double highest_frequency_near(const Pencil& pencil, std::span<const double> shape) {
  std::vector<double> start(shape.begin(), shape.end()), others = noise(pencil.size);
  scale(pencil, start, 1);
  scale(pencil, others, kPartOfOthers);
  for (std::size_t i = 0; i < start.size(); ++i) start[i] += others[i];
  Lanczos lanczos(pencil, std::move(start));
  Lanczos::Ritz ritz;
  for (int k = 1; k <= kMostLanczosSteps && !lanczos.has_ended(); ++k) {
    lanczos.step();
    if (k < kLeastSteps && !lanczos.has_ended()) continue;
    ritz = lanczos.largest();
    if (ritz.residual <= kResidual * ritz.value) break;
  }
  return frequency(ritz);
}

}  // namespace netloft
