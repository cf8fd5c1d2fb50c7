// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/calls.hpp"

#include "framework/assembler/gather.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

#include <gtest/gtest.h>

namespace netloft::test {
namespace {

Scene bars(const char* type) {
  Sketch s;
  s.part("bars", type, {{"k", 2.0}}, {s.node(0, 0, 0), s.node(1, 2, 4)}).data["rest_length"] = {1};
  return s.scene;
}

/// One bar from (0, 0, 0) to (1, 2, 4) whose terms with and without a potential are called separately.
struct Bar {
  explicit Bar(const char* type)
      : scene(bars(type)),
        plan(make_scene_plan(scene, plugins())),
        family(scene, plan.families[0]),
        gatherer(scene, plan),
        inputs(gatherer.make_inputs(6)),
        sums(6, false) {
    for (std::size_t d = 0; d < 3; ++d) inputs.x[(3 + d) * kTileLanes] = scene.positions[3 + d];
  }
  /// Returns the energy.
  double call(const TermCalls& calls, bool with_energy, MatrixKind matrix = MatrixKind::none) {
    double energy = 0, value = 0, residual = 0;
    const Request wanted{.energy = &energy,
                         .residual = &residual,
                         .matrix = matrix,
                         .values = matrix == MatrixKind::none ? nullptr : &value};
    sums.begin(true);
    netloft_tile t = gatherer.make_tile(family, 0, {}, inputs);
    EXPECT_EQ(calls.call(family, with_energy, t, wanted, sums), NETLOFT_OK);
    return sums.energy[0];
  }
  Scene scene;
  ScenePlan plan;
  ElementFamily family;
  Gatherer gatherer;
  TileInputs inputs;
  TileSums sums;
};

/// The bar has the energy E = k (‖w‖² − l₀²)²/(8 l₀²) with w = (1, 2, 4), k = 2 N/m, l₀ = 1 m.
TEST(TermCalls, AddTermsWithAnEnergyApartFromTheOthers) {
  const TermCalls calls(TangentChoice::exact, false);
  Bar spring("test/spring");
  EXPECT_NEAR(spring.call(calls, true), 2.0 / 8 * 20 * 20, 1e-12);
  EXPECT_FALSE(spring.sums.force.is_zero());
  EXPECT_EQ(spring.call(calls, false), 0);
  EXPECT_FALSE(spring.sums.force.is_open());
  Bar follower("test/follower");
  EXPECT_EQ(follower.call(calls, true), 0);
  EXPECT_FALSE(follower.sums.force.is_open());
  EXPECT_EQ(follower.call(calls, false), 0);
  EXPECT_FALSE(follower.sums.force.is_zero());
}

/// The force on the second node is k w × (1, 2, 3), so that entry (3, 1) of the tangent is −3 k.
TEST(TermCalls, AddAsMuchOfAnUnsymmetricTangentAsIsChosen) {
  Bar bar("test/follower");
  bar.call(TermCalls(TangentChoice::exact, false), false, MatrixKind::exact);
  EXPECT_NEAR(bar.sums.square_tangent.data()[(3 * 6 + 1) * kTileLanes], -6, 1e-12);
  EXPECT_TRUE(bar.sums.packed_tangent.is_zero());
  bar.call(TermCalls(TangentChoice::symmetric, true), false, MatrixKind::exact);
  EXPECT_NEAR(bar.sums.packed_tangent.data()[(packed(3) + 1) * kTileLanes], -3, 1e-12);
  EXPECT_TRUE(bar.sums.square_tangent.is_zero());
  bar.call(TermCalls(TangentChoice::elastic, true), false, MatrixKind::exact);
  EXPECT_TRUE(bar.sums.packed_tangent.is_zero());
  EXPECT_TRUE(bar.sums.square_tangent.is_zero());
}

}  // namespace
}  // namespace netloft::test
