// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/projection.hpp"

#include <netloft/plugin.h>

#include <gtest/gtest.h>

#include <vector>

namespace netloft {
namespace {

// [2 1; 1 2] has the eigenvalues 1 and 3. [1 2; 2 1] has −1 and 3, and its projection is 3·½[1 1; 1 1].
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

/// A tile of two elements, the second with these `entries` of its tangent, and the sum that add_bounds() adds
/// to zeros.
struct Bounds {
  Bounds(std::initializer_list<double> entries, bool symmetric)
      : tangent(entries.size() * NETLOFT_LANES), sum(3 * NETLOFT_LANES) {
    std::size_t row = 0;
    for (const double entry : entries) tangent[row++ * NETLOFT_LANES + 1] = entry;
    add_bounds(tangent.data(), symmetric, 2, 2, sum.data());
  }
  std::vector<double> entries() const { return {sum[1], sum[NETLOFT_LANES + 1], sum[2 * NETLOFT_LANES + 1]}; }
  std::vector<double> tangent, sum;
};

TEST(AddBounds, SumsRowsOfTheSymmetricPart) {
  const Bounds full({1, -4, 0, 2}, false);  // symmetric part [1 -2; -2 2]
  EXPECT_EQ(full.entries(), (std::vector<double>{3, 0, 4}));
  const Bounds packed_one({1, -2, 2}, true);
  EXPECT_EQ(packed_one.entries(), (std::vector<double>{3, 0, 4}));
}

TEST(AddBounds, AddsToWhatIsThereInEveryLaneByItself) {
  Bounds twice({1, -4, 0, 2}, false);
  add_bounds(twice.tangent.data(), false, 2, 2, twice.sum.data());
  EXPECT_EQ(twice.entries(), (std::vector<double>{6, 0, 8}));
  EXPECT_EQ(twice.sum[0], 0);
}

}  // namespace
}  // namespace netloft
