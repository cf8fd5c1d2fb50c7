// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/easier.hpp"

#include <gtest/gtest.h>

#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

double real_of(const Part& part, const std::string& name) {
  return std::get<double>(part.parameters.at(name));
}

/// A rope of 1e6 N that bears 10 N when slack, beside one of 100 N that leaves that to its default.
Scene two_ropes() {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0, kAllAxes);
  s.rope("stiff", {a, b}, 1, 1e6).parameters["rope.EA_compression"] = 10.0;
  s.rope("soft", {b, c}, 1, 100).parameters.erase("rope.EA_compression");
  s.scene.current.samples = {{0, {2, 0, 0}}};
  return s.scene;
}

TEST(WithoutCompression, LeavesNothingThatResistsShortening) {
  const auto easier = without_compression(two_ropes(), shipped_plugins());
  ASSERT_TRUE(easier);
  for (const Part& part : easier->parts) EXPECT_EQ(real_of(part, "rope.EA_compression"), 0) << part.name;
  EXPECT_EQ(real_of(easier->parts[0], "rope.EA"), 1e6);
}

TEST(WithoutCompression, IsNothingNewToASceneThatHasNone) {
  Scene scene = two_ropes();
  for (Part& part : scene.parts) part.parameters["rope.EA_compression"] = 0.0;
  EXPECT_FALSE(without_compression(scene, shipped_plugins()));
}

TEST(Softened, KeepsThePartsOfOneRopeInProportionAndLeavesSoftOnesAlone) {
  const Scene easier = softened(two_ropes(), shipped_plugins(), 1e4);
  EXPECT_DOUBLE_EQ(real_of(easier.parts[0], "rope.EA"), 1e4);
  EXPECT_DOUBLE_EQ(real_of(easier.parts[0], "rope.EA_compression"), 0.1);
  EXPECT_EQ(real_of(easier.parts[1], "rope.EA"), 100);
  EXPECT_FALSE(easier.parts[1].parameters.contains("rope.EA_compression")) << "it follows EA by itself";
}

TEST(LargestStiffness, IsThatOfTheStiffestRope) {
  EXPECT_EQ(largest_stiffness(two_ropes(), shipped_plugins()), 1e6);
}

TEST(WithCurrent, TakesAShareOfIt) {
  EXPECT_EQ(with_current(two_ropes(), 0.25).current.samples[0].velocity[0], 0.5);
  EXPECT_FALSE(with_current(two_ropes(), 0).current.flows());
}

}  // namespace
}  // namespace netloft::test
