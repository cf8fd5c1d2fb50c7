// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/case/case.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::io {
namespace {

// z of the middle [m]; a quarter of a metre off it is a binary number, too, and so the displacement back
// exact
constexpr double kStraight = -10;

/// z of the middle of pressed-bars.toml, sketched at `sketch`, from where it is straight or from the sketch
/// [m].
double middle(double sketch, bool from_straight) {
  const std::string file = "tests/unit/io/case/pressed-bars.toml";
  Case one({test::source_folder() + "/" + file, {"analysis.strategy=auto"}, 1}, test::shipped_plugins());
  const auto z_of = [](std::vector<double>& x) -> double& { return x.at(5); };  // of node 1 of three
  EXPECT_EQ(one.open([&](LoadedScene& loaded) { z_of(loaded.scene.positions) = sketch; }),
            Case::State::ready);
  std::vector<double> x = one.positions(one.assembler().start());
  z_of(x) = kStraight;
  const Solution s = from_straight ? one.solve_from(one.assembler().displacements(x)) : one.solve();
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  std::vector<double> end = one.positions(s.x);
  return z_of(end);
}

// From an unstable equilibrium that a user names the search goes on there, and not from the sketch.
TEST(SolveFrom, LeavesAnUnstableEquilibriumWhereverTheSceneIsSketched) {
  const double rise = std::sqrt(1.05 * 1.05 - 1);
  for (const double side : {-1, 1})
    EXPECT_NEAR(middle(kStraight + side * 0.25, false), kStraight + side * rise, 1e-9);
  const double end = middle(kStraight - 0.25, true);
  EXPECT_NEAR(std::abs(end - kStraight), rise, 1e-9);
  EXPECT_NEAR(middle(kStraight + 0.25, true), end, 1e-9);
}

}  // namespace
}  // namespace netloft::io
