// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_cones.hpp"

#include "io/analysis/case.hpp"
#include "io/analysis/cone_use.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::io {
namespace {

constexpr cone::Point kZ{1.7, 0.3, -0.9, 1.1}, kY{5, -2, 1, 3.5};

TEST(Cone, ScalingMapsBothPointsToOne) {
  const cone::Scaling W(kZ, kY);
  const cone::Point of_z = W.scaled(kZ), of_y = W.unscaled(kY), twice = W.scaled(W.scaled(kZ));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(of_z[i], of_y[i], 1e-13);
    EXPECT_NEAR(twice[i], kY[i], 1e-12) << "W W z = y";
    double squared = 0;
    for (std::size_t j = 0; j < 4; ++j) squared += W.squared(i, j) * kZ[j];
    EXPECT_NEAR(squared, kY[i], 1e-12);
  }
}

TEST(Cone, QuotientUndoesTheProduct) {
  const cone::Point x{0.2, -4, 1, 3}, again = cone::quotient(cone::product(kY, x), kY);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(again[i], x[i], 1e-14);
}

TEST(Cone, StepEndsWhereThePointWouldLeave) {
  const cone::Point d{-1, 0.2, 0.5, 0.1}, outward{1, 0.5, 0.5, 0.5};
  const double a = cone::step_to_boundary(kZ, d);
  cone::Point there = kZ;
  for (std::size_t i = 0; i < 4; ++i) there[i] += a * d[i];
  EXPECT_GT(a, 0);
  EXPECT_NEAR(cone::determinant(there), 0, 1e-14);
  EXPECT_EQ(cone::step_to_boundary(kZ, {-kZ[0], -kZ[1], -kZ[2], -kZ[3]}), 1) << "through the tip";
  EXPECT_GT(there[0], 0);
  EXPECT_EQ(cone::step_to_boundary(kZ, outward), std::numeric_limits<double>::infinity());
}

struct Found {
  Leg leg;
  std::vector<double> positions;
};

Found find(const Scene& scene, ConeOptions options = {.tension = 1000}) {
  TensionCones cones(scene, test::shipped_plugins(), make_factorisation, 1);
  const Leg leg = cones.solve(options);
  return {leg, cones.positions()};
}

/// A weight of 100 N in sea water that hangs on two ropes from one point, of 3 m and 2 m, both drawn far too
/// long and aslant.
Scene two_ropes(double EA, double EA_compression = 0) {
  test::Sketch s;
  const auto top = s.node(0, 0, 0, kAllAxes), weight = s.node(5, -4, 1);
  for (const double l0 : {3.0, 2.0}) {
    Part& rope = s.rope(l0 > 2 ? "long" : "short", {top, weight}, l0, EA);
    rope.parameters["rope.density"] = 1025.0, rope.parameters["rope.EA_compression"] = EA_compression;
  }
  s.part("weight", "float/float", {{"float.buoyancy", -100.0}, {"float.diameter", 0.1}}, {weight})
      .data["pieces"] = {1};
  return s.scene;
}

// The shorter rope bears all: l = l₀ (1 + P/EA).
TEST(TensionCones, TellTheRopeThatBearsFromTheSlackOne) {
  for (const double EA : {1e3, 1e5, 1e8}) {
    const Found found = find(two_ropes(EA));
    ASSERT_EQ(found.leg.status, SolveStatus::converged) << found.leg.reason;
    EXPECT_NEAR(found.positions[5], -2 * (1 + 100 / EA), 1e-6);
    EXPECT_NEAR(std::hypot(found.positions[3], found.positions[4]), 0, 1e-4);
    EXPECT_LT(found.leg.books.iterations, 20);
  }
}

// The longer rope, pressed between the point and the weight, pushes it down:
//   EA (l/2 − 1) = P + E_c (1 − l/3)
TEST(TensionCones, RestWhereWhatIsPressedLeavesThem) {
  constexpr double EA = 1e4, kPressed = 6;
  const Scene scene = two_ropes(EA, kPressed);
  const auto length = [](double pressed) { return (100 + EA + pressed) / (EA / 2 + pressed / 3); };
  const Found found = find(scene), little = find(scene, {.tension = 50});
  ASSERT_EQ(found.leg.status, SolveStatus::converged) << found.leg.reason;
  ASSERT_EQ(little.leg.status, SolveStatus::converged) << little.leg.reason;
  EXPECT_NEAR(found.positions[5], -length(kPressed), 1e-6);
  EXPECT_NEAR(little.positions[5], -length(0.5), 1e-6) << "a hundredth of a tension that is too little";
}

TEST(TensionCones, LeadAPanelThatStartsSlackToWhereItHangs) {
  Scene panel = sample::hanging_panel(8, 30);
  for (Part& part : panel.parts) part.parameters["twine.EA_compression"] = 0.0;
  const Found found = find(panel);
  ASSERT_EQ(found.leg.status, SolveStatus::converged) << found.leg.reason;
  Scene there = panel;
  there.positions = found.positions;
  const test::Solved confirmed = test::solve(there, {{}, {.tolerance = 1e-5}}), direct = test::solve(panel);
  ASSERT_EQ(confirmed.solution.status, SolveStatus::converged) << confirmed.solution.reason;
  EXPECT_LE(confirmed.solution.books.iterations, 2);
  EXPECT_NEAR(confirmed.lowest_z(), direct.lowest_z(), 1e-4);
}

TEST(TensionCones, SayThatTheyHaveNotArrivedWhereIterationsAreSpent) {
  const Found found = find(sample::hanging_panel(8, 30), {.tension = 1000, .iterations = 3});
  EXPECT_EQ(found.leg.status, SolveStatus::not_converged);
  EXPECT_EQ(found.leg.books.iterations, 3);
  EXPECT_TRUE(found.leg.reason.starts_with("the limit of 3 iterations was reached; largest residual"))
      << found.leg.reason;
  EXPECT_NE(found.leg.reason.find("slackness"), std::string::npos);
}

TEST(TensionCones, SayWhoCalledThemOff) {
  const std::atomic<bool> now = true;
  const Scene panel = sample::hanging_panel(8, 30);
  EXPECT_TRUE(
      find(panel, {.tension = 1000, .interrupt = &now}).leg.reason.starts_with("it was interrupted;"));
  EXPECT_TRUE(find(panel, {.tension = 1000, .seconds = 0}).leg.reason.starts_with("the time limit was "));
}

TEST(TensionCones, AreNearWhereLittleIsLeftThoughIterationsAreSpent) {
  const Scene panel = sample::hanging_panel(8, 30);
  const int needed = find(panel).leg.books.iterations;
  bool was_near = false;
  for (int less = 1; less <= 4; ++less) {
    TensionCones cones(panel, test::shipped_plugins(), make_factorisation, 1);
    const Leg leg = cones.solve({.tension = 1000, .iterations = needed - less});
    EXPECT_EQ(leg.status, SolveStatus::not_converged);
    was_near = was_near || cones.is_near();
  }
  EXPECT_TRUE(was_near);
  TensionCones begun(panel, test::shipped_plugins(), make_factorisation, 1);
  begun.solve({.tension = 1000, .iterations = 3});
  EXPECT_FALSE(begun.is_near());
}

TEST(TensionCones, RefuseNodesThatMoveOtherwise) {
  Scene scene = sample::hanging_rope(4);
  scene.frames[0] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_THROW(find(scene), std::invalid_argument);
}

Solution run(const std::string& file, std::vector<std::string> overrides) {
  Case one({NETLOFT_SOURCE_DIR + ("/" + file), std::move(overrides)}, test::shipped_plugins());
  EXPECT_EQ(one.open(), Case::State::ready) << one.diagnostics().render(false);
  return one.solve();
}

constexpr const char* kTrawl = "tests/stability/scenes/pelagic-trawl.toml";

TEST(TensionCones, AreTheWayOfATrawlInACurrentByItself) {
  const Solution s = run(kTrawl, {}), plain = run(kTrawl, {"analysis.continuation=off"});
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_EQ(plain.status, SolveStatus::converged) << plain.reason;
  ASSERT_EQ(s.legs.size(), 2u);
  EXPECT_EQ(s.legs.front().name, "tension only, in cones");
  EXPECT_LT(s.books.factorisations, plain.books.factorisations);
}

ConeUse use_in(const std::string& file, std::vector<std::string> overrides) {
  overrides.push_back("analysis.continuation=on");
  Case one({NETLOFT_SOURCE_DIR + ("/" + file), std::move(overrides)}, test::shipped_plugins());
  EXPECT_EQ(one.open(), Case::State::ready) << one.diagnostics().render(false);
  const ConeUse use = use_of_cones(one.loaded().scene, test::shipped_plugins(), one.assembler());
  EXPECT_EQ(one.begins_in_cones(), use == ConeUse::first);
  return use;
}

// Ropes alone have nothing to tell apart, and a panel's slack twines bear something.
TEST(ConeUse, GoesByMembersWaterAndWhatSlackTwinesBear) {
  const std::string panel = "gear-library/scenes/dead-weight-panel.toml";
  const std::string wire = "gear-library/scenes/verification/catenary-wire.toml";
  EXPECT_EQ(use_in(wire, {}), ConeUse::first);
  EXPECT_EQ(use_in(wire, {"water.current=[1,0,0]"}), ConeUse::as_a_way) << "no member need be slack";
  EXPECT_EQ(use_in(panel, {}), ConeUse::as_a_way);
  EXPECT_EQ(use_in(panel, {"parts.net.twine.EA_compression=0"}), ConeUse::first);
  EXPECT_EQ(use_in(panel, {"water.gravity=0"}), ConeUse::never);
  EXPECT_EQ(use_in(kTrawl, {}), ConeUse::first);
  EXPECT_EQ(use_in(kTrawl, {"water.current=[0,0,0]"}), ConeUse::first);
}

TEST(ConeUse, GoesByHowMuchTwinesStretchAndStandByThemselves) {
  const std::string panel = "gear-library/scenes/dead-weight-panel.toml", stiff = "parts.net.twine.EA=1e8";
  EXPECT_EQ(use_in(panel, {stiff}), ConeUse::first);
  EXPECT_EQ(use_in(panel, {stiff, "parts.net.twine.EA_compression=1e8"}), ConeUse::as_a_way);
}

TEST(TensionCones, KeepToTheIterationsThatTheUserAllows) {
  const Solution s = run(kTrawl, {"analysis.max_iterations=4"});
  ASSERT_FALSE(s.legs.empty());
  EXPECT_EQ(s.legs.front().name, "tension only, in cones");
  EXPECT_EQ(s.legs.front().books.iterations, 4);
}

}  // namespace
}  // namespace netloft::io
