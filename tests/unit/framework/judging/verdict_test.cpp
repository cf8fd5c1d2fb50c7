// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

Solved solve_sketch(const Scene& scene, Solving how = {}) {
  plugins();  // makes the element "test/load" known
  return solve(scene, how);
}

Solving classic(int iterations = 50) {
  Solving how;
  how.solver_parameters = {{"method", std::string("classic")}};
  how.limits.iterations = iterations;
  return how;
}

bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

/// A bar of 1 m on a fixed foot, loaded at its head along z. It is as stiff in compression as in tension.
Scene bar_on_end(double load, double height = 1) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(0, 0, height);
  s.rope("bar", {foot, head}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"z", load}}, {head});
  return s.scene;
}

TEST(Verdict, CallsABarThatIsPulledStable) {
  const Solved s = solve_sketch(bar_on_end(100));
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_EQ(s.solution.stability, Stability::stable);
  EXPECT_NEAR(s.position(1)[2], 1.01, 1e-10);
  EXPECT_NEAR(s.solution.energy, 0.5 * 100 * 0.01 - 100 * 1.01, 1e-9);
  EXPECT_NEAR(s.reaction(0)[2], -100, 1e-7);
}

TEST(Verdict, CallsABarThatStandsUnderALoadUnstable) {
  const Solved s = solve_sketch(bar_on_end(-100));
  EXPECT_NEAR(s.position(1)[2], 0.99, 1e-9);
  EXPECT_EQ(s.solution.status, SolveStatus::unstable);
  EXPECT_EQ(s.solution.stability, Stability::unstable);
  EXPECT_TRUE(contains(s.solution.reason, "not a stable one")) << s.solution.reason;
  EXPECT_TRUE(contains(s.solution.reason, "bar node 1")) << s.solution.reason;
}

TEST(Verdict, CallsWhatTheClassicMethodFindsThereUnstableToo) {
  const Solved s = solve_sketch(bar_on_end(-100, 0.995), classic());
  EXPECT_EQ(s.solution.status, SolveStatus::unstable) << s.solution.reason;
}

/// A solver that sets the last unknown to `given_up_at`, and reports that no step reduces the residual.
double given_up_at = 0;
SolverType quitter() {
  SolverType type;
  type.type = "quitter/quitter";
  type.solver.solve = [](const void*, netloft_problem* p) -> int {
    p->u[p->unknowns - 1] = given_up_at;
    return NETLOFT_STEP_TOO_SHORT;
  };
  return type;
}

Solution given_up(const Scene& scene, double u) {
  Assembled a(scene);
  given_up_at = u;
  const SolverType type = quitter();
  return solve_static({a.scene, a.assembler, make_factorisation}, {&type}, {.tolerance = 1e-8});
}

/// Two bars side by side; only the second may move, along z. The first carries 100 N and is in equilibrium at
/// 1.01 m. The second has a stiffness of 1e8 N when taut and 1 N when slack, and carries 50 µN.
Scene stiff_bar_beside_a_load() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto nail = s.node(0, 0, 0, kAllAxes), weight = s.node(0, 0, -1.01, kAllAxes);
  s.rope("bar", {nail, weight}, 1, 1e4);
  const auto other = s.node(1, 0, 0, kAllAxes), head = s.node(1, 0, -1, 3);
  s.rope("stiff", {other, head}, 1, 1e8).parameters["rope.EA_compression"] = 1.0;
  s.part("load", "test/load", {{"z", -5e-5}}, {head});
  return s.scene;
}

TEST(Verdict, DoesNotTakeASolversWordThatNoStepLeadsOn) {
  for (const double off : {1e-3, 1e-5, 5e-8, 1e-9}) {  // the residual is 1e4 N/m × off
    const Solution s = given_up(bar_on_end(100), 0.01 + off);
    EXPECT_EQ(s.status, SolveStatus::not_converged) << off << ": " << s.reason;
  }
}

// The second bar is slack by 50 µm and carries −50 µN. The imbalance is 1e-4 N, 1e-6 of the largest load. A
// step of 0.1 mm, computed with the slack stiffness, makes it taut with 5000 N and would gain 5e-9 J.
TEST(Verdict, SeesThatAFlickeringTwineHasNothingToGain) {
  const Solution s = given_up(stiff_bar_beside_a_load(), 5e-5);
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_TRUE(contains(s.reason, "no step brings the gear closer")) << s.reason;
  EXPECT_NEAR(s.balance.residual, 1e-4, 1e-9);
  EXPECT_EQ(given_up(stiff_bar_beside_a_load(), 5e-4).status, SolveStatus::not_converged)
      << "too much to gain";
}

TEST(Verdict, CallsSlackRopeNeutral) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.5, 0, 0), c = s.node(1, 0, 0, kAllAxes);
  s.rope("rope", {a, b, c}, 0.9).parameters["rope.EA_compression"] = 0.0;
  const Solved solved = solve_sketch(s.scene);
  EXPECT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  EXPECT_EQ(solved.solution.stability, Stability::neutral);
  EXPECT_TRUE(contains(solved.solution.reason, "slack")) << solved.solution.reason;
}

Scene bar_with_a_follower() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0, 0, -1.5);
  s.rope("bar", {top, end}, 1, 100);
  s.part("load", "test/load", {{"z", -50.0}}, {end});
  s.part("push", "test/follower", {{"k", 1.0}}, {top, end}).data["rest_length"] = {1};
  return s.scene;
}

// In still water, which does not damp small oscillations, the follower force would make the bar oscillate.
TEST(Verdict, CallsStableWhereNothingGrowsWithoutAnEnergy) {
  Scene scene = bar_with_a_follower();
  scene.current.samples = {{0, {0, 0, -4}}};
  const Solution s = solve_sketch(scene).solution;
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_EQ(s.stability, Stability::stable);
  EXPECT_GT(s.judging.factorisations, 0) << "what judging takes is counted";
}

// Two points count as one equilibrium if their distance is not larger than the sum of their estimated errors.
TEST(Verdict, AsksOnceForTheStabilityOfOneEquilibrium) {
  Scene scene = bar_with_a_follower();
  scene.current.samples = {{0, {0, 0, -4}}};
  Solving how;
  how.limits.tolerance = 1e-6;
  const std::vector<double> loose = solve_sketch(scene, how).solution.u,
                            tight = solve_sketch(scene).solution.u;
  ASSERT_NE(loose, tight);
  Assembled a(scene);
  JudgedPoint judged;
  const Limits limits{.tolerance = 1e-6, .judging = {.known = &judged}};
  const auto asked = [&](std::span<const double> u) {
    const Assessment found = assess_static({a.scene, a.assembler, make_factorisation}, u, limits);
    EXPECT_EQ(found.stability, Stability::stable);
    return found.judging.solves > 1;  // one of them is for the distance from the equilibrium
  };
  EXPECT_TRUE(asked(loose));
  EXPECT_FALSE(asked(loose));
  EXPECT_FALSE(asked(tight));
  judged.assessment.correction.length = 0;
  EXPECT_TRUE(asked(tight));
  EXPECT_EQ(judged.assessment.x, assess_static({a.scene, a.assembler, make_factorisation}, tight, {}).x);
}

TEST(Verdict, KnowsNoStabilityWithoutAnEnergyIfItMustNotAsk) {
  Solving how;
  how.limits.judging.examine_growth = false;
  const Solution s = solve_sketch(bar_with_a_follower(), how).solution;
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_EQ(s.stability, Stability::unknown);
}

TEST(Verdict, NamesWhatGrowsWhereForcesHaveNoEnergy) {
  const Solved s = solve_with("newton", toppling_bar(0), {}, {});
  ASSERT_EQ(s.solution.status, SolveStatus::unstable) << s.solution.reason;
  ASSERT_EQ(s.solution.growing.mode.size(), 3u);
  EXPECT_NEAR(s.solution.growing.mode[2], 0, 1e-6) << "it topples, and does not shorten";
}

TEST(Verdict, JudgesAPointThatNoSolverIsBehind) {
  Assembled a(bar_on_end(100));
  std::vector<double> u(a.plan.unknowns, 0.0);
  EXPECT_EQ(assess_static({a.scene, a.assembler, make_factorisation}, u, {}).status,
            SolveStatus::not_converged);
  u.back() = 0.01;
  const Assessment found = assess_static({a.scene, a.assembler, make_factorisation}, u, {});
  EXPECT_EQ(found.status, SolveStatus::converged) << found.reason;
  EXPECT_EQ(found.stability, Stability::stable);
}

/// A solver that needs forces with a potential, and must not be called if they have none.
bool was_called = false;
SolverType wants_an_energy() {
  SolverType type;
  type.type = "choosy/choosy";
  type.solver.needs = NETLOFT_CONSERVATIVE;
  type.solver.solve = [](const void*, netloft_problem*) -> int {
    was_called = true;
    return NETLOFT_STOPPED;
  };
  return type;
}

TEST(Verdict, SaysWhyASolverIsUnfit) {
  EXPECT_FALSE(why_unfit(wants_an_energy(), NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC));
  const auto why = why_unfit(wants_an_energy(), NETLOFT_SYMMETRIC);
  ASSERT_TRUE(why);
  EXPECT_TRUE(contains(*why, "choosy/choosy needs a problem that is conservative")) << *why;
}

TEST(Verdict, DoesNotStartASolverThatIsUnfit) {
  was_called = false;
  Assembled a(bar_with_a_follower());
  const SolverType type = wants_an_energy();
  const Solution s = solve_static({a.scene, a.assembler, make_factorisation}, {&type}, {});
  EXPECT_FALSE(was_called);
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(s.reason, "conservative")) << s.reason;
  EXPECT_EQ(s.cost.statistics.residuals + s.judging.residuals, 0) << "nothing is computed";
  EXPECT_EQ(s.x, a.assembler.start());
}

/// A bar of 1 m hung far from the origin with 3 N at its end.
Scene far_bar(double EA, double distance) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(distance, distance, distance, kAllAxes),
             end = s.node(distance, distance, distance - 1 - 3 / EA);
  s.rope("bar", {top, end}, 1, EA);
  s.part("load", "test/load", {{"z", -3.0}}, {end});
  return s.scene;
}

// Over ten decades of stiffness and of distance, with every offset of the end that could be rounding error,
// each converged result is in balance to a thousandth of its load.
TEST(Verdict, NeverTakesAResidualThatMattersForBalance) {
  int converged = 0, refused = 0;
  for (int stiffness = 5; stiffness <= 15; ++stiffness)
    for (int distance = 0; distance <= 10; ++distance)
      for (const double offset : {0.0, 1.0, -3.0, 20.0}) {
        Assembled a(far_bar(std::pow(10, stiffness), std::pow(10, distance)));
        const std::vector<double> u{0, 0, offset * 1e-16 * std::pow(10, distance)};
        const Assessment s = assess_static({a.scene, a.assembler, make_factorisation}, u, {});
        if (s.status == SolveStatus::not_converged) {
          ++refused;
          continue;
        }
        ++converged;
        EXPECT_LE(s.balance.residual, 1e-3 * 3) << s.reason;
        EXPECT_LE(s.balance.floor, 1e-3 * s.balance.scale) << s.reason;
      }
  EXPECT_GT(converged, 50) << "soft and near ones do converge";
  EXPECT_GT(refused, 50) << "stiff and far ones do not";
}

// The load acts along the rope: 1e15 N/m times the rounding error of 6 m is several newtons.
TEST(Verdict, DoesNotCallARopeConvergedThatIsTooStiffForItsLoad) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), middle = s.node(0, 0, -3), end = s.node(0, 0, -6, kAllAxes);
  s.rope("rope", {top, middle, end}, 3, 1e15);
  s.part("load", "test/load", {{"z", -3.0}}, {middle});
  const Solution found = solve_sketch(s.scene).solution;
  EXPECT_EQ(found.status, SolveStatus::not_converged) << found.reason;
  EXPECT_TRUE(contains(found.reason, "stiffness of the gear is too high")) << found.reason;
}

TEST(Verdict, HasNothingToFindWhereAllIsHeld) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.1, 0, 0, kAllAxes);
  s.rope("rope", {a, b}, 1, 100);
  for (const bool as_published : {false, true}) {
    const Solved solved = solve_sketch(s.scene, as_published ? classic() : Solving{});
    EXPECT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
    EXPECT_NEAR(solved.reaction(1)[0], 10, 1e-12);
  }
}

TEST(Verdict, NamesTheLimitThatWasReached) {
  Solving how;
  how.limits.iterations = 3;
  Solved s = solve_sketch(sample::hanging_panel(4, 34), how);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(s.solution.reason, "limit of 3 iterations")) << s.solution.reason;
  EXPECT_TRUE(contains(s.solution.at_fault, "net node")) << s.solution.at_fault;
  EXPECT_EQ(s.solution.cost.statistics.iterations, 3);
  EXPECT_EQ(s.solution.run.history.size(), 4u);

  how.limits = {};
  how.limits.seconds = 0;
  s = solve_sketch(sample::hanging_panel(4, 34), how);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(s.solution.reason, "time limit")) << s.solution.reason;

  const std::atomic<bool> interrupt{true};
  how.limits = {};
  how.limits.interrupt = &interrupt;
  s = solve_sketch(sample::hanging_panel(4, 34), how);
  EXPECT_EQ(s.solution.status, SolveStatus::interrupted);
  EXPECT_TRUE(contains(s.solution.reason, "interrupted")) << s.solution.reason;
}

TEST(Verdict, JudgesTheStartWhenNoIterationIsAllowed) {
  Solving how;
  how.limits.iterations = 0;
  const Solved s = solve_sketch(sample::hanging_panel(4, 34), how);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_EQ(s.solution.x, s.assembler->start());
}

TEST(Verdict, NamesTheNodeWhereTheTangentIsSingular) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  s.rope("bar", {a, b}, 1);  // exactly unstretched, so that it has no lateral stiffness
  s.part("load", "test/load", {{"z", -1.0}}, {b});
  const Solved solved = solve_sketch(s.scene, classic());
  EXPECT_EQ(solved.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(solved.solution.reason, "singular")) << solved.solution.reason;
  EXPECT_TRUE(contains(solved.solution.reason, "bar node 1")) << solved.solution.reason;
  EXPECT_EQ(solved.solution.at_fault, "bar node 1");
}

/// A factorisation that fails because there is not enough memory.
class WithoutRoom final : public Factorisation {
 public:
  std::string description() const override { return "without room"; }
  void analyse(const SparsePattern&) override {}
  FactorResult factorise(std::span<const double>) override { return {FactorStatus::out_of_memory}; }
  void solve(std::span<const double>, std::span<double>) override {}
  void solve_transposed(std::span<const double>, std::span<double>) override {}
};

TEST(Verdict, SaysThatMemoryIsWantedAndNotThatTheTangentIsSingular) {
  Solving how;
  how.make = [](MatrixClass) { return std::make_unique<WithoutRoom>(); };
  const Solved s = solve_sketch(sample::hanging_panel(4, 34), how);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(s.solution.reason, "not enough memory")) << s.solution.reason;
  EXPECT_FALSE(contains(s.solution.reason, "singular")) << s.solution.reason;
}

TEST(Verdict, NamesTheElementThatHasNoForceAtTheStart) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(2, 0, 0);
  s.part("picky", "test/picky", {{"limit", 1.0}}, {a, b}).data["rest_length"] = {1};
  const Solved solved = solve_sketch(s.scene);
  EXPECT_EQ(solved.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(solved.solution.reason, "picky element 0")) << solved.solution.reason;
  EXPECT_TRUE(contains(solved.solution.reason, "longer than its limit")) << solved.solution.reason;
  EXPECT_EQ(solved.solution.at_fault, "picky element 0");
}

// The force of the spring grows with the third power of its length: undamped steps of a bar far out of
// balance overflow.
TEST(Verdict, SaysThatForcesOverflowedAndWhere) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.000001, 0, 0);
  s.part("spring", "test/spring", {{"k", 1.0}}, {a, b}).data["rest_length"] = {1};
  s.part("load", "test/load", {{"y", 1e200}}, {b});
  const Solved solved = solve_sketch(s.scene, classic());
  EXPECT_EQ(solved.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(contains(solved.solution.reason, "overflow")) << solved.solution.reason;
  EXPECT_TRUE(contains(solved.solution.at_fault, "node 1")) << solved.solution.at_fault;
}

// Forces of 1e200 N are finite, but their squares are not: an infinite load must not excuse an infinite
// residual.
TEST(Verdict, CallsNothingBalancedThatIsInfinite) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1.1, 0, 0);
  s.part("spring", "test/spring", {{"k", 1.0}}, {a, b}).data["rest_length"] = {1};
  s.part("load", "test/load", {{"x", 1e200}}, {b});
  Solving how = classic();
  how.limits.iterations = 0;
  EXPECT_EQ(solve_sketch(s.scene, how).solution.status, SolveStatus::not_converged);
}

TEST(Verdict, KeepsTheResidualOfThePlaceItReports) {
  const Solved s = solve_sketch(sample::hanging_panel(8, 34));
  ASSERT_EQ(s.solution.status, SolveStatus::converged);
  std::vector<double> residual(s.solution.x.size());
  double energy = 0;
  ASSERT_TRUE(s.assembler->evaluate(s.solution.x, {.energy = &energy, .residual = residual.data()}));
  EXPECT_EQ(s.solution.residual, residual);
  EXPECT_EQ(s.solution.energy, energy);
  EXPECT_EQ(s.solution.run.history.size(),
            static_cast<std::size_t>(s.solution.cost.statistics.iterations) + 1);
}

TEST(Verdict, FindsTheSameBitsWithOneTwoAndThreeThreads) {
  Solving how;
  const Solved one = solve_sketch(sample::hanging_panel(48, 34), how);
  ASSERT_EQ(one.solution.status, SolveStatus::converged);
  for (const int threads : {2, 3}) {
    how.threads = threads;
    const Solved more = solve_sketch(sample::hanging_panel(48, 34), how);
    EXPECT_EQ(more.assembler->threads_used(), threads);
    EXPECT_EQ(one.solution.x, more.solution.x);
    EXPECT_EQ(one.solution.residual, more.solution.residual);
    EXPECT_EQ(one.solution.energy, more.solution.energy);
    EXPECT_EQ(one.solution.cost.statistics.iterations, more.solution.cost.statistics.iterations);
  }
}

}  // namespace
}  // namespace netloft::test
