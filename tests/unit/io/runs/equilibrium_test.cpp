// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

// z of the middle node if the bars are straight [m]. Adding and subtracting 0.25 m is exact in binary
// numbers.
constexpr double kStraight = -10;

/// z of the middle node of pressed-bars.toml in equilibrium [m]. The node is at z = `sketch` in the scene.
/// The search begins with the node at z = `start`, or at `sketch` if `start` is empty.
double middle(double sketch, std::optional<double> start, const std::vector<std::string>& settings) {
  const std::string file = "tests/unit/io/runs/pressed-bars.toml";
  PreparedScene one({test::source_folder() + "/" + file, settings, 1}, test::shipped_plugins());
  const auto z_of = [](std::vector<double>& x) -> double& {
    return x.at(5);
  };  // the middle one of three nodes
  EXPECT_EQ(one.prepare([&](scenes::LoadedScene& loaded) { z_of(loaded.scene.positions) = sketch; }),
            PreparedScene::State::ready);
  std::vector<double> x = one.assembler().node_positions(one.assembler().start());
  if (start) z_of(x) = *start;
  const Solution s =
      start ? find_equilibrium_near(one, one.assembler().displacements(x)) : find_equilibrium(one);
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  std::vector<double> end = one.assembler().node_positions(s.x);
  return z_of(end);
}

// If the user starts from an unstable equilibrium, the search continues from there, and not from the initial
// positions.
TEST(EquilibriumNearAPoint, LeavesAnUnstableEquilibriumWhereverTheSceneIsSketched) {
  const double rise = std::sqrt(1.05 * 1.05 - 1);
  const std::vector<std::string> by{"analysis.strategy=auto"};
  for (const double side : {-1, 1})
    EXPECT_NEAR(middle(kStraight + side * 0.25, {}, by), kStraight + side * rise, 1e-9);
  const double end = middle(kStraight - 0.25, kStraight, by);
  EXPECT_NEAR(std::abs(end - kStraight), rise, 1e-9);
  EXPECT_NEAR(middle(kStraight + 0.25, kStraight, by), end, 1e-9);
}

/// The bars have weight, because a motion without a load has no scale for its residual.
TEST(EquilibriumNearAPoint, BeginsAMotionThereToo) {
  const std::vector<std::string> heavy{"analysis.solver=generalized-alpha", "water.gravity=9.81",
                                       "parts.bar.rope.density=5000", "analysis.tolerance=1e-5"};
  EXPECT_LT(middle(kStraight - 0.25, {}, heavy), kStraight - 0.1);
  EXPECT_GT(middle(kStraight - 0.25, kStraight + 0.25, heavy), kStraight + 0.1);
}

TEST(ContinuedEquilibrium, IsGivenUpAfterItsIterations) {
  PreparedScene rope({test::source_folder() + "/gear-library/scenes/hanging-rope.toml", {}, 1},
                     test::shipped_plugins());
  ASSERT_EQ(rope.prepare(), PreparedScene::State::ready);
  const std::vector<double> u = rope.assembler().displacements_to(rope.assembler().start());
  EXPECT_EQ(continue_equilibrium(rope, u, 1).status, SolveStatus::not_converged);
  const Solution found = find_equilibrium(rope);
  ASSERT_EQ(found.status, SolveStatus::converged);
  EXPECT_EQ(continue_equilibrium(rope, found.u, 1).status, SolveStatus::converged);
}

}  // namespace
}  // namespace netloft::runs
