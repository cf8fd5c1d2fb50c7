// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/cayley.hpp"

#include <limits>

namespace netloft {

/// An approximate eigenvalue θ of A with its eigenvector, from a Krylov space. growth.hpp defines A and has
/// the numbered equations.
struct RitzPair {
  std::complex<double> theta;
  double residual = std::numeric_limits<double>::infinity();  // residual of the pair, ρ in (5)
  double condition = 1;                                       // condition number of θ, 1/χ in (5)
  Eigen::VectorXcd vector = {};

  double beyond() const { return std::abs(theta) - 1; }
  /// Whether |θ| > 1 is certain, because the estimated error of θ satisfies (5) of growth.hpp.
  bool is_known() const;
};

/// An orthonormal basis Q of the Krylov space z, Az, A²z, … in the inner product (8) of cayley.hpp, with A Q
/// = Q H. One object builds several spaces in turn and reuses its memory.
class Arnoldi {
 public:
  explicit Arnoldi(Cayley& A) : A_(A) {}

  void begin(const Eigen::VectorXd& z);
  void extend(Eigen::Index steps);
  /// The Ritz pair that decides the verdict. Candidates are the accurate pairs (is_known) that lie beyond the
  /// unit circle by more than `beyond`. Among the candidates, those that grow faster than they oscillate (|Im
  /// s| ≤ Re s, with the rate s) take precedence; of equal rank, the outermost is returned. Without
  /// candidates, the outermost of all pairs is returned. Pairs that are slow for A (Cayley::is_slow) are
  /// ignored. The returned `theta` is NaN if A or its eigenvalues could not be computed.
  RitzPair outermost(double beyond) const;
  /// Whether some Ritz value belongs to a rate that is slow for A (Cayley::is_slow).
  bool sees_slow() const;

 private:
  void step(Eigen::Index k);

  Cayley& A_;
  Eigen::MatrixXd Q_, BQ_, H_;
  Eigen::Index size_ = 0;
  bool is_exhausted_ = false;
};

}  // namespace netloft
