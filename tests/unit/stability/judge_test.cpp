// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/judge.hpp"

#include <gtest/gtest.h>

namespace netloft::hard_cases {
namespace {

/// A gear of three nodes in a box of 3 x 4 x 12 m, whose diagonal is 13 m. Its best equilibrium has an energy
/// of -100 J.
Ended ended_at(double energy, double aside = 0) {
  Ended e;
  e.solution.status = SolveStatus::converged, e.stability = Stability::stable;
  e.solution.energy = energy, e.solution.balance.scale = 5;
  e.positions = {0, 0, 0, 3, 4, 0, 0 + aside, 0, 12};
  e.unknowns = 9;
  return e;
}

Where where(const Ended& e, Expected expected = Expected::stable, bool neutral = false) {
  HardCase c;
  c.expected = expected, c.neutral = neutral;
  return judge(c, make_reference(ended_at(-100), "hand"), e).where;
}

TEST(Judge, AReferenceKnowsTheSizeOfTheGear) {
  const Reference r = make_reference(ended_at(-100), "hand");
  EXPECT_DOUBLE_EQ(r.size, 13);
  EXPECT_EQ(r.energy, -100);
  EXPECT_EQ(r.load, 5);
  ASSERT_EQ(r.nodes.size(), 3u);
  EXPECT_EQ(r.nodes[1].x, (std::array<double, 3>{3, 4, 0}));
}

TEST(Judge, AUniqueAnswerIsWantedWithinOneInAHundredMillionOfTheSize) {
  EXPECT_EQ(where(ended_at(-100, 1.2e-7), Expected::unique), Where::reference);
  EXPECT_EQ(where(ended_at(-100, 1.4e-7), Expected::unique), Where::near);
  EXPECT_EQ(where(ended_at(-100, 1.4e-4), Expected::unique), Where::wrong);
  EXPECT_FALSE(is_right(Where::near) || is_claimed_wrong(Where::near));
}

TEST(Judge, OtherwiseTheSameShapeIsEnough) {
  EXPECT_EQ(where(ended_at(-100, 1.2e-4)), Where::reference);
  EXPECT_EQ(where(ended_at(-100, 1.4e-4)), Where::another);
}

TEST(Judge, OfTwoAtOnePlaceTheOneWithMoreDigitsIsCloser) {
  Ended rough = ended_at(-100), fine = ended_at(-100), elsewhere = ended_at(-100, 1);
  rough.solution.balance.residual = 1e-6;
  fine.solution.balance.residual = elsewhere.solution.balance.residual = 1e-9;
  const Reference known = make_reference(rough, "hand");
  EXPECT_TRUE(is_closer(fine, known));
  EXPECT_FALSE(is_closer(rough, known));
  EXPECT_FALSE(is_closer(elsewhere, known));
}

TEST(Judge, EnergyTellsBetterFromWorse) {
  EXPECT_EQ(where(ended_at(-101, 1)), Where::lower);
  EXPECT_EQ(where(ended_at(-99, 1)), Where::higher);
  EXPECT_EQ(where(ended_at(-100 + 0.5e-7, 1)), Where::another);  // 1e-9 of 100 J
  EXPECT_EQ(where(ended_at(-99, 1), Expected::unique), Where::wrong);
  EXPECT_EQ(where(ended_at(-99), Expected::unique), Where::wrong);
}

TEST(Judge, WhereSomethingMayMoveFreelyOnlyEnergyCounts) {
  EXPECT_EQ(where(ended_at(-100, 1), Expected::unique, true), Where::reference);
  EXPECT_EQ(where(ended_at(-99, 1), Expected::unique, true), Where::wrong);
}

TEST(Judge, WithoutAnEnergyOnlyThePlaceCounts) {
  Ended e = ended_at(-50, 1);
  e.conservative = false;
  EXPECT_EQ(where(e), Where::another);
  EXPECT_EQ(where(e, Expected::unique), Where::wrong);
  e.positions[6] = 0;
  EXPECT_EQ(where(e, Expected::unique), Where::reference);
}

TEST(Judge, SuccessAtAnUnstablePlaceIsClaimedWrong) {
  Ended e = ended_at(-100);
  e.stability = Stability::unstable;
  EXPECT_EQ(where(e), Where::wrong);
  EXPECT_TRUE(is_claimed_wrong(Where::wrong) && !is_right(Where::wrong));
}

// The finding of the suite prevails over the host's verdict on stability.
TEST(Judge, TheSuitesOwnFindingDecidesWhetherAnAnswerIsStable) {
  Ended e = ended_at(-100);
  e.solution.stability = Stability::stable, e.stability = Stability::unstable;
  EXPECT_EQ(where(e), Where::wrong);
  e.solution.stability = Stability::unknown, e.stability = Stability::stable;
  EXPECT_EQ(where(e), Where::reference);
}

TEST(Judge, SuccessThatNobodyCanProveStableIsNeitherRightNorClaimedWrong) {
  Ended e = ended_at(-100);
  e.stability = Stability::unknown;
  EXPECT_EQ(where(e), Where::unproven);
  EXPECT_FALSE(is_right(Where::unproven) || is_claimed_wrong(Where::unproven));
  e.stability = Stability::neutral;
  EXPECT_EQ(where(e), Where::reference);
}

// The result is stable, but another solver knows a better equilibrium: the claim is not wrong, but the result
// is not right.
TEST(Judge, AStableShapeOfMoreEnergyThanAnotherSolversIsNotRight) {
  const Where at = where(ended_at(-99, 1));
  EXPECT_EQ(at, Where::higher);
  EXPECT_FALSE(is_right(at) || is_claimed_wrong(at));
  EXPECT_TRUE(is_right(where(ended_at(-101, 1))) && is_right(where(ended_at(-100, 1))));
}

TEST(Judge, AnUnstablePlaceThatIsCalledSoIsNoLieAndNoArrival) {
  Ended e = ended_at(-100);
  e.solution.status = SolveStatus::unstable, e.stability = Stability::unstable;
  EXPECT_EQ(where(e), Where::unstable);
  EXPECT_FALSE(is_right(Where::unstable) || is_claimed_wrong(Where::unstable));
}

// A disturbance that grows without oscillation leads to another equilibrium.
TEST(Judge, ToSwingOnIsRightOnlyWhereNobodyKnowsAPlaceToRest) {
  Ended e = ended_at(-100);
  e.solution.status = SolveStatus::unstable, e.stability = Stability::unstable;
  const HardCase c;
  EXPECT_EQ(judge(c, std::nullopt, e).where, Where::unstable);
  e.solution.stability = Stability::swinging, e.solution.growing.frequency = 1;
  EXPECT_EQ(judge(c, std::nullopt, e).where, Where::flutters);
  EXPECT_EQ(where(e), Where::unstable);
  EXPECT_TRUE(is_right(Where::flutters) && !is_answer(Where::flutters) && !is_claimed_wrong(Where::flutters));
}

TEST(Judge, ToGoOnAndOnIsRightOnlyWhereNobodyKnowsAPlaceToRest) {
  for (const auto status : {SolveStatus::unstable, SolveStatus::not_converged}) {
    Ended e = ended_at(-100);
    e.solution.status = status, e.solution.does_not_settle = true;
    EXPECT_EQ(judge(HardCase{}, std::nullopt, e).where, Where::unsettled);
    EXPECT_FALSE(is_right(where(e)));
    e.out_of_budget = true;
    EXPECT_FALSE(is_right(judge(HardCase{}, std::nullopt, e).where));
  }
  EXPECT_TRUE(is_right(Where::unsettled) && !is_answer(Where::unsettled) &&
              !is_claimed_wrong(Where::unsettled));
}

TEST(Judge, FailureIsRightOnlyWhereThereIsNoEquilibriumAndInTime) {
  Ended e = ended_at(-100);
  e.solution.status = SolveStatus::not_converged;
  EXPECT_EQ(where(e), Where::failed);
  EXPECT_EQ(where(e, Expected::none), Where::honest);
  e.out_of_budget = true;
  EXPECT_EQ(where(e, Expected::none), Where::late);
  EXPECT_EQ(where(ended_at(-100), Expected::none), Where::lied);
  EXPECT_TRUE(is_right(Where::honest) && !is_right(Where::failed) && !is_right(Where::late));
  EXPECT_TRUE(is_claimed_wrong(Where::lied) && is_claimed_wrong(Where::wrong) &&
              !is_claimed_wrong(Where::failed));
}

TEST(Judge, WhereNothingIsStoredRoundingIsTheSameEnergy) {
  Ended nothing = ended_at(0), almost = ended_at(1e-9, 1);
  nothing.solution.balance.scale = almost.solution.balance.scale = 0;
  nothing.solution.balance.floor = 1e-9;  // x 13 m
  HardCase c;
  EXPECT_EQ(judge(c, make_reference(nothing, ""), almost).where, Where::another);
  almost.solution.energy = 1e-6;
  EXPECT_EQ(judge(c, make_reference(nothing, ""), almost).where, Where::higher);
}

TEST(Judge, WithoutAReferenceBalanceIsAllThatCanBeSaid) {
  HardCase c;
  EXPECT_EQ(judge(c, std::nullopt, ended_at(1)).where, Where::another);
}

TEST(Judge, ASolverThatWantsAnEnergyIsNotBlamedForHavingNone) {
  Ended e;
  e.unfit = true;
  EXPECT_EQ(where(e), Where::unfit);
  EXPECT_EQ(where(e, Expected::none), Where::unfit);
}

}  // namespace
}  // namespace netloft::hard_cases
