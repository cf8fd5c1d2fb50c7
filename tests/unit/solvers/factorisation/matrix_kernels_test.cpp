// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/matrix_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/solvers/factorisation/made_up.hpp"

namespace netloft {
namespace {

using Matrix = Eigen::MatrixXd;

/// A child front with 11 unknowns that are not its pivots. The first five of these are pivots of the parent,
/// which has 8 pivots and 9 further unknowns.
struct Adoption {
  static constexpr int kOthers = 11;
  const std::vector<UnknownRun> runs{{0, 1, 1}, {1, 4, 4}, {5, 8, 3}, {8, 13, 2}, {10, 16, 1}};
  std::vector<double> left = std::vector<double>(static_cast<std::size_t>(8 * left_stride(8, 9))),
                      upper = std::vector<double>(static_cast<std::size_t>(8 * upper_stride(9))),
                      update = std::vector<double>(static_cast<std::size_t>(9 * upper_stride(9)));
  Matrix child = made_up(kOthers, kOthers, 0.7);
  std::vector<double> C = std::vector<double>(static_cast<std::size_t>(kOthers * upper_stride(kOthers)));

  Adoption() {
    Eigen::Map<Matrix, 0, Eigen::OuterStride<>>(C.data(), kOthers, kOthers,
                                                Eigen::OuterStride<>(upper_stride(kOthers))) = child;
  }
  Matrix expected() const {
    Matrix all = Matrix::Zero(17, 17);
    for (const UnknownRun& r : runs)
      for (const UnknownRun& c : runs)
        all.block(r.place, c.place, r.count, c.count) = child.block(r.from, c.from, r.count, c.count);
    return all;
  }
  Matrix found() const {
    Matrix all = Matrix::Zero(17, 17);
    for (Eigen::Index j = 0; j < 8; ++j) {
      for (Eigen::Index i = 0; i < 17; ++i)
        all(i, j) = left[static_cast<std::size_t>(i + j * left_stride(8, 9))];
      for (Eigen::Index i = 0; i < 9; ++i)
        all(j, 8 + i) = upper[static_cast<std::size_t>(i + j * upper_stride(9))];
    }
    all.bottomRightCorner(9, 9) = Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>(
        update.data(), 9, 9, Eigen::OuterStride<>(upper_stride(9)));
    return all;
  }
};

TEST(MatrixKernels, AddWhatAChildLeftWhereItsUnknownsAre) {
  for (const MatrixKernels& kernels : matrix_kernels_here())
    for (const double times : {1, 2}) {
      Adoption a;
      for (int k = 0; k < times; ++k)
        kernels.add_child({a.C.data(), Adoption::kOthers, a.runs}, {8, 9, a.left.data(), a.upper.data()},
                          a.update.data());
      EXPECT_EQ(a.found(), times * a.expected());
    }
}

TEST(MatrixKernels, TakeNumbersAndSayWhetherAllAreFinite) {
  for (const MatrixKernels& kernels : matrix_kernels_here())
    for (const std::size_t count : {1u, 7u, 32u, 45u}) {
      const Matrix given = made_up(static_cast<Eigen::Index>(count), 1, 5);
      std::vector<double> from(given.data(), given.data() + count), to(count);
      EXPECT_TRUE(kernels.take(from, to.data()));
      EXPECT_EQ(to, from);
      for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
        for (std::size_t i = 0; i < count; ++i) {
          std::vector<double> spoilt = from;
          spoilt[i] = bad;
          EXPECT_FALSE(kernels.take(spoilt, to.data())) << i << " of " << count;
        }
      from[count / 2] = 1e308, from[0] = 1e308;
      EXPECT_TRUE(kernels.take(from, to.data()));
    }
}

// Two nodes with three unknowns and one with a single unknown: four blocks, and entries outside them.
TEST(MatrixKernels, MultiplyBlocksAndWhatIsBesideThem) {
  const Matrix A = made_up(7, 7, 0.4), x = made_up(7, 1, 2);
  MatrixBlocks blocks;
  std::vector<double> values;
  const auto slot = [&] { return static_cast<std::uint32_t>(values.size()); };
  for (const int column : {0, 3}) {
    blocks.columns.push_back({column, blocks.blocks.size()});
    for (const int row : {0, 3}) {
      blocks.blocks.push_back({row, slot()});
      for (int i = 0; i < 9; ++i) values.push_back(A(row + i / 3, column + i % 3));
    }
  }
  blocks.columns.push_back({7, blocks.blocks.size()});
  for (int i = 0; i < 7; ++i) {
    blocks.entries.push_back({i, 6, slot()}), values.push_back(A(i, 6));
    if (i < 6) blocks.entries.push_back({6, i, slot()}), values.push_back(A(6, i));
  }
  for (const MatrixKernels& kernels : matrix_kernels_here()) {
    std::vector<double> products(21, 9), sizes(21, 9);
    kernels.multiply(blocks, values.data(), {x.data(), 7}, products.data(), sizes.data());
    for (int i = 0; i < 7; ++i) {
      const double *p = &products[static_cast<std::size_t>(3 * i)],
                   *s = &sizes[static_cast<std::size_t>(3 * i)];
      EXPECT_NEAR(p[0] + p[1] + p[2], A.row(i).dot(x.col(0)), 1e-14);
      EXPECT_NEAR(s[0] + s[1] + s[2], A.row(i).cwiseAbs().dot(x.col(0).cwiseAbs()), 1e-14);
    }
  }
}

}  // namespace
}  // namespace netloft
