// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <cmath>

namespace netloft {

/// A dense matrix without any structure, of numbers within ±1.
inline Eigen::MatrixXd made_up(Eigen::Index rows, Eigen::Index columns, double seed) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [seed](Eigen::Index i, Eigen::Index j) {
    return std::sin(seed + 1.7 * static_cast<double>(i * i) + 2.3 * static_cast<double>(i * j + j));
  });
}

}  // namespace netloft
