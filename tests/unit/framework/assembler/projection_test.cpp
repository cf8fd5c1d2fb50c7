// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/projection.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace netloft {
namespace {

// [2 1; 1 2] has eigenvalues 1 and 3; [1 2; 2 1] has −1 and 3, and 3·½[1 1; 1 1] is left of it.
TEST(ProjectConvex, LeavesAPositiveMatrixAlone) {
  std::vector<double> k{2, 1, 1, 2};
  project_convex(k.data(), 2);
  const double want[] = {2, 1, 1, 2};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(k[i], want[i], 1e-15);
}

TEST(ProjectConvex, DropsNegativeEigenvalues) {
  std::vector<double> k{1, 2, 2, 1};
  project_convex(k.data(), 2);
  for (const double v : k) EXPECT_NEAR(v, 1.5, 1e-15);
}

TEST(ProjectConvex, TakesTheSymmetricPart) {
  std::vector<double> k{1, 4, 0, 1};  // symmetric part [1 2; 2 1]
  project_convex(k.data(), 2);
  for (const double v : k) EXPECT_NEAR(v, 1.5, 1e-15);
}

TEST(ProjectConvex, MakesNothingOfANegativeMatrix) {
  std::vector<double> k{-3, 0, 0, 0, -1, 0, 0, 0, -2};
  project_convex(k.data(), 3);
  for (const double v : k) EXPECT_NEAR(v, 0, 1e-15);
}

TEST(BoundByDiagonal, SumsRowsOfTheSymmetricPart) {
  std::vector<double> k{1, -4, 0, 2};  // symmetric part [1 -2; -2 2]
  bound_by_diagonal(k.data(), 2);
  EXPECT_EQ(k, (std::vector<double>{3, 0, 0, 4}));
}

}  // namespace
}  // namespace netloft
