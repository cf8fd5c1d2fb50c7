// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/linear_motion.hpp"

#include <Eigen/SparseCore>

#include <complex>

namespace netloft {

/// How far σ of (4) may be off |s|: where it is further, another σ is for it.
inline constexpr double kOff = 10;

/// A of (4) of growth.hpp, on vectors (y, v) whose length is that of (8).
class Cayley {
 public:
  Cayley(const SparsePattern& pattern, const LinearMotion& motion, Factorisation& factor, Statistics& cost);

  /// False: K + σC + σ²M has no factor.
  bool set(double sigma);
  Eigen::Index unknowns() const { return K_.rows(); }
  /// Of the space that the norm (8) sees: what has no mass has no velocity there.
  Eigen::Index dimension() const { return dimension_; }
  Eigen::VectorXd operator*(const Eigen::VectorXd& z);
  /// B z of the inner product zᵀ B z.
  Eigen::VectorXd weighed(const Eigen::VectorXd& z) const;
  bool is_damped() const { return motion_.is_damped; }
  /// s of an eigenvalue μ.
  std::complex<double> rate(std::complex<double> mu) const { return sigma_ * (mu - 1.0) / (mu + 1.0); }
  /// Whether an eigenvalue μ is left to a smaller σ, as (5a) says.
  bool is_slow(std::complex<double> mu) const { return std::abs(rate(mu)) < sigma_ / kOff; }
  /// A vector with a share in every direction, the same on every machine.
  Eigen::VectorXd start() const;
  /// By (7): whether a change of K as small as it is known would undo what grows by s along y.
  bool is_in_doubt(std::complex<double> s, const Eigen::VectorXcd& y) const;

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  const LinearMotion& motion_;
  Sparse K_, C_, M_, convex_, K_error_, norm_;  // the last: K₊ + σ²M of (8)
  Eigen::Index dimension_;
  Factorisation& factor_;
  Statistics& cost_;
  double sigma_ = 0;
  std::vector<double> sum_;
  Eigen::VectorXd rhs_, d_;
};

}  // namespace netloft
