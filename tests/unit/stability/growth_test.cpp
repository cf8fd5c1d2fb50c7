// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/growth.hpp"

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

namespace netloft::hard_cases {
namespace {

/// Growth of disturbances at the equilibrium that is found for a scene of the suite, which need not be
/// stable.
double growth_of(const std::string& scene, const std::vector<std::string>& overrides, bool turned_over) {
  runs::PreparedScene one({test::source_folder() + "/" + scene, overrides, 1}, test::shipped_plugins());
  const auto turn_over = [&](scenes::LoadedScene& loaded) {
    for (std::size_t d = 2; turned_over && d < loaded.scene.positions.size(); d += 3)
      loaded.scene.positions[d] = -400 - loaded.scene.positions[d];
  };
  EXPECT_EQ(one.prepare(turn_over), runs::PreparedScene::State::ready);
  const Solution s = runs::find_equilibrium(one);
  EXPECT_TRUE(s.balance.balanced) << s.reason;
  Statistics cost;
  Factors factors(make_factorisation, cost);
  return find_growth(one.assembler(), {s.x}, factors).per_power;
}

constexpr const char* kFloat = "tests/stability/scenes/float-on-rope.toml";

// A float straight above its hold is stable; straight below it, on a rope that bears compression, the float
// is in balance and topples: the pendulum and the inverted pendulum.
const std::vector<std::string> kRod{"analysis.solver=newton", "analysis.newton.method=classic",
                                    "parts.rope.cells=10", "parts.rope.rope.EA_compression=1e5"};

TEST(Growth, NothingGrowsInAFloatThatStandsUp) { EXPECT_LE(growth_of(kFloat, kRod, false), kMarginalGrowth); }

TEST(Growth, AFloatThatHangsDownTopples) { EXPECT_GT(growth_of(kFloat, kRod, true), kMarginalGrowth); }

// The same float with an unsymmetric tangent: a current along the rope drags only at the float and leaves
// both positions in balance.
TEST(Growth, IsFoundWhereTheTangentIsUnsymmetric) {
  auto rod = kRod;
  rod.push_back("water.current=[0,0,0.2]");
  EXPECT_LE(growth_of(kFloat, rod, false), kMarginalGrowth);
  EXPECT_GT(growth_of(kFloat, rod, true), kMarginalGrowth);
}

TEST(Growth, NothingGrowsInATowedRope) {
  EXPECT_LE(growth_of("gear-library/scenes/verification/towed-rope.toml", {"analysis.solver=newton"}, false),
            kMarginalGrowth);
}

}  // namespace
}  // namespace netloft::hard_cases
