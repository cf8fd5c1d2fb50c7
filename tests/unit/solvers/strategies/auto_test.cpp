// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "framework/search/search.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m, as stiff in compression as in tension, straight between ends that are 1.8 m apart.
Scene compressed_bars() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, 0), c = s.node(1.8, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  return s.scene;
}

struct Found {
  Solution solution;
  double away = 0;  // of node 1 from the line [m]
};

Found find(const Scene& scene, const Values& parameters = {}, Limits limits = {}, double work = 5000,
           const char* strategy = "auto") {
  Registry& registry = shipped_plugins();
  const ScenePlan plan = make_scene_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  SearchOptions options;
  options.solver.type = &registry.solver("newton"), options.limits = limits, options.work = work;
  Found f{find_equilibrium({&scene, &assembler, &registry, nullptr, make_factorisation}, options,
                           {&registry.strategy(strategy), parameters}),
          0};
  const auto at = [&](int axis) { return f.solution.x[assembler.numbering().dof(1, axis).at()]; };
  f.away = std::hypot(at(1), at(2));
  return f;
}

bool has_stage(const Solution& s, const std::string& name) {
  return std::any_of(s.cost.stages.begin(), s.cost.stages.end(),
                     [&](const StageRecord& stage) { return stage.name == name; });
}

/// The stages of a solution, as text for messages of tests.
std::string stages_of(const Solution& s) {
  std::string text;
  for (const StageRecord& stage : s.cost.stages)
    text += "\n" + stage.name + " by " + stage.solver + ": " + name_of(stage.status) + ", work " +
            std::to_string(stage.work) + ", " + stage.reason;
  return text;
}

TEST(Auto, LeavesAnEquilibriumThatIsNotStable) {
  const Found f = find(compressed_bars());
  EXPECT_EQ(f.solution.status, SolveStatus::converged) << f.solution.reason << stages_of(f.solution);
  EXPECT_NEAR(f.away, std::sqrt(1 - 0.81), 1e-6) << "the bars buckle until nothing compresses them";
}

/// The scene also has a stretched bar between held ends, which stores so much energy that rounding hides the
/// gain of every step.
TEST(Auto, LeavesASaddleWhereEnergiesCanNoLongerBeToldApart) {
  constexpr double kShort = 1e-5;
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 1e-3, 0), c = s.node(2 - kShort, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"x", 0.1}}, {b});
  const auto from = s.node(0, 5, 0, kAllAxes), to = s.node(1.5, 5, 0, kAllAxes);
  s.rope("stretched", {from, to}, 1, 1e4);
  plugins();
  const Found f = find(s.scene);
  EXPECT_EQ(f.solution.status, SolveStatus::converged) << f.solution.reason << stages_of(f.solution);
  EXPECT_GT(f.solution.energy, 1e3);
  EXPECT_NEAR(f.away, std::sqrt(kShort), 1e-2 * std::sqrt(kShort)) << "by Pythagoras";
}

/// The two bars of compressed_bars() as an arch in a plane, under a small load.
Scene arch() {
  Scene scene = compressed_bars();
  scene.water = {0, 9.81};
  scene.positions[5] = 0.43;
  scene.held[1] = kAxisY;
  scene.parts[0].parameters["rope.diameter"] = 0.01;
  return scene;
}

TEST(Auto, FindsTheOtherShapesOfAGearAndKeepsThatOfTheLeastEnergy) {
  const Values direct_only{{"without", std::string("tension-stages")}, {"restarts", std::int64_t{12}}};
  Values none = direct_only;
  none["restarts"] = std::int64_t{0};
  const Solution standing = find(arch(), none).solution, hanging = find(arch(), direct_only).solution;
  ASSERT_EQ(standing.status, SolveStatus::converged) << standing.reason;
  ASSERT_EQ(hanging.status, SolveStatus::converged) << hanging.reason;
  EXPECT_EQ(standing.shapes.restarts, 0);
  EXPECT_LT(hanging.energy, standing.energy);
  ASSERT_EQ(hanging.shapes.others.size(), 1u);
  const OtherShape& other = hanging.shapes.others[0];
  EXPECT_NEAR(other.distance, 2 * std::sqrt(1 - 0.81), 1e-3);
  EXPECT_EQ(other.furthest, "bars node 1");
  EXPECT_NEAR(other.energy, standing.energy, 1e-12) << "of what was found again, the one closest to balance";
}

TEST(Auto, DoesNotRestartWhereNothingIsInCompression) {
  Scene taut = compressed_bars(), slack = arch();
  taut.positions[6] = 2.2;
  slack.parts[0].parameters["rope.EA_compression"] = 0.0;
  for (const Scene& scene : {taut, slack}) {
    const Solution s = find(scene).solution;
    EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
    EXPECT_FALSE(has_stage(s, "restart"));
  }
}

/// A heavy rope of 20 bars that is 10 per cent longer than the distance of its ends, folded to one side; EA
/// [N].
Scene slack_rope(double EA) {
  Sketch s;
  s.scene.water = {0, 9.81};
  std::vector<std::uint32_t> chain;
  for (int i = 0; i <= 20; ++i) chain.push_back(s.node(i, i % 2, 0.1 * i, i % 20 == 0 ? kAllAxes : 0));
  s.rope("rope", chain, 1.1, EA).parameters["rope.diameter"] = 0.02;
  return s.scene;
}

// The rounding of positions changes forces by 4 ε x 1e10 N = 9e-6 N, so that doubles cannot balance them
// better.
TEST(Auto, EndsWhatStopsAtTheRoundOffOfItsPositionsWithCompensatedOnes) {
  const Solution s = find(slack_rope(1e10)).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_TRUE(has_stage(s, "with compensated positions")) << stages_of(s);
  EXPECT_LT(s.balance.residual, 9e-6) << "what plain positions leave";
}

TEST(Auto, LeavesOutWhatItIsTold) {
  const Values without{{"without", std::string("tension-stages+direct")}};
  const Solution s = find(slack_rope(1e4), without).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_TRUE(has_stage(s, "from soft to stiff"));
  EXPECT_FALSE(has_stage(s, "as it is"));
}

// An interrupt is reported even if no stage of the scene itself was running.
TEST(Strategies, SayThatTheyWereInterrupted) {
  const std::atomic<bool> interrupt{true};
  Limits limits;
  limits.interrupt = &interrupt;
  for (const char* strategy : {"auto", "direct", "relaxed", "stiffness-steps", "pseudo-time"}) {
    const Solution s = find(slack_rope(1e4), {}, limits, 5000, strategy).solution;
    EXPECT_EQ(s.status, SolveStatus::interrupted) << strategy << ": " << s.reason;
    EXPECT_NE(s.reason.find("interrupted"), std::string::npos) << strategy << ": " << s.reason;
  }
}

TEST(Auto, RefusesToLeaveOutWhatItDoesNotHave) {
  try {
    find(slack_rope(1e4), {{"without", std::string("restarts+nonsense")}});
    FAIL() << "it was accepted";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("\"nonsense\" is not one of restarts"), std::string::npos)
        << e.what();
  }
}

TEST(Auto, MovesOffAnEquilibriumThatIsNotStableWhereForcesHaveNoEnergy) {
  plugins();  // registers elements for tests, such as "test/load"
  const Solution s = find(toppling_bar(0), {{"without", std::string("tension-stages")}}).solution;
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_TRUE(has_stage(s, "moved away from an unstable equilibrium")) << stages_of(s);
  EXPECT_TRUE(s.growing.mode.empty()) << "nothing grows any more";
  EXPECT_NEAR(*std::min_element(s.x.begin(), s.x.end()), -1.1, 1e-6) << "it hangs";
}

/// Two upright bars, each on a foot, loaded by 10 N and `second` newtons.
Scene two_toppling_bars(double second) {
  Sketch s;
  s.scene.water.gravity = 0;
  for (const double load : {10.0, second}) {
    const double y = load == 10 ? 0 : 5;
    const auto foot = s.node(0, y, 0, kAllAxes), top = s.node(0, y, 1 - load / 100);
    const std::string name = load == 10 ? "first" : "second";
    s.rope(name, {foot, top}, 1, 100).parameters["rope.EA_compression"] = 100.0;
    s.part(name + "-load", "test/load", {{"z", -load}}, {top});
    s.part(name + "-push", "test/follower", {{"k", 0.0}}, {foot, top}).data["rest_length"] = {1};
  }
  return s.scene;
}

// The path away from one unstable equilibrium leads to another one.
TEST(Auto, MovesOffOncePerThingThatGrows) {
  plugins();
  for (const double second : {5.0, 10.001, 20.0}) {
    const Solution s = find(two_toppling_bars(second), {{"without", std::string("tension-stages")}}).solution;
    ASSERT_EQ(s.status, SolveStatus::converged) << second << s.reason << stages_of(s);
    EXPECT_NEAR(*std::min_element(s.x.begin(), s.x.end()), -1 - std::max(10.0, second) / 100, 1e-6);
    EXPECT_EQ(std::count_if(s.x.begin(), s.x.end(), [](double x) { return x < -1; }), 2) << "both hang";
  }
}

// The bar bears compression only: it is unstable, and nothing holds its load after it has toppled.
TEST(Auto, LeavesAnUnstableEquilibriumOnceToEachSide) {
  plugins();
  Scene scene = toppling_bar(0);
  scene.parts.front().parameters["rope.EA"] = 1e-6;
  const Solution s = find(scene).solution;
  EXPECT_EQ(s.status, SolveStatus::unstable) << s.reason << stages_of(s);
  const auto left = std::count_if(s.cost.stages.begin(), s.cost.stages.end(), [](const StageRecord& stage) {
    return stage.name == "moved away from an unstable equilibrium";
  });
  EXPECT_EQ(left, 2) << stages_of(s);
}

// The second bar topples faster than the first and then hangs, so that the slower growth of the first bar
// remains. The first bar bears compression only, and has no stable equilibrium.
TEST(Auto, ReportsTheUnstableEquilibriumThatGrowsMostSlowly) {
  plugins();
  Scene scene = two_toppling_bars(20);
  scene.parts.front().parameters["rope.EA"] = 1e-6;
  const Solution s = find(scene, {{"without", std::string("tension-stages")}}).solution;
  EXPECT_EQ(s.status, SolveStatus::unstable) << s.reason << stages_of(s);
  EXPECT_NEAR(*std::min_element(s.x.begin(), s.x.end()), -1.2, 1e-6) << stages_of(s);
}

TEST(Auto, SaysOfWhatGoesRoundAndRoundThatItDoesNotSettle) {
  plugins();
  const Solution s = find(whirling_bar()).solution;
  EXPECT_NE(s.status, SolveStatus::converged);
  EXPECT_TRUE(s.does_not_settle) << stages_of(s);
  EXPECT_NE(s.reason.find("did not come to rest"), std::string::npos) << s.reason;
}

TEST(Auto, DoesNotConvergeWithoutTime) {
  Limits limits;
  limits.seconds = 0;
  EXPECT_NE(find(compressed_bars(), {}, limits).solution.status, SolveStatus::converged);
}

TEST(Auto, DoesTheSameStagesWithTheSameBitsAgain) {
  const Solution a = find(slack_rope(1e6)).solution, b = find(slack_rope(1e6)).solution;
  ASSERT_EQ(a.cost.stages.size(), b.cost.stages.size());
  EXPECT_EQ(a.cost.work, b.cost.work);
  EXPECT_EQ(a.x, b.x);
}

TEST(EveryStrategy, FindsTheShapeOfASlackRope) {
  const double energy = find(slack_rope(1e4)).solution.energy;
  for (const char* strategy :
       {"direct", "stiffness-steps", "pseudo-time", "relaxed", "tension/only", "tension/stages"}) {
    const Solution s = find(slack_rope(1e4), {}, {}, 5000, strategy).solution;
    EXPECT_EQ(s.status, SolveStatus::converged) << strategy << ": " << s.reason;
    EXPECT_NEAR(s.energy, energy, 1e-9 * std::abs(energy)) << strategy;
  }
}

}  // namespace
}  // namespace netloft::test
