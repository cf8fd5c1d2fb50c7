// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

#include <array>
#include <span>
#include <vector>

namespace netloft::newton {

/// The direction v of the least curvature of a tangent K that is nearly definite:
///   K v = λ M v with the least λ, M the linear stiffness                                 (C1)
/// It is found with the factor of K + σM, which is positive definite, by at most ten steps of Lanczos for
///   (K + σM)⁻¹ M v = θ v, the largest θ; λ = 1/θ − σ                                     (C2)
/// Each vector of the basis is made orthogonal, in the inner product of M, to all earlier ones. Rayleigh
/// quotients are upper bounds of λ; if one is negative, λ is negative. B. N. Parlett, The Symmetric
/// Eigenvalue Problem (1998), ch. 13 and 15.
class LeastCurvature {
 public:
  /// Limit of the steps. A search therefore needs memory for at most twenty vectors.
  static constexpr std::size_t kSteps = 10;

  /// Reserves memory for `size` unknowns. It is not filled before the first search.
  explicit LeastCurvature(std::size_t size);

  /// Returns λ of (C1), or NaN if M cannot be used. The last factor must be that of K + `shift` M.
  double find(Problem& problem, double shift);
  /// The vector v of (C1) that the last search has found.
  std::span<const double> direction() const { return w_; }

 private:
  void start(Problem& problem);
  void lengthen(Problem& problem);
  void keep_orthogonal(Problem& problem);
  void combine(std::span<const double> y);

  std::span<double> basis(std::size_t i) { return {basis_.data() + i * w_.size(), w_.size()}; }
  std::span<double> image(std::size_t i) { return {images_.data() + i * w_.size(), w_.size()}; }

  std::size_t size_, length_ = 0;       // length of a vector; number of vectors in the basis
  std::vector<double> basis_, images_;  // orthonormal vectors q in the inner product of M; M q of each
  std::vector<double> w_;               // during a search, the next q before it is orthonormal; afterwards v
  std::array<double, kSteps> a_{},
      b_{};  // the tridiagonal matrix of (C2) in the basis: diagonal, off-diagonal
};

}  // namespace netloft::newton
