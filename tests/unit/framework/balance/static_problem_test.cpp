// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/static_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/factorisation/make_factorisation.hpp"
#include "solvers/factorisation/mumps.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// A taut chain of four bars below a fixed top, with a load at its end.
Sketch hanging_chain() {
  Sketch s;
  std::vector<std::uint32_t> chain{s.node(0, 0, 0, kAllAxes)};
  for (int i = 1; i <= 4; ++i) chain.push_back(s.node(0.1 * i, 0.05 * i * i, -1.2 * i));
  s.rope("chain", chain, 1);
  s.part("load", "test/load", {{"z", -500.0}}, {chain[4]});
  return s;
}

/// The chain of hanging_chain() with a last bar that is shorter than its rest length: it is in compression,
/// without lateral support.
Scene pressed_chain() {
  Sketch s = hanging_chain();
  s.scene.positions[3 * 4 + 2] = -3.7;
  s.scene.parts[0].parameters["rope.EA_compression"] = 1e4;
  return s.scene;
}

/// The functions of a problem, called as a solver calls them.
struct Called {
  explicit Called(Scene scene, Limits limits = {}, const std::function<void(ScenePlan&)>& change = {})
      : assembled(std::move(scene), 1, change),
        problem(assembled.assembler, make_factorisation, limits),
        p(problem.interface()) {}

  int evaluate(std::uint32_t want) {
    residual.resize(p.unknowns);
    return p.evaluate(p.host, want, p.u, &energy, residual.data());
  }
  std::vector<double> multiply(int matrix, double shift, const std::vector<double>& x) {
    std::vector<double> y(x.size());
    EXPECT_EQ(p.multiply(p.host, matrix, shift, x.data(), y.data()), NETLOFT_OK);
    return y;
  }
  std::vector<double> solve(const std::vector<double>& rhs) {
    std::vector<double> x(rhs.size());
    EXPECT_EQ(p.solve(p.host, rhs.data(), x.data()), NETLOFT_OK);
    return x;
  }
  int progress() { return p.progress(p.host, p.u, energy, residual.data(), "note"); }

  Assembled assembled;
  StaticProblem problem;
  netloft_problem& p;
  double energy = 0;
  std::vector<double> residual;
};

TEST(StaticProblem, EvaluatesWhatTheAssemblerDoes) {
  Called c(hanging_chain().scene);
  for (std::size_t i = 0; i < c.p.unknowns; ++i) c.p.u[i] = 0.01 * static_cast<double>(i);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE), NETLOFT_OK);
  auto x = c.assembled.assembler.start();
  for (std::size_t i = 0; i < c.p.unknowns; ++i) x[i] += c.p.u[i];
  EXPECT_EQ(c.energy, c.assembled.energy(x));
  auto whole = c.assembled.residual(x);
  whole.resize(c.p.unknowns);
  EXPECT_EQ(c.residual, whole);
}

TEST(StaticProblem, EvaluatesResidualAndGradientAtOnceToTheBitOfTwoEvaluations) {
  Sketch s = hanging_chain();
  s.part("push", "test/follower", {{"k", 300.0}}, {1, 2, 2, 3}).data["rest_length"] = {1, 1};
  Called c(s.scene);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE), NETLOFT_OK);
  const auto whole = c.residual;
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE | NETLOFT_WANT_GRADIENT), NETLOFT_OK);
  const auto conservative = c.residual;
  ASSERT_NE(whole, conservative);
  const int before = c.problem.statistics().residuals;
  double energy = 0;
  std::vector<double> residual(c.p.unknowns), gradient(c.p.unknowns);
  ASSERT_EQ(c.p.evaluate_both(c.p.host, c.p.u, &energy, residual.data(), gradient.data()), NETLOFT_OK);
  EXPECT_EQ(residual, whole);
  EXPECT_EQ(gradient, conservative);
  EXPECT_EQ(energy, c.energy);
  EXPECT_EQ(c.problem.statistics().residuals, before + 1);
}

/// A step of length h that begins with displacements u0. The unknowns are the displacements m of its middle,
/// with rates v = 2 m/h and a = 4 m/h².
struct MeanForceStep {
  MeanForceStep(const Assembler& assembler, std::vector<double> u0, double h)
      : state(assembler, 0), rest(u0.size(), 0.0), mass(u0.size(), 1.0) {
    ends.ends.length = h, ends.end = h;
    ends.x_before = assembler.start();
    assembler.place(u0, ends.x_before);
    ends.u = std::move(u0);
  }
  StepProblem problem() {
    const double h = ends.end;
    return {h / 2, rest, rest, 2 / h, 4 / (h * h), mass, &state, 0, &ends};
  }
  MovingState state;
  std::vector<double> rest, mass;
  StepProblem::Ends ends;
};

// The mean forces of a step have no potential, so that the gradient of the energy is zero.
TEST(StaticProblem, EvaluatesMeanForcesAndTheirLackOfAGradientToTheBitOfTwoEvaluations) {
  Called c(hanging_chain().scene, {}, [](ScenePlan& plan) { use_mean_forces(plan, "test"); });
  for (std::size_t i = 0; i < c.p.unknowns; ++i) c.p.u[i] = 0.01 * static_cast<double>(i);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_FORCE), NETLOFT_OK);
  const auto at_rest = c.residual;
  MeanForceStep step(c.assembled.assembler, random_numbers(c.p.unknowns, 5), 0.1);
  c.problem.begin(step.problem());
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE), NETLOFT_OK);
  const auto mean = c.residual;
  EXPECT_GT(largest_difference(mean, at_rest), 1e-3 * largest(at_rest));
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_FORCE | NETLOFT_WANT_GRADIENT), NETLOFT_OK);
  const auto conservative = c.residual;
  double energy = 1;
  std::vector<double> residual(c.p.unknowns, 1.0), gradient(c.p.unknowns, 1.0);
  ASSERT_EQ(c.p.evaluate_both(c.p.host, c.p.u, &energy, residual.data(), gradient.data()), NETLOFT_OK);
  EXPECT_EQ(residual, mean);
  EXPECT_EQ(gradient, conservative);
  EXPECT_EQ(largest(gradient), 0);
  EXPECT_EQ(energy, 0);
}

void expect_solve_undoes_multiply(Called& c, int matrix, int flags, double shift) {
  const auto x = random_numbers(c.p.unknowns, 3);
  const auto y = c.multiply(matrix, shift, x);
  ASSERT_EQ(c.p.factorise(c.p.host, matrix | flags, shift), NETLOFT_FACTOR_OK);
  EXPECT_LT(largest_difference(c.solve(y), x), 1e-10);
}

TEST(StaticProblem, SolvesWithWhatItMultipliesBy) {
  Called c(hanging_chain().scene);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_CONVEX), NETLOFT_OK);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, 0, 0);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, 0, 0.3);
  expect_solve_undoes_multiply(c, NETLOFT_CONVEX, 0, 0.3);
  expect_solve_undoes_multiply(c, NETLOFT_NONE, 0, 1);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, NETLOFT_INDEFINITE, 0);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, NETLOFT_INDEFINITE, 0.3);
}

/// The product of x with (1 - share) exact + share convex + shift metric, from the last evaluations.
std::vector<double> between(Called& c, double share, double shift, const std::vector<double>& x) {
  const auto exact = c.multiply(NETLOFT_EXACT, shift, x), convex = c.multiply(NETLOFT_CONVEX, shift, x);
  std::vector<double> y(x.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = (1 - share) * exact[i] + share * convex[i];
  return y;
}

TEST(StaticProblem, SolvesWithAsMuchOfTheConvexPartAsIsWanted) {
  Called c(pressed_chain());
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  EXPECT_EQ(c.p.factorise_between(c.p.host, 0.5, 0.1), NETLOFT_FACTOR_FAILED);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_CONVEX), NETLOFT_OK);
  const auto x = random_numbers(c.p.unknowns, 3);
  ASSERT_GT(largest_difference(between(c, 0.2, 10, x), between(c, 0.7, 10, x)), 1);
  const int before = c.problem.statistics().factorisations;
  for (const double share : {0.2, 0.7, 1.0}) {
    ASSERT_EQ(c.p.factorise_between(c.p.host, share, 10), NETLOFT_FACTOR_OK);
    EXPECT_LT(largest_difference(c.solve(between(c, share, 10, x)), x), 1e-10);
  }
  EXPECT_EQ(c.p.factorise_between(c.p.host, 0, 0), NETLOFT_NOT_POSITIVE);
  EXPECT_EQ(c.problem.statistics().factorisations, before + 4);
}

TEST(StaticProblem, SolvesAnUnsymmetricProblem) {
  Sketch s = hanging_chain();
  s.part("push", "test/follower", {{"k", 300.0}}, {1, 2, 2, 3}).data["rest_length"] = {1, 1};
  Called c(s.scene);
  EXPECT_EQ(c.p.traits & (NETLOFT_SYMMETRIC | NETLOFT_CONSERVATIVE), 0u);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, 0, 0);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, 0, 0.5);
}

TEST(StaticProblem, RefusesAnIndefiniteTangentUnlessAskedForAny) {
  Called c(pressed_chain());
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  EXPECT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT, 0), NETLOFT_NOT_POSITIVE);
  EXPECT_EQ(c.problem.statistics().refused_factorisations, 1);
  expect_solve_undoes_multiply(c, NETLOFT_EXACT, NETLOFT_INDEFINITE, 0);
}

// The last bar is in compression and can turn in two directions about its upper end: two directions of
// negative stiffness.
TEST(StaticProblem, CountsNegativeEigenvaluesOfAnIndefiniteTangent) {
  if (!has_mumps()) GTEST_SKIP() << "built without MUMPS";
  Sketch s;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0, 0, -0.9);
  s.rope("strut", {top, end}, 1);
  s.scene.parts[0].parameters["rope.EA_compression"] = 1e4;
  Called c(s.scene);
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  ASSERT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT | NETLOFT_INDEFINITE, 0), NETLOFT_FACTOR_OK);
  EXPECT_EQ(c.p.negative_pivots(c.p.host), 2);
  ASSERT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT | NETLOFT_INDEFINITE, 10), NETLOFT_FACTOR_OK);
  EXPECT_EQ(c.p.negative_pivots(c.p.host), 0);
}

TEST(StaticProblem, HasNothingToFactoriseOrMultiplyBeforeAnEvaluation) {
  Called c(hanging_chain().scene);
  std::vector<double> x(c.p.unknowns, 1.0), y(c.p.unknowns);
  EXPECT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT, 0), NETLOFT_FACTOR_FAILED);
  EXPECT_EQ(c.p.multiply(c.p.host, NETLOFT_EXACT, 0, x.data(), y.data()), NETLOFT_ERROR);
  EXPECT_EQ(c.p.multiply(c.p.host, NETLOFT_CONVEX, 1, x.data(), y.data()), NETLOFT_ERROR);
  EXPECT_EQ(c.p.solve(c.p.host, x.data(), y.data()), NETLOFT_ERROR);
}

TEST(StaticProblem, DoesNotSolveWithAFactorThatWasRefused) {
  Called c(pressed_chain());
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_TANGENT), NETLOFT_OK);
  ASSERT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT, 0), NETLOFT_NOT_POSITIVE);
  std::vector<double> x(c.p.unknowns, 1.0);
  EXPECT_EQ(c.p.solve(c.p.host, x.data(), x.data()), NETLOFT_ERROR);
  ASSERT_EQ(c.p.factorise(c.p.host, NETLOFT_EXACT, 10), NETLOFT_FACTOR_OK);
  EXPECT_EQ(c.p.solve(c.p.host, x.data(), x.data()), NETLOFT_OK);
}

TEST(StaticProblem, CountsInItsBooksWhatIsAskedFor) {
  Called c(hanging_chain().scene);
  c.evaluate(NETLOFT_WANT_TANGENT);
  c.p.evaluate(c.p.host, NETLOFT_WANT_ENERGY, c.p.u, &c.energy, nullptr);
  c.p.factorise(c.p.host, NETLOFT_EXACT, 0);
  c.solve(c.residual);
  c.progress();
  const Statistics& b = c.problem.statistics();
  EXPECT_EQ(b.energies, 2);
  EXPECT_EQ(b.residuals, 1);
  EXPECT_EQ(b.matrices, 1);
  EXPECT_EQ(b.factorisations, 1);
  EXPECT_EQ(b.refused_factorisations, 0);
  EXPECT_EQ(b.solves, 1);
  EXPECT_EQ(b.iterations, 1);
  ASSERT_EQ(c.problem.history().size(), 1u);
  EXPECT_STREQ(c.problem.history()[0].note, "note");
}

TEST(StaticProblem, MeasuresStepsByTheLargestElement) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0, 0, -2), c = s.node(0, 0, -6);
  s.rope("rope", {a, b, c}, 1);
  Called called(s.scene);
  const std::vector<double> du{0, 0.5, 0, 0, 0, -1};
  EXPECT_DOUBLE_EQ(called.p.step_length(called.p.host, du.data()), 0.25);
}

TEST(StaticProblem, GoesOnUntilALimit) {
  Limits limits;
  limits.iterations = 2;
  Called c(hanging_chain().scene, limits);
  c.evaluate(0);
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  EXPECT_EQ(c.progress(), NETLOFT_GIVE_UP);
  EXPECT_EQ(c.problem.stop(), Stop::iterations);
  EXPECT_EQ(c.problem.statistics().iterations, 2);
}

// In this model, a residual costs 2 units and a matrix 3.
TEST(StaticProblem, StopsWhenItsBudgetOfWorkIsUsedUp) {
  const WorkModel model{.matrix = 30, .residual = 20, .unit = 10};
  Limits limits;
  limits.model = &model, limits.work = 7;
  Called c(hanging_chain().scene, limits);
  c.evaluate(NETLOFT_WANT_TANGENT);
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  c.evaluate(0);
  EXPECT_EQ(c.progress(), NETLOFT_GIVE_UP);
  EXPECT_EQ(c.problem.stop(), Stop::work);
}

TEST(StaticProblem, StopsWhenTimeIsUpOrSomeoneInterrupts) {
  Limits limits;
  limits.seconds = 0;
  Called late(hanging_chain().scene, limits);
  late.evaluate(0);
  EXPECT_EQ(late.progress(), NETLOFT_GIVE_UP);
  EXPECT_EQ(late.problem.stop(), Stop::time);

  std::atomic<bool> interrupt{false};
  limits = {};
  limits.interrupt = &interrupt;
  Called c(hanging_chain().scene, limits);
  c.evaluate(0);
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  interrupt = true;
  EXPECT_EQ(c.progress(), NETLOFT_GIVE_UP);
  EXPECT_EQ(c.problem.stop(), Stop::interrupted);
}

/// A bar of 1 m and EA = 100 N that hangs from a fixed node at height z. A load of 50 N at its lower end
/// stretches the bar to 1.5 m in equilibrium.
Sketch pulled_bar(double z) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, z, kAllAxes), end = s.node(0, 0, z - 1.5);
  s.rope("bar", {top, end}, 1, 100);
  s.part("load", "test/load", {{"z", -50.0}}, {end});
  return s;
}

TEST(StaticProblem, ArrivesWhenTheLargestNodalResidualIsSmall) {
  Limits limits;
  limits.tolerance = 1e-6;
  Called c(pulled_bar(0).scene, limits);
  c.p.u[2] = -2e-6;  // the imbalance is 2e-4 N of a load of 50 N
  c.evaluate(0);
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  c.p.u[2] = -4e-7;
  c.evaluate(0);
  EXPECT_EQ(c.progress(), NETLOFT_ARRIVED);
  EXPECT_EQ(c.problem.stop(), Stop::arrived);
  EXPECT_NEAR(c.problem.history().back().residual, 4e-5, 1e-10);
  EXPECT_NEAR(c.problem.history().back().scale, 50, 1e-3);
}

// The reaction is 50 N in equilibrium, and a hundred times as much if the bar is stretched to 51 m. Relative
// to the larger load, imbalances of 4e-5 N and of 4e-3 N would both be within 1e-6.
TEST(StaticProblem, JudgesAPointByItsOwnLoadsWhateverWasTriedInBetween) {
  Limits limits;
  limits.tolerance = 1e-6;
  Called c(pulled_bar(0).scene, limits);
  c.p.u[2] = -4e-5;
  c.evaluate(0);
  const auto there = c.residual;
  c.p.u[2] = -49.5;
  c.evaluate(0);
  c.p.u[2] = -4e-5, c.residual = there;
  const int evaluations = c.problem.statistics().residuals;
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  EXPECT_NEAR(c.problem.history().back().scale, 50, 1e-2);
  EXPECT_EQ(c.problem.statistics().residuals, evaluations + 1) << "which is counted";
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  EXPECT_EQ(c.problem.statistics().residuals, evaluations + 1) << "and done once";
}

// In the evaluation that fails, the bar bears 4950 N, and may be evaluated before the element `picky` fails.
TEST(StaticProblem, JudgesAPointByItsOwnLoadsAfterAnEvaluationThatFailed) {
  Sketch s = pulled_bar(0);
  s.part("picky", "test/picky", {{"limit", 10.0}}, {0, 1}).data["rest_length"] = {1};
  Called c(s.scene);
  ASSERT_EQ(c.evaluate(0), NETLOFT_OK);
  const auto there = c.residual;
  ASSERT_EQ(c.progress(), NETLOFT_GO_ON);
  const double own = c.problem.history().back().scale;
  c.p.u[2] = -49;
  ASSERT_EQ(c.evaluate(0), NETLOFT_OUTSIDE_DOMAIN);
  c.p.u[2] = 0, c.residual = there;
  EXPECT_EQ(c.progress(), NETLOFT_GO_ON);
  EXPECT_EQ(c.problem.history().back().scale, own);
}

// Positions of 1e6 m have a rounding error of 1e-10 m: with 100 N/m, residuals below about 1e-8 N are
// meaningless.
TEST(StaticProblem, TakesRoundOffOfThePositionsForBalance) {
  Limits limits;
  limits.tolerance = 1e-14;
  Called far(pulled_bar(1e6).scene, limits), near(pulled_bar(0).scene, limits);
  for (Called* c : {&far, &near}) {
    const auto x = c->assembled.assembler.start();
    std::vector<double> r(x.size(), 0.0);
    r[2] = 1e-8, r[5] = 50;
    const Balance b = c->problem.balance(x, r);
    EXPECT_EQ(b.balanced, c == &far);
    EXPECT_EQ(b.at_round_off, c == &far);
    EXPECT_EQ(b.worst, 1u);
    EXPECT_EQ(b.residual, 1e-8);
    EXPECT_EQ(b.scale, 50);
  }
}

// A displacement of 1e-12 m is below the resolution of coordinates near 1e6 m, and causes a force of 1e-10 N.
TEST(StaticProblem, KeepsTheDigitsThatPositionsHaveNoRoomFor) {
  Limits limits;
  limits.tolerance = 1e-14;
  Called c(pulled_bar(1e6).scene, limits);
  c.problem.count_from(c.assembled.assembler.start());
  c.p.u[2] = -1e-12;
  ASSERT_EQ(c.evaluate(NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT), NETLOFT_OK);
  EXPECT_NEAR(c.residual[2], -1e-10, 2e-14);
  EXPECT_EQ(c.problem.positions({c.p.u, c.p.unknowns})[2], 1e6 - 1.5);

  std::vector<double> x, residual;
  double energy = 0;
  ASSERT_TRUE(c.problem.recompute({c.p.u, c.p.unknowns}, x, residual, energy));
  EXPECT_EQ(residual[2], c.residual[2]);
  const Balance b = c.problem.balance(x, residual);
  EXPECT_FALSE(b.balanced);
  EXPECT_LT(b.floor, 2e-13);  // 4 ε x 100 N/m x 1.5 m
}

}  // namespace
}  // namespace netloft::test
