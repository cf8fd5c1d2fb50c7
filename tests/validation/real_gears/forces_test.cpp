// SPDX-License-Identifier: BSD-3-Clause
//
// Without a solver: forces are computed at the positions of FEMNET's answer, and compared with FEMNET's
// forces and with an independent evaluation of FEMNET's formulas.
#include <cstdio>

#include "tests/validation/real_gears/gears.hpp"

namespace netloft::real_gears {
namespace {

/// A gear with its nodes at the positions of FEMNET's answer.
struct Standing {
  Standing(const NeutralCase& gear, const Modelling& modelling)
      : scene(make_scene(gear, modelling)),
        plan(make_scene_plan(scene, plugins())),
        assembler(scene, plan, 1) {
    x = over_dofs(assembler, gear.reference.positions);
    residual.resize(x.size());
    EXPECT_TRUE(assembler.evaluate(x, {.residual = residual.data()})) << assembler.fault_sentence(scene);
  }
  Scene scene;
  ScenePlan plan;
  Assembler assembler;
  std::vector<double> x, residual;
};

constexpr double kForce = 1e-6;  // [N]

void expect_balance(const NeutralCase& gear, const Modelling& modelling) {
  const Standing s(gear, modelling);
  const OutOfBalance ours = out_of_balance(gear, s.assembler, s.residual);
  std::printf("out of balance: mean %.3e N (independent %.3e), largest component %.3e N (%.3e)\n", ours.mean,
              gear.reference.mean_residual, ours.largest_component, gear.reference.largest_component);
  EXPECT_NEAR(ours.mean, gear.reference.mean_residual, kForce);
  EXPECT_NEAR(ours.largest_component, gear.reference.largest_component, kForce);
}

class RealGearAtFemnetsAnswer : public RealGear {};

TEST_P(RealGearAtFemnetsAnswer, IsInBalanceWhereFemnetHasIt) { expect_balance(gear_, {}); }

// All nodes that are free to move are below the surface, so that the surface makes no difference.
TEST_P(RealGearAtFemnetsAnswer, IsInBalanceThereWithoutTheSurface) {
  expect_balance(gear_, {.surface = false});
}

TEST_P(RealGearAtFemnetsAnswer, PullsAndIsHeldAsFemnetSays) {
  Standing s(gear_, {});
  const ForceDifference worst = compare_forces(gear_, s.assembler, s.x, s.residual);
  std::printf("differences: bars %.1e N, twines %.1e N, reactions %.1e N\n", worst.bars, worst.twines,
              worst.reactions);
  EXPECT_LT(worst.bars, kForce);
  EXPECT_LT(worst.twines, kForce);
  EXPECT_LT(worst.reactions, kForce);
}

INSTANTIATE_TEST_SUITE_P(Each, RealGearAtFemnetsAnswer,
                         testing::Values("01_ring_flexion", "02_netting_panel", "05_pelagic_t1",
                                         "07_bottom_b1", "09_pelagic_s3"),
                         gear_name);

}  // namespace
}  // namespace netloft::real_gears
