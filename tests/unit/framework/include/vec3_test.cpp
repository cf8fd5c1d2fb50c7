// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/dual.hpp>
#include <netloft/vec3.hpp>

#include <gtest/gtest.h>

namespace netloft {
namespace {

template <class A, class B>
concept Multiply = requires(const A& a, const B& b) {
  a* b;
};

TEST(Vec3, TakesANumberOnEitherSide) {
  const Vec3<double> a{1, -2, 3}, left = 2 * a, right = a * 2;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(left[axis], 2 * a[axis]);
    EXPECT_EQ(right[axis], 2 * a[axis]);
  }
}

TEST(Vec3, OfNumbersThatKnowTheirDerivativesTakesBothKindsOnEitherSide) {
  using T = Dual<1, 1>;
  const T t = T::variable(3, 0);
  const Vec3<T> a{t, t * t, T(1)};
  EXPECT_EQ((a * 2.0).y.gradient[0], 12);
  EXPECT_EQ((a * t).y.value, 27);
  EXPECT_EQ((t * a).y.gradient[0], 27);
  EXPECT_EQ((a * t).y.gradient[0], 27);
}

TEST(Vec3, HasNoProductOfTwoWithoutAName) {
  EXPECT_FALSE((Multiply<Vec3<double>, Vec3<double>>));
  EXPECT_TRUE((Multiply<Vec3<double>, double>));
}

}  // namespace
}  // namespace netloft
