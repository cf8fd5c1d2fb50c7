// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/memory.hpp"

#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// 150 elements test/leash in two parts, more than two tiles; node i is at x = i.
Scene leashes() {
  Sketch s;
  std::vector<std::uint32_t> first, second;
  for (int i = 0; i < 150; ++i) (i < 70 ? first : second).push_back(s.node(i, 0, 0));
  s.part("first", "test/leash", {{"k", 2.0}}, first);
  s.part("second", "test/leash", {{"k", 5.0}}, second);
  return s.scene;
}

double force_on(Assembled& a, const std::vector<double>& x, std::uint32_t node) {
  return a.residual(x)[a.assembler.numbering().dof(node, 0).at()];
}

std::vector<double> shifted(const Assembled& a, double by) {
  auto x = a.assembler.start();
  for (std::uint32_t n = 0; n < 150; ++n) x[a.assembler.numbering().dof(n, 0).at()] += by + 0.01 * n;
  return x;
}

TEST(Memory, BeginsWithTheStart) {
  Assembled a(leashes());
  const auto x = shifted(a, 3);
  EXPECT_DOUBLE_EQ(force_on(a, a.assembler.start(), 149), 0);
  EXPECT_NEAR(force_on(a, x, 0), 2 * 3, 1e-12);
  EXPECT_NEAR(force_on(a, x, 100), 5 * 4, 1e-12);
  EXPECT_NEAR(force_on(a, x, 149), 5 * 4.49, 1e-12);
}

TEST(Memory, StandsStillWhateverIsEvaluated) {
  Assembled a(leashes());
  const double before = force_on(a, shifted(a, 3), 99);
  force_on(a, shifted(a, 40), 99);
  EXPECT_EQ(force_on(a, shifted(a, 3), 99), before);
}

TEST(Memory, TakesWhatItIsToldToRememberElementByElement) {
  Assembled a(leashes());
  ASSERT_TRUE(a.assembler.remember(shifted(a, 3)));
  for (const std::uint32_t node : {0u, 63u, 64u, 69u, 70u, 127u, 128u, 149u}) {
    EXPECT_NEAR(force_on(a, shifted(a, 3), node), 0, 1e-12) << node;
    EXPECT_NEAR(force_on(a, shifted(a, 1), node), node < 70 ? -4 : -10, 1e-12) << node;
  }
}

TEST(Memory, KeepsItsPastWhenAnElementHasNoForceThere) {
  Assembled a(leashes());
  ASSERT_TRUE(a.assembler.remember(shifted(a, 3)));
  auto x = shifted(a, 7);
  x[a.assembler.numbering().dof(140, 0).at()] = 1001;
  EXPECT_FALSE(a.assembler.remember(x));
  EXPECT_EQ(a.assembler.fault_sentence(a.scene), "second element 70 (test/leash): no force at this state");
  EXPECT_NEAR(force_on(a, shifted(a, 3), 5), 0, 1e-12);
  EXPECT_NEAR(force_on(a, shifted(a, 3), 149), 0, 1e-12);
}

TEST(Memory, IsNotKeptOfWhatOnlySlidesOnAPassingGround) {
  Scene scene = leashes();
  scene.ground = {1.5, 0, 0};
  Assembled a(scene);
  EXPECT_TRUE(a.assembler.memory().empty());
  EXPECT_NEAR(force_on(a, shifted(a, 3), 0), -2 * 1.5, 1e-12);
  EXPECT_TRUE(a.assembler.remember(shifted(a, 3)));
}

TEST(Memory, IsOnlyKeptForElementsThatWantIt) {
  Memory none(7, 0), some(3, 2);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.kept(5), nullptr);
  some.begin();
  some.next(2)[NETLOFT_LANES] = 4;
  EXPECT_EQ(some.kept(2)[NETLOFT_LANES], 0);
  some.accept();
  EXPECT_EQ(some.kept(2)[NETLOFT_LANES], 4);
}

}  // namespace
}  // namespace netloft::test
