// SPDX-License-Identifier: BSD-3-Clause
//
// The practice searches (small problems for checks of strategies) have the solutions that their descriptions
// claim.
#include "framework/conformance/practice_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::conformance {
namespace {

/// One stage of a search, from zero displacements or from `u`.
struct Tried {
  explicit Tried(PracticeSearch& search, netloft_variant variant = {sizeof(netloft_variant), 0, 0, 1, 1},
                 std::vector<double> from = {})
      : u(std::move(from)) {
    u.resize(search.interface().size_of(&search, variant.level), 0.0);
    stage.size = sizeof stage, stage.variant = variant, stage.name = "try", stage.u = u.data();
    search.interface().solve(&search, &stage);
  }
  std::vector<double> u;
  netloft_stage stage{};
};

netloft_variant capped(double cap) { return {sizeof(netloft_variant), 0, cap, 1, 1}; }
netloft_variant coarse() { return {sizeof(netloft_variant), 1, 0, 1, 1}; }

constexpr Practice kGripped{.grip = 1e4}, kBuckling{.buckling = 10, .unknowns = 13};

TEST(PracticeSearch, SolvesALinearChainInOneIteration) {
  PracticeSearch search({});
  const Tried at_once(search);
  EXPECT_EQ(at_once.stage.ending, NETLOFT_ENDED_CONVERGED);
  EXPECT_EQ(at_once.stage.iterations_done, 1u);
  EXPECT_NEAR(at_once.u[0], 12 * 1.0 / 100, 1e-12);   // n f/k: the first spring carries all loads
  EXPECT_NEAR(at_once.u[11], 78 * 1.0 / 100, 1e-12);  // f/k (12 + 11 + … + 1)
}

TEST(PracticeSearch, SolvesAChainWithAGripOnlyOverSofterOnes) {
  PracticeSearch search({.like = kGripped});
  EXPECT_NE(Tried(search).stage.ending, NETLOFT_ENDED_CONVERGED);
  std::vector<double> u;
  for (const double cap : {10.0, 100.0, 1000.0, 0.0}) u = Tried(search, capped(cap), u).u;
  EXPECT_EQ(Tried(search, capped(0), u).stage.iterations_done, 0u);
}

TEST(PracticeSearch, HasNoEquilibriumWhereTheLoadRunsAway) {
  for (const double factor : {1.0, 0.5, 0.0, -1.0, -10.0}) {
    PracticeSearch search({.like = {.runaway = 0.05}});
    const Tried tried(search, capped(0), std::vector<double>(12, factor));
    EXPECT_NE(tried.stage.ending, NETLOFT_ENDED_CONVERGED) << factor;
    EXPECT_NE(tried.stage.ending, NETLOFT_ENDED_UNSTABLE) << factor;
  }
}

TEST(PracticeSearch, BucklesAlongWhatGrows) {
  PracticeSearch search({.like = kBuckling});
  const Tried straight(search);
  ASSERT_EQ(straight.stage.ending, NETLOFT_ENDED_UNSTABLE);
  ASSERT_NE(straight.stage.growing, nullptr);
  std::vector<double> beside = straight.u;
  for (std::size_t i = 0; i < beside.size(); ++i) beside[i] += 1e-3 * straight.stage.growing[i];
  const Tried bent(search, capped(0), beside);
  EXPECT_EQ(bent.stage.ending, NETLOFT_ENDED_CONVERGED);
  EXPECT_NEAR(bent.u[12], 0.1, 1e-8);  // v = √(h/q)
  EXPECT_LT(bent.stage.energy, straight.stage.energy);
}

TEST(PracticeSearch, TakesBackWhatGrowsAtTheNextCall) {
  PracticeSearch search({.like = kBuckling});
  const Tried straight(search);
  search.interface().work_left(&search);
  EXPECT_TRUE(std::isnan(straight.stage.growing[12]));
}

TEST(PracticeSearch, IsNearlyTheSameOnACoarserMesh) {
  PracticeSearch search({.levels = 2});
  const Tried fine(search), half(search, coarse());
  std::vector<double> read(12);
  search.interface().transfer(&search, 1, half.u.data(), 0, read.data());
  EXPECT_NEAR(read[11], fine.u[11],
              0.1 * fine.u[11]);  // error of a load on the last mass: f/(n f) of the end
  EXPECT_NEAR(half.stage.spent, fine.stage.spent / 2, 1e-12);
}

TEST(PracticeSearch, EndsWhereTheWorkDoes) {
  PracticeSearch search({.like = kGripped, .budget = 5});
  EXPECT_EQ(Tried(search).stage.ending, NETLOFT_ENDED_OUT_OF_WORK);
  EXPECT_EQ(search.interface().work_left(&search), 0);
  Tried again(search);
  EXPECT_FALSE(search.slip(Slip::after_budget).empty());
}

TEST(PracticeSearch, CountsWorkOfAMethodOfTheStrategysOwn) {
  PracticeSearch search({.budget = 10});
  std::vector<double> u(12, 0.0), r(12);
  netloft_stage stage{};
  stage.size = sizeof stage, stage.variant = capped(0), stage.name = "own", stage.u = u.data();
  netloft_problem p{};
  ASSERT_EQ(search.interface().problem(&search, &stage, &p), NETLOFT_OK);
  p.evaluate(p.host, NETLOFT_WANT_TANGENT | NETLOFT_WANT_FORCE, p.u, nullptr, r.data());
  p.factorise(p.host, NETLOFT_EXACT, 0), p.solve(p.host, r.data(), r.data());
  for (std::size_t i = 0; i < u.size(); ++i) p.u[i] -= r[i];
  ASSERT_EQ(search.interface().assess(&search, &stage), NETLOFT_OK);
  EXPECT_EQ(stage.ending, NETLOFT_ENDED_CONVERGED);
  EXPECT_NEAR(search.interface().work_left(&search), 10 - 1 - 2 * 0.1, 1e-12);
}

}  // namespace
}  // namespace netloft::conformance
