// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace netloft {

/// A quadratic programme:
///   minimise gᵀx + ½ xᵀBx  with  G x ≤ h                                                           (1)
/// B is symmetric and positive semidefinite, and positive definite together with the rows of G.
struct Quadratic {
  Eigen::MatrixXd B;
  Eigen::VectorXd g;
  Eigen::MatrixXd G;
  Eigen::VectorXd h;
};

/// The minimiser x of (1), and the multipliers y ≥ 0 of the rows of G: g + Bx + Gᵀy = 0.
struct QuadraticAnswer {
  Eigen::VectorXd x, y;
};

/// Solves (1) from `x`, which need not satisfy G x ≤ h, with an interior point method (S. Mehrotra, SIAM J.
/// Optim. 2, 1992). If some x satisfies all rows strictly, only rounding limits the accuracy.
QuadraticAnswer minimise(const Quadratic& quadratic, Eigen::VectorXd x);

}  // namespace netloft
