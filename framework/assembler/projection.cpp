// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/projection.hpp"

#include "framework/assembler/lanes.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

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

void add_bounds(const double* tangent, bool symmetric, std::size_t dofs, std::size_t count,
                double* packed_tangent) {
  const auto row_of = [&](std::size_t r, std::size_t c) {
    return tangent + (symmetric ? packed(std::max(r, c)) + std::min(r, c) : r * dofs + c) * kTileLanes;
  };
  for (std::size_t r = 0; r < dofs; ++r) {
    double* bound = packed_tangent + (packed(r) + r) * kTileLanes;
    for (std::size_t c = 0; c < dofs; ++c) {
      const double *here = row_of(r, c), *there = row_of(c, r);
      for (std::size_t lane = 0; lane < count; ++lane)
        bound[lane] += std::abs(0.5 * (here[lane] + there[lane]));
    }
  }
}

}  // namespace netloft
