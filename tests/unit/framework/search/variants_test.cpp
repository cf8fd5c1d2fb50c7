// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/variants.hpp"

#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

double real_of(const Part& part, const std::string& name) {
  return std::get<double>(part.parameters.at(name));
}

/// A rope with an axial stiffness of 1e6 N when taut and 10 N when slack, and a rope of 100 N with the
/// default slack stiffness.
Scene two_ropes() {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0, kAllAxes);
  s.rope("stiff", {a, b}, 1, 1e6).parameters["rope.EA_compression"] = 10.0;
  s.rope("soft", {b, c}, 1, 100).parameters.erase("rope.EA_compression");
  s.scene.current.samples = {{0, {2, 0, 0}}};
  return s.scene;
}

netloft_variant without_compression() {
  netloft_variant v = as_written();
  v.compression = 0;
  return v;
}

netloft_variant capped(double newtons) {
  netloft_variant v = as_written();
  v.stiffness_cap = newtons;
  return v;
}

netloft_variant with_current(double factor) {
  netloft_variant v = as_written();
  v.current = factor;
  return v;
}

Scene easier(const netloft_variant& variant) { return make_variant(two_ropes(), shipped_plugins(), variant); }

TEST(VariantWithoutCompression, LeavesNothingThatResistsShortening) {
  const Scene scene = easier(without_compression());
  for (const Part& part : scene.parts) EXPECT_EQ(real_of(part, "rope.EA_compression"), 0) << part.name;
  EXPECT_EQ(real_of(scene.parts[0], "rope.EA"), 1e6);
  EXPECT_TRUE(resists_compression(two_ropes(), shipped_plugins()));
  EXPECT_FALSE(resists_compression(scene, shipped_plugins()));
}

TEST(VariantWithACap, KeepsThePartsOfOneRopeInProportionAndLeavesSoftOnesAlone) {
  const Scene scene = easier(capped(1e4));
  EXPECT_DOUBLE_EQ(real_of(scene.parts[0], "rope.EA"), 1e4);
  EXPECT_DOUBLE_EQ(real_of(scene.parts[0], "rope.EA_compression"), 0.1);
  EXPECT_EQ(real_of(scene.parts[1], "rope.EA"), 100);
  EXPECT_FALSE(scene.parts[1].parameters.contains("rope.EA_compression")) << "it follows EA by itself";
}

TEST(LargestStiffness, IsThatOfTheStiffestRope) {
  EXPECT_EQ(largest_stiffness(two_ropes(), shipped_plugins()), 1e6);
}

TEST(VariantWithLessCurrent, ScalesTheVelocityOfTheWater) {
  EXPECT_EQ(easier(with_current(0.25)).current.samples[0].velocity[0], 0.5);
  EXPECT_FALSE(easier(with_current(0)).current.flows());
}

TEST(CombinedVariants, AddLevelsMultiplyFactorsAndKeepTheLowerCap) {
  netloft_variant outer = capped(100), inner = capped(10);
  outer.level = 1, outer.current = 0.5, inner.level = 2, inner.current = 0.5, inner.compression = 0;
  const netloft_variant both = combined(outer, inner);
  EXPECT_EQ(both.level, 3u);
  EXPECT_EQ(both.stiffness_cap, 10);
  EXPECT_EQ(both.current, 0.25);
  EXPECT_EQ(both.compression, 0);
  EXPECT_EQ(combined(capped(100), as_written()).stiffness_cap, 100) << "no cap is no lower one";
}

TEST(TextOfAVariant, SaysWhatMakesItEasier) {
  EXPECT_EQ(text_of(as_written()), "");
  netloft_variant v = capped(120);
  v.level = 2, v.compression = 0, v.current = 0.5;
  EXPECT_EQ(text_of(v), "elements x 4, stiffness up to 120 N, no compression, current x 0.5");
}

}  // namespace
}  // namespace netloft::test
