// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/projection.hpp"

#include <Eigen/Eigenvalues>

namespace netloft {

namespace {
constexpr int kMaxDofs = 12;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMaxDofs, kMaxDofs>;
}  // namespace

void project_convex(double* tangent, int dofs) {
  Eigen::Map<Square> k(tangent, dofs, dofs);
  const Square symmetric = 0.5 * (k + k.transpose());
  const Eigen::SelfAdjointEigenSolver<Square> eigen(symmetric);
  k = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

void bound_by_diagonal(double* tangent, int dofs) {
  Eigen::Map<Square> k(tangent, dofs, dofs);
  const Square symmetric = 0.5 * (k + k.transpose());
  k.setZero();
  for (int i = 0; i < dofs; ++i) k(i, i) = symmetric.row(i).cwiseAbs().sum();
}

}  // namespace netloft
