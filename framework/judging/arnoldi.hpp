// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/cayley.hpp"

#include <limits>

namespace netloft {

/// An eigenvalue of A with a vector, as a Krylov space has them; numbers in brackets are those of growth.hpp.
struct RitzPair {
  std::complex<double> theta;
  double residual = std::numeric_limits<double>::infinity();  // ρ of (5)
  double condition = 1;                                       // 1/χ
  Eigen::VectorXcd vector = {};

  double beyond() const { return std::abs(theta) - 1; }
  /// By (5).
  bool is_known() const;
};

/// An orthonormal basis Q of z, Az, A²z, … in the inner product (8), with A Q = Q H on it. Its memory serves
/// one space after the other.
class Arnoldi {
 public:
  explicit Arnoldi(Cayley& A) : A_(A) {}

  void begin(const Eigen::VectorXd& z);
  /// To so many steps in all.
  void extend(Eigen::Index steps);
  /// Of those beyond the circle by more than `beyond` that are known one that diverges, else the outermost;
  /// if there is none, the outermost of all. What is slow for A is left out. Without a number: A has none.
  RitzPair outermost(double beyond) const;

 private:
  void step(Eigen::Index k);

  Cayley& A_;
  Eigen::MatrixXd Q_, BQ_, H_;
  Eigen::Index size_ = 0;
  bool is_exhausted_ = false;
};

}  // namespace netloft
