// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/journey.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solvers/factorisation/factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m, as stiff pressed as pulled, straight between ends that are 1.8 m apart.
Scene pressed_bars() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, 0), c = s.node(1.8, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  return s.scene;
}

struct Travelled {
  Solution solution;
  double away = 0;  // of node 1 from the line [m]
};

Travelled travel(const Scene& scene, Limits limits = {}, int looks = 0, OwnStart own_start = {},
                 const char* solver = "newton") {
  Registry& registry = shipped_plugins();
  const Plan plan = make_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  JourneyOptions options;
  options.solver.type = &registry.solver(solver);
  options.limits = limits, options.make = make_factorisation, options.looks = looks;
  options.own_start = std::move(own_start);
  Travelled t{Journey(scene, assembler, registry, options).arrive({}), 0};
  const auto at = [&](int axis) {
    return t.solution.x[static_cast<std::size_t>(assembler.numbering().index(1, axis))];
  };
  t.away = std::hypot(at(1), at(2));
  return t;
}

TEST(Journey, LeavesAPointThatIsInBalanceAndNotStable) {
  const Travelled t = travel(pressed_bars());
  EXPECT_EQ(t.solution.status, SolveStatus::converged) << t.solution.reason;
  EXPECT_NEAR(t.away, std::sqrt(1 - 0.81), 1e-6) << "the bars buckle until nothing presses them";
  ASSERT_GT(t.solution.legs.size(), 1u);
  EXPECT_EQ(t.solution.legs.front().status, SolveStatus::unstable);
}

/// An arch of the same two bars in the plane, standing up on its feet under a small load.
Scene arch() {
  Scene scene = pressed_bars();
  scene.water = {0, 9.81};
  scene.positions[5] = 0.43;
  scene.held[1] = kAxisY;
  scene.parts[0].parameters["rope.diameter"] = 0.01;
  return scene;
}

TEST(Journey, FindsTheOtherShapesOfAGearAndKeepsThatOfTheLeastEnergy) {
  const Solution standing = travel(arch()).solution, hanging = travel(arch(), {}, 12).solution;
  ASSERT_EQ(standing.status, SolveStatus::converged) << standing.reason;
  ASSERT_EQ(hanging.status, SolveStatus::converged) << hanging.reason;
  EXPECT_EQ(standing.shapes.looks, 0);
  EXPECT_LT(hanging.energy, standing.energy);
  EXPECT_EQ(hanging.shapes.looks, 12);
  ASSERT_EQ(hanging.shapes.others.size(), 1u);
  const OtherShape& other = hanging.shapes.others[0];
  EXPECT_NEAR(other.distance, 2 * std::sqrt(1 - 0.81), 1e-3);
  EXPECT_EQ(other.furthest, "bars node 1");
  EXPECT_EQ(other.energy, standing.energy);
  EXPECT_GT(other.times, 0);
}

TEST(Journey, FindsNoOtherShapeOfAGearThatHasOne) {
  Scene scene = pressed_bars();
  scene.positions[6] = 2.2;  // pulled
  const Solution s = travel(scene, {}, 5).solution;
  EXPECT_EQ(s.shapes.looks, 5);
  EXPECT_EQ(s.shapes.times, 6);
  EXPECT_TRUE(s.shapes.others.empty());
}

/// A chain that is as stiff pressed as pulled, its ends near each other: many shapes, a long way to any.
Scene crumpled_chain(int bars) {
  Sketch s;
  s.scene.water = {0, 9.81};
  std::vector<std::uint32_t> chain;
  for (int i = 0; i <= bars; ++i)
    chain.push_back(s.node(0.02 * i, (i * 7 % 5) - 2.0, (i * 3 % 7) - 3.0, i % bars == 0 ? kAllAxes : 0));
  const Values more = {{"rope.diameter", 0.02}, {"rope.EA_compression", 1e6}};
  auto& part = s.rope("chain", chain, 1, 1e6);
  part.parameters.insert(more.begin(), more.end());
  return s.scene;
}

Solution look_as_suits(const Scene& scene, OwnStart own_start = {}) {
  return travel(scene, {}, JourneyOptions::kLooksThatSuit, std::move(own_start)).solution;
}

TEST(Journey, LooksForOtherShapesByItselfAfterALongWay) {
  Scene slack = arch(), far = crumpled_chain(60);
  slack.parts[0].parameters["rope.EA_compression"] = 0.0;
  const Solution s = look_as_suits(slack), t = look_as_suits(far);
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_EQ(t.status, SolveStatus::converged) << t.reason;
  EXPECT_LT(s.books.iterations, 100);
  EXPECT_EQ(s.shapes.looks, 0);
  EXPECT_GT(t.books.iterations, 100);
  EXPECT_GT(t.shapes.looks, 0);
}

/// Two heavy bars that hang in a plane, propped from below with a fifth of `EA`.
Scene propped_bars(double EA) {
  Sketch s;
  s.scene.water = {0, 9.81};
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, -0.43, kAxisY),
             c = s.node(1.8, 0, 0, kAllAxes), foot = s.node(0.9, 0, -1.236, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.diameter"] = 0.01;
  s.rope("prop", {foot, b}, 1, EA).parameters["rope.EA_compression"] = EA;
  return s.scene;
}

TEST(Journey, LooksForOtherShapesByItselfWhereMuchOfTheLoadIsPressed) {
  const OwnStart own{"own", true, [](const auto& from, double, auto&) { return std::optional(from); }};
  EXPECT_GT(look_as_suits(propped_bars(1)).shapes.looks, 0);
  EXPECT_EQ(look_as_suits(propped_bars(1e-3)).shapes.looks, 0);
  EXPECT_GT(look_as_suits(propped_bars(1e-3), own).shapes.looks, 0) << "it led past other shapes";
}

TEST(Journey, LooksForOtherShapesByItselfWhereAnOwnStartLedPastThem) {
  const OwnStart own{"own", true, [](const auto& from, double, auto&) { return std::optional(from); }};
  const Solution s = look_as_suits(arch(), own);
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_GT(s.shapes.looks, 0);
  EXPECT_EQ(s.shapes.others.size(), 1u) << "standing and hanging";
  Scene slack = arch();
  slack.parts[0].parameters["rope.EA_compression"] = 0.0;
  EXPECT_EQ(look_as_suits(slack, own).shapes.looks, 0) << "tension only has one energy";
  Scene hanging = arch();
  hanging.positions[5] = -0.43;
  const Solution taut = look_as_suits(hanging, own);
  EXPECT_EQ(taut.shapes.looks, 0) << "nothing is pressed";
  EXPECT_NEAR(taut.energy, s.energy, 1e-9 * std::abs(s.energy));
}

/// A heavy rope of 20 bars that is 10 percent too long, folded to one side, `EA` in newtons.
Scene slack_rope(double EA) {
  Sketch s;
  s.scene.water = {0, 9.81};
  std::vector<std::uint32_t> chain;
  for (int i = 0; i <= 20; ++i) chain.push_back(s.node(i, i % 2, 0.1 * i, i % 20 == 0 ? kAllAxes : 0));
  s.rope("rope", chain, 1.1, EA).parameters["rope.diameter"] = 0.02;
  return s.scene;
}

bool has_leg(const Solution& s, const std::string& name) {
  return std::any_of(s.legs.begin(), s.legs.end(), [&](const Leg& leg) { return leg.name == name; });
}

/// As its reason tells [N].
double residual_of(const Leg& leg) {
  const std::string before = "largest residual ";
  return std::stod(leg.reason.substr(leg.reason.find(before) + before.size()));
}

TEST(Journey, GoesFromSoftToStiffFirstWhereTheLoadBarelyStretchesWhatCarriesIt) {
  const Solution soft = travel(slack_rope(1e4)).solution, stiff = travel(slack_rope(1e10)).solution;
  ASSERT_EQ(soft.status, SolveStatus::converged) << soft.reason;
  ASSERT_EQ(stiff.status, SolveStatus::converged) << stiff.reason;
  EXPECT_TRUE(soft.legs.empty());
  ASSERT_FALSE(stiff.legs.empty());
  EXPECT_EQ(stiff.legs.front().name.substr(0, 9), "stiffness");
  EXPECT_EQ(stiff.legs[stiff.legs.size() - 2].name, "from soft to stiff");
}

// 4 ε x 1e10 N is 9e-6 N, which no position of a double can tell from balance.
TEST(Journey, EndsWhatStopsAtTheRoundOffOfItsPositionsWithMoreDigits) {
  const Solution s = travel(slack_rope(1e10)).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_EQ(s.legs.back().name, "with more digits");
  EXPECT_EQ(s.legs.back().status, SolveStatus::converged);
  EXPECT_LT(s.balance.residual, 0.1 * residual_of(s.legs[s.legs.size() - 2]));
}

TEST(Journey, GoesOnWhereItIsNearlyThereBeforeItTriesOtherWays) {
  Limits limits;
  limits.iterations = travel(slack_rope(1e4)).solution.books.iterations - 2;
  const Solution s = travel(slack_rope(1e4), limits).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_EQ(s.legs.size(), 2u);
  EXPECT_EQ(s.legs.front().status, SolveStatus::not_converged);
  EXPECT_EQ(s.legs.back().name, "as it is, further");
}

int times_further(const Limits& limits, const OwnStart& own) {
  const Solution s = travel(slack_rope(1e4), limits, 0, own, "lbfgs").solution;
  return static_cast<int>(std::count_if(s.legs.begin(), s.legs.end(),
                                        [](const Leg& leg) { return leg.name == "as it is, further"; }));
}

TEST(Journey, GoesOnAsOftenAsThatBringsItOn) {
  const OwnStart own{"own", true,
                     [](const auto&, double, auto&) { return std::optional<std::vector<double>>(); }};
  const int needed = travel(slack_rope(1e4), {}, 0, {}, "lbfgs").solution.books.iterations;
  for (const OwnStart& start : {OwnStart{}, own}) {
    int most = 0;
    Limits limits;
    for (limits.iterations = 2; limits.iterations < needed; ++limits.iterations)
      most = std::max(most, times_further(limits, start));
    EXPECT_GT(most, 1) << needed;
    EXPECT_LE(most, 5);
  }
}

TEST(Journey, TakesTheStartThatItsCallerKnowsBeforeItsOwnWaysIfThatIsToBeSoon) {
  const Scene scene = slack_rope(1e10);
  const std::vector<double> there = travel(scene).solution.u;
  Limits few;
  few.iterations = 2;
  std::array<std::size_t, 2> legs{};
  for (const bool soon : {true, false}) {
    const OwnStart own{"from elsewhere", soon, [&](const auto& from, double seconds, auto&) {
                         EXPECT_TRUE(from.empty());
                         EXPECT_GT(seconds, 0);
                         return std::optional(there);
                       }};
    const Solution s = travel(scene, few, 0, own).solution;
    ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
    EXPECT_TRUE(has_leg(s, "from elsewhere"));
    EXPECT_EQ(s.legs.back().name, "with more digits");
    legs[soon] = s.legs.size();
  }
  EXPECT_LT(legs[true], legs[false]);
}

TEST(Journey, MovesOffAPointThatIsNotStableWhereForcesHaveNoEnergy) {
  plugins();  // "test/load" and its like are among the shipped elements from here on
  const Scene scene = toppling_bar(0);
  const Solution s = travel(scene).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  ASSERT_FALSE(s.legs.empty());
  EXPECT_EQ(s.legs.front().status, SolveStatus::unstable) << "upright";
  EXPECT_TRUE(has_leg(s, "motion"));
  EXPECT_TRUE(s.growing.empty()) << "nothing grows any more";
  EXPECT_NEAR(*std::min_element(s.x.begin(), s.x.end()), -1.1, 1e-6) << "it hangs";
}

/// Of the first leg whose name begins so; that of all if there is none.
std::size_t place_of(const Solution& s, const std::string& name) {
  const auto leg =
      std::find_if(s.legs.begin(), s.legs.end(), [&](const Leg& l) { return l.name.starts_with(name); });
  return static_cast<std::size_t>(leg - s.legs.begin());
}

TEST(Journey, TellsOfWhatGoesRoundAndRoundAndDoesNotFollowItFurther) {
  plugins();
  const Solution s = travel(whirling_bar()).solution;
  const std::size_t motion = place_of(s, "motion");
  ASSERT_LT(motion, s.legs.size());
  EXPECT_NE(s.legs[motion].reason.find("does not come to rest"), std::string::npos) << s.legs[motion].reason;
  EXPECT_FALSE(has_leg(s, "from where it moves on to"));
  EXPECT_NE(s.status, SolveStatus::converged) << "nor pressed together to nothing";
  EXPECT_TRUE(s.is_restless);
  EXPECT_NE(s.reason.find("did not come to rest over 10 times its size"), std::string::npos) << s.reason;
  EXPECT_FALSE(travel(pushed_bar(5)).solution.is_restless);
}

// Its steps are shorter than those of a solver that looks for an equilibrium.
TEST(Journey, MovesOnForFiveStepsForEachIterationThatIsAllowed) {
  plugins();
  Limits few;
  few.iterations = 4;
  const Solution s = travel(whirling_bar(), few).solution;
  const std::size_t motion = place_of(s, "motion");
  ASSERT_LT(motion, s.legs.size());
  EXPECT_EQ(s.legs[motion].books.iterations, 20) << s.legs[motion].reason;
}

TEST(Journey, MovesWhatIsStiffOnlyAfterItWasSofter) {
  plugins();
  Limits few;
  few.iterations = 2;
  for (const double EA : {1e2, 1e6}) {
    Scene scene = slack_rope(EA);
    scene.parts.push_back(toppling_bar(0).parts.back());  // a force without an energy, here of 0 N
    const Solution s = travel(scene, few).solution;
    const std::size_t soft = place_of(s, "stiffness"), motion = place_of(s, "motion");
    ASSERT_LT(motion, s.legs.size());
    EXPECT_EQ(soft < motion, EA == 1e6) << EA;
  }
}

TEST(Journey, AddsUpWhatAllItsLegsCost) {
  const Solution s = travel(pressed_bars()).solution;
  int factorisations = 0;
  for (const Leg& leg : s.legs) factorisations += leg.books.factorisations;
  EXPECT_EQ(s.books.factorisations, factorisations);
}

TEST(Journey, IsOneSolveWhereThatArrives) {
  Scene scene = pressed_bars();
  scene.positions[6] = 2.2;  // pulled
  const Travelled t = travel(scene);
  EXPECT_EQ(t.solution.status, SolveStatus::converged);
  EXPECT_TRUE(t.solution.legs.empty());
}

TEST(Journey, SaysSoWhereTimeIsUp) {
  Limits limits;
  limits.seconds = 0;
  EXPECT_NE(travel(pressed_bars(), limits).solution.status, SolveStatus::converged);
}

/// A float at the head of a pressed spring, pushed sideways, in a current in which it flutters
/// (growth_test.cpp); a load holds it in balance.
Scene fluttering_float() {
  Sketch s;
  s.scene.water.gravity = 0;
  s.scene.current.samples = {{0, {1, 0, 0}}};
  const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(std::sqrt(0.55), 0, 0, 1 << 2);
  s.part("spring", "test/spring", {{"k", 1000.0}}, {foot, head}).data["rest_length"] = {1};
  s.part("push", "test/follower", {{"k", 200.0}}, {foot, head}).data["rest_length"] = {1};
  s.part("float", "float/float", {{"float.buoyancy", 10.0}, {"float.diameter", 0.2}}, {head})
      .data["pieces"] = {1};
  Assembled unloaded(s.scene);
  const auto r = unloaded.residual(unloaded.assembler.start());
  s.part("load", "test/load", {{"x", r[0]}, {"y", r[1]}}, {head});
  return s.scene;
}

TEST(Journey, TellsOfFlutterAndDoesNotWaitForItToComeToRest) {
  const Solution s = travel(fluttering_float()).solution;
  EXPECT_EQ(s.legs.front().status, SolveStatus::unstable) << s.legs.front().reason;
  EXPECT_NE(s.legs.front().reason.find("swinging with a period of"), std::string::npos)
      << s.legs.front().reason;
  EXPECT_FALSE(has_leg(s, "motion"));
}

}  // namespace
}  // namespace netloft::test
