// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/tangent.hpp"

#include <gtest/gtest.h>

#include "io/runs/equilibrium.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

struct Rope : PreparedScene {
  explicit Rope(const std::string& change)
      : PreparedScene({test::source_folder() + "/gear-library/scenes/hanging-rope.toml", {change}, 1},
                      test::shipped_plugins()) {
    EXPECT_EQ(prepare(), State::ready) << diagnostics().render(false);
  }
};

TEST(Topology, IsThatOfTheMeshWhateverTheValues) {
  const Rope rope("water.gravity=9.81"), heavier("parts.rope.rope.density=3000"), finer("parts.rope.cells=8");
  EXPECT_TRUE(have_same_topology(rope, heavier));
  EXPECT_FALSE(have_same_topology(rope, finer));
  EXPECT_FALSE(have_same_topology(finer, rope));
}

TEST(Tangent, IsZeroTowardsTheSameScene) {
  Rope rope("parts.rope.cells=20"), same("parts.rope.cells=20");
  const Solution s = find_equilibrium(rope);
  const auto tangent = Tangent(rope, s.x).towards(same);
  ASSERT_TRUE(tangent);
  for (const double dx : *tangent) EXPECT_NEAR(dx, 0, 1e-12);
}

TEST(Tangent, IsNoneForAnEquilibriumOfASettlingMotion) {
  Rope rope("analysis.solver=newmark"), same("analysis.solver=newmark");
  const auto start = rope.assembler().start();
  EXPECT_FALSE(Tangent(rope, {start.begin(), start.end()}).towards(same));
}

}  // namespace
}  // namespace netloft::runs
