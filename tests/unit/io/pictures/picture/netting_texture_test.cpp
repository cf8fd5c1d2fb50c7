// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/netting_texture.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft::pictures {
namespace {

TEST(NettingTexture, IsDarkWhereTwinesLieAndWhiteBetween) {
  const auto image = netting_texture({1, 1, 1, -1}, 0.1);  // diamonds: knots where U + V and U - V are whole
  ASSERT_TRUE(image);
  const std::size_t n = image->width, half = n / 2;
  ASSERT_EQ(image->height, n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_LT(image->at(i, i)[0], 0.4f) << "U = V, at " << i;
    EXPECT_LT(image->at(i, n - 1 - i)[0], 0.4f) << "U + V = 1, at " << i;
  }
  EXPECT_EQ(image->at(half, 0)[0], 1) << "the middle of a mesh";
  EXPECT_EQ(image->at(0, half)[0], 1) << "the middle of a mesh";
}

TEST(NettingTexture, OfSquareMeshesHasItsTwinesAlongItsSides) {
  const auto image = netting_texture({1, 0, 0, 1}, 0.1);
  ASSERT_TRUE(image);
  const std::size_t n = image->width;
  for (std::size_t i = 0; i < n; ++i) EXPECT_LT(std::max(image->at(i, 0)[0], image->at(0, i)[0]), 0.4f);
  EXPECT_EQ(image->at(n / 2, n / 2)[0], 1);
}

TEST(NettingTexture, DoesNotHangOnRoundOff) {
  const auto exact = netting_texture({1, 1, -1, 1}, 0.1),
             computed = netting_texture({1, 1 - 1e-15, -1 + 1e-15, 1}, 0.1);
  ASSERT_TRUE(exact && computed);
  EXPECT_EQ(exact->bytes, computed->bytes);
}

TEST(NettingTexture, IsNotMadeOfTwinesThatDoNotRepeatWithMeshes) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(netting_texture({0.5, 0.5, 0.5, -0.5}, 0.1));
  EXPECT_FALSE(netting_texture({1, 1, 1, 1}, 0.1));
  EXPECT_FALSE(netting_texture({kNone, kNone, kNone, kNone}, 0.1));
}

}  // namespace
}  // namespace netloft::pictures
