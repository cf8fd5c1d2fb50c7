// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/solvers/factorisation/made_up.hpp"

namespace netloft {
namespace {

using Matrix = Eigen::MatrixXd;

/// A dense front with its panels and memory for its update.
struct DenseFront {
  DenseFront(int pivots, int others) : n(pivots), u(others) {}

  Eigen::Index n, u;
  Matrix A = made_up(n + u, n + u, 0.1);  // the last u × u entries are zero
  std::vector<double> left, upper, update;
  std::vector<std::int32_t> exchanged;

  FrontPanels panels() {
    return {static_cast<std::int32_t>(n), static_cast<std::int32_t>(u), left.data(), upper.data()};
  }
  void fill() {
    A.bottomRightCorner(u, u).setZero();
    left.assign(static_cast<std::size_t>(n * left_stride(n, u)), 0);
    upper.assign(static_cast<std::size_t>(n * upper_stride(u)), 0);
    update.assign(static_cast<std::size_t>(u * upper_stride(u)), 0);
    exchanged.assign(static_cast<std::size_t>(n), -1);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = 0; i < n + u; ++i)
        left[static_cast<std::size_t>(i + j * left_stride(n, u))] = A(i, j);
      for (Eigen::Index i = 0; i < u; ++i)
        upper[static_cast<std::size_t>(i + j * upper_stride(u))] = A(j, n + i);
    }
  }
  Matrix update_matrix() const {
    return Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>(update.data(), u, u,
                                                             Eigen::OuterStride<>(upper_stride(u)));
  }
  /// −A₂₁ A₁₁⁻¹ A₁₂
  Matrix schur_complement() const {
    if (u == 0) return Matrix(0, 0);
    return -A.bottomLeftCorner(u, n) * A.topLeftCorner(n, n).fullPivLu().solve(A.topRightCorner(n, u));
  }
};

constexpr PivotRule kLargePivots{.least = 1e-8, .positive = false};

// Numbers of pivots and of other unknowns near the widths of tiles and blocks, and more pivots than one block
// has.
const std::vector<std::pair<int, int>> kSizes{{1, 0},  {1, 1},   {3, 5},  {7, 8},   {8, 9},
                                              {9, 17}, {12, 40}, {17, 3}, {33, 31}, {70, 50}};

TEST(FrontKernels, LeaveTheSchurComplement) {
  for (const FrontKernels& kernels : front_kernels_here())
    for (const auto& [n, u] : kSizes) {
      DenseFront front{n, u};
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), {}, front.exchanged.data()).stopped_at, -1);
      kernels.update(front.panels(), front.update.data());
      const Matrix expected = front.schur_complement();
      EXPECT_LE((front.update_matrix() - expected).norm(), 1e-10 * expected.norm()) << n << " " << u;
    }
}

TEST(FrontKernels, SolveTheirPartOfTheEquations) {
  for (const FrontKernels& kernels : front_kernels_here())
    for (const auto& [n, u] : kSizes) {
      DenseFront front{n, u};
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), {}, front.exchanged.data()).stopped_at, -1);
      const Matrix x = made_up(n + u, 1, 3), b = front.A * x;  // b₂ = A₂₁ x₁
      std::vector<double> y(static_cast<std::size_t>(n + u + kTileRows), 0);
      std::copy_n(b.data(), n + u, y.begin());
      for (int k = 0; k < n; ++k) std::swap(y[k], y[front.exchanged[k]]);
      kernels.forward(front.panels(), y.data());
      const Matrix rest = Eigen::Map<Matrix>(y.data() + n, u, 1),
                   expected = front.schur_complement() * x.bottomRows(u);
      EXPECT_LT((rest - expected).norm(), 1e-9 * (1 + expected.norm())) << n << " " << u;
      std::copy_n(x.data() + n, u, y.begin() + n);
      std::fill(y.begin() + n + u, y.end(), std::nan(""));  // `backward` must not use these numbers
      kernels.backward(front.panels(), y.data());
      EXPECT_LT((Eigen::Map<Matrix>(y.data(), n, 1) - x.topRows(n)).norm(), 1e-9 * x.norm()) << n << " " << u;
    }
}

TEST(FrontKernels, SolveTheirPartOfTheTransposedEquations) {
  for (const FrontKernels& kernels : front_kernels_here())
    for (const auto& [n, u] : kSizes) {
      DenseFront front{n, u};
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), {}, front.exchanged.data()).stopped_at, -1);
      const Matrix x = made_up(n + u, 1, 3), b = front.A.transpose() * x;  // b₂ = A₁₂ᵀ x₁
      std::vector<double> y(static_cast<std::size_t>(n + u + kTileRows), 0);
      std::copy_n(b.data(), n + u, y.begin());
      kernels.forward_transposed(front.panels(), y.data());
      const Matrix rest = Eigen::Map<Matrix>(y.data() + n, u, 1);
      if (u > 0) {
        const Matrix expected = front.schur_complement().transpose() * x.bottomRows(u);
        EXPECT_LT((rest - expected).norm(), 1e-9 * (1 + expected.norm())) << n << " " << u;
      }
      std::copy_n(x.data() + n, u, y.begin() + n);
      std::fill(y.begin() + n + u, y.end(), std::nan(""));  // the kernel must not use these numbers
      kernels.backward_transposed(front.panels(), y.data());
      for (int k = n; k-- > 0;) std::swap(y[k], y[front.exchanged[k]]);
      EXPECT_LT((Eigen::Map<Matrix>(y.data(), n, 1) - x.topRows(n)).norm(), 1e-9 * x.norm()) << n << " " << u;
    }
}

TEST(FrontKernels, ExchangeRowsOnlyWhereThePivotIsSmallBesideWhatIsBelow) {
  for (const FrontKernels& kernels : front_kernels_here())
    for (const int k : {0, 5, 9}) {
      DenseFront front{12, 20};
      front.A.topLeftCorner(12, 12).setIdentity();
      front.A(11, k) = 9;
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), {}, front.exchanged.data()).stopped_at, -1);
      EXPECT_EQ(front.exchanged[static_cast<std::size_t>(k)], k);
      front.A(11, k) = 11;
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), {}, front.exchanged.data()).stopped_at, -1);
      EXPECT_EQ(front.exchanged[static_cast<std::size_t>(k)], 11);
    }
}

TEST(FrontKernels, StopAtAPivotThatIsSmallBesideWhatIsBelow) {
  for (const FrontKernels& kernels : front_kernels_here()) {
    DenseFront front{12, 20};
    front.A.block(0, 9, 12, 1).setZero();
    front.fill();
    const Elimination e = kernels.eliminate(front.panels(), kLargePivots, front.exchanged.data());
    EXPECT_EQ(e.stopped_at, 9);
    EXPECT_FALSE(e.column_is_zero);
  }
}

TEST(FrontKernels, TakePositivePivotsFromTheDiagonalAlone) {
  constexpr PivotRule kPositive{.least = 0, .positive = true};
  for (const FrontKernels& kernels : front_kernels_here())
    for (const int k : {0, 5, 9}) {
      DenseFront front{12, 20};
      front.A.topLeftCorner(12, 12).setIdentity();
      front.A(11, k) = front.A(k, 11) = 11;  // the pivot of 11 becomes 1 - 121
      front.fill();
      EXPECT_EQ(kernels.eliminate(front.panels(), kPositive, front.exchanged.data()).stopped_at, 11);
      front.A(11, 11) = 122;
      front.fill();
      ASSERT_EQ(kernels.eliminate(front.panels(), kPositive, front.exchanged.data()).stopped_at, -1);
      EXPECT_EQ(front.exchanged[static_cast<std::size_t>(k)], k);
      front.A(k, k) = 0;
      front.fill();
      EXPECT_EQ(kernels.eliminate(front.panels(), kPositive, front.exchanged.data()).stopped_at, k);
    }
}

TEST(FrontKernels, StopAtAColumnOfZeros) {
  for (const FrontKernels& kernels : front_kernels_here()) {
    DenseFront front{12, 20};
    front.A.col(9).setZero();
    front.fill();
    const Elimination e = kernels.eliminate(front.panels(), kLargePivots, front.exchanged.data());
    EXPECT_EQ(e.stopped_at, 9);
    EXPECT_TRUE(e.column_is_zero);
  }
}

}  // namespace
}  // namespace netloft
