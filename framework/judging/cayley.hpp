// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/linear_motion.hpp"

#include <Eigen/Core>

#include <complex>

namespace netloft {

/// With a shift σ, the operator (4) of growth.hpp has to find all rates s with σ/kOff ≤ |s| ≤ kOff σ. Other
/// shifts find the other rates.
inline constexpr double kOff = 10;

/// The operator A of (4) in growth.hpp, one step of the trapezoidal rule for M ÿ + C ẏ + K y = 0, on vectors
/// (y, v) of displacements and velocities. The square of their norm is an energy,
///   ‖(y, v)‖² = yᵀ(K₊ + σ²M) y + vᵀM v,   K₊ the convex part of K                          (8)
/// In this norm, A enlarges no vector if K = K₊ and C damps. In another norm, a transient would look like
/// growth.
class Cayley {
 public:
  Cayley(const SparsePattern& pattern, const LinearMotion& motion, Factors& factors);
  /// Sets σ. Returns false if K + σC + σ²M has no factor.
  bool set(double sigma);
  Eigen::Index unknowns() const { return pattern_.size; }
  /// Dimension of the space of (y, v). Unknowns without mass have no velocity.
  Eigen::Index dimension() const { return dimension_; }
  /// Computes A z. With S = K + σC + σ²M, (3) of growth.hpp is
  ///   y ← 2w − y,   v ← 2σ (w − y) − v,   S w = σ (M (v + σy) + C y)                       (3a)
  /// which does not need K, so that no large stiffnesses cancel.
  Eigen::VectorXd operator*(const Eigen::VectorXd& z);
  /// Returns B z, where zᵀ B z is the square of the norm (8).
  Eigen::VectorXd weighed(const Eigen::VectorXd& z) const;
  bool is_damped() const { return motion_.is_damped; }
  /// The growth rate s that corresponds to an eigenvalue μ of A: the inverse of μ(s) in (4) of growth.hpp.
  std::complex<double> rate(std::complex<double> mu) const { return sigma_ * (mu - 1.0) / (mu + 1.0); }
  /// Whether the rate |s| of an eigenvalue μ is below σ/10. Such slow motions are left to a smaller shift σ,
  /// because their Ritz values are useless: for unit masses, w = σy and all frequencies ω ≪ σ, A is close to
  ///   (w, v) → (w + 2v, v − 2Kw/σ²),   μ = 1 ± 2iω/σ                                        (5a)
  /// whereas zᵀAz of unit vectors z ranges from 0 to 2. Ritz values may lie anywhere in that range, although
  /// the error estimate (5) of growth.hpp is small.
  bool is_slow(std::complex<double> mu) const { return std::abs(rate(mu)) < sigma_ / kOff; }
  /// A vector with a component in every direction; it has the same values on every machine.
  Eigen::VectorXd start() const;
  /// Whether an error of K could explain the growth at rate s along y. This error is the rounding error of K,
  /// or, if s is real, the change of K over the remaining Newton step δ. The length of δ is limited to
  /// kSamePlace times the gear's size, because a small imbalance leaves a long step along a soft mode.
  ///   ‖(s²M + sC) y‖ ≤ ‖10 ε |K||y|‖   or   0 < yᵀ(s²M + sC) y ≤ yᵀ(K(x + δ) − K(x)) y       (7)
  bool is_in_doubt(std::complex<double> s, const Eigen::VectorXcd& y) const;

 private:
  struct Mass {
    std::int32_t row, column;
    double value;
  };

  const SparsePattern& pattern_;
  const LinearMotion& motion_;
  Factors& factors_;
  Eigen::Index dimension_;
  double sigma_ = 0;
  std::vector<Mass> masses_;  // the entries of M that are not zero; most are, as masses lie at nodes
  std::vector<double> sum_;
  Eigen::VectorXd rhs_, w_;
};

}  // namespace netloft
