// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/optimum/optimum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

using Numbers = std::vector<double>;

constexpr double kInf = std::numeric_limits<double>::infinity();

double squared(double x) { return x * x; }

/// A model given by a function, with central differences for slopes.
class ModelOfFunction : public Model {
 public:
  using Function = std::function<Numbers(const Numbers&)>;
  explicit ModelOfFunction(Function f) : f_(std::move(f)) {}
  std::optional<Numbers> predict(const Numbers& x) override {
    if (x[0] < least || ++calls == interrupted_at) return std::nullopt;
    return f_(x);
  }
  std::optional<std::vector<Numbers>> slopes(const Numbers& x) override {
    std::vector<Numbers> rows(f_(x).size());
    for (std::size_t j = 0; j < x.size(); ++j) {
      Numbers a = x, b = x;
      a[j] -= 1e-6, b[j] += 1e-6;
      const Numbers fa = f_(a), fb = f_(b);
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back((fb[i] - fa[i]) / 2e-6);
    }
    return rows;
  }
  bool is_interrupted() const override { return interrupted_at > 0 && calls >= interrupted_at; }

  double least = -kInf;  // there is no solution below this x[0]
  int calls = 0, interrupted_at = 0;

 private:
  Function f_;
};

Numbers rosen_suzuki(const Numbers& x) {
  const double a = x[0], b = x[1], c = x[2], d = x[3];
  return {a * a + b * b + 2 * c * c + d * d - 5 * a - 5 * b - 21 * c + 7 * d,
          a * a + b * b + c * c + d * d + a - b + c - d, a * a + 2 * b * b + c * c + 2 * d * d - a - d,
          2 * a * a + b * b + c * c + 2 * a - b - d};
}

// J. B. Rosen, S. Suzuki, Commun. ACM 8, 1965: the least value is −44 at (0, 1, 2, −1), with multipliers 1, 0
// and 2.
TEST(Optimum, SolvesTheProblemOfRosenAndSuzuki) {
  const std::vector<Bounds> box(4, {-5, 5}), limits{{-kInf, 8}, {-kInf, 10}, {-kInf, 5}};
  for (const Numbers& start : {Numbers{0, 0, 0, 0}, Numbers{5, -5, 5, 5}, Numbers{-3, 3, -3, 3}}) {
    ModelOfFunction model(rosen_suzuki);
    const Optimum found = optimise(model, {start, box, limits});
    ASSERT_TRUE(found.converged) << found.reason;
    EXPECT_LE(found.history.size(), 20u);
    EXPECT_TRUE(found.is_feasible);
    EXPECT_NEAR(found.best.predictions[0], -44, 1e-4);
    const Numbers known{0, 1, 2, -1}, prices{-1, 0, -2};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.best.parameters[i], known[i], 1e-3);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found.constraint_prices[j], prices[j], 1e-3);
    EXPECT_EQ(found.parameter_prices, Numbers(4, 0.0));
  }
}

// W. Hock, K. Schittkowski, Test examples for nonlinear programming codes, 1981, no. 71, has an equation and
// a parameter at its limit; the least value is 17.0140173, the multipliers are 0.5522937, 0.1614686 and
// 1.0878712.
TEST(Optimum, SolvesAProblemWithAnEquation) {
  ModelOfFunction model([](const Numbers& x) {
    return Numbers{x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], x[0] * x[1] * x[2] * x[3],
                   squared(x[0]) + squared(x[1]) + squared(x[2]) + squared(x[3])};
  });
  const Optimum found =
      optimise(model, {{1, 5, 5, 1}, std::vector<Bounds>(4, {1, 5}), {{25, kInf}, {40, 40}}});
  ASSERT_TRUE(found.converged) << found.reason;
  EXPECT_NEAR(found.best.predictions[0], 17.0140173, 1e-4);
  EXPECT_NEAR(found.constraint_prices[0], 0.5522937, 1e-4);
  EXPECT_NEAR(std::abs(found.constraint_prices[1]), 0.1614686, 1e-4);
  EXPECT_EQ(found.best.parameters[0], 1);
  EXPECT_NEAR(found.parameter_prices[0], 1.0878712, 1e-4);
}

// Full steps along this curved constraint increase both the objective and the violation, although they lead
// to the optimum (N. Maratos, thesis, London 1978). The search leads from (0.6, 0.8) to (1, 0), with the
// multiplier 3/2.
TEST(Optimum, FollowsACurvedConstraint) {
  ModelOfFunction model([](const Numbers& x) {
    const double square = squared(x[0]) + squared(x[1]);
    return Numbers{x[0] - 2 * (square - 1), square};
  });
  const Optimum found = optimise(
      model,
      {.start = {0.6, 0.8}, .parameters = {{-2, 2}, {-2, 2}}, .constraints = {{1, 1}}, .maximise = true});
  ASSERT_TRUE(found.converged) << found.reason;
  EXPECT_LE(found.history.size(), 10u);
  EXPECT_NEAR(found.best.parameters[0], 1, 1e-6);
  EXPECT_NEAR(found.constraint_prices[0], -1.5, 1e-4);
}

// Beyond x = −0.3 there is no solution. The search keeps the best point and says why it ends.
TEST(Optimum, ShortensStepsThatHaveNoSolution) {
  ModelOfFunction model([](const Numbers& x) { return Numbers{squared(x[0] + 1)}; });
  model.least = -0.3;
  const Optimum found = optimise(model, {{1}, {{-2, 2}}, {}});
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.reason, "the model has no solution in the direction in which the slopes point");
  EXPECT_NEAR(found.best.parameters[0], -0.3, 1e-4);
  EXPECT_GE(found.best.parameters[0], -0.3);
}

TEST(Optimum, SaysThatConstraintsContradictEachOther) {
  ModelOfFunction model([](const Numbers& x) { return Numbers{x[0], squared(x[0]) + squared(x[1])}; });
  const Optimum found = optimise(model, {{0.6, 0.8}, {{-2, 2}, {-2, 2}}, {{20, kInf}}});
  EXPECT_FALSE(found.converged);
  EXPECT_FALSE(found.is_feasible);
  EXPECT_LT(found.history.size(), 10u);
  EXPECT_EQ(
      found.reason,
      "near the last point, none violates the constraints less: the constraints contradict each other there");
  EXPECT_NEAR(found.best.violation, (20 - 8) / 20.0, 1e-9);
}

TEST(Optimum, EndsWithTheBestPointAtTheLimitAndIfInterrupted) {
  const OptimumProblem problem{
      {5, -5, 5, 5}, std::vector<Bounds>(4, {-5, 5}), {{-kInf, 8}, {-kInf, 10}, {-kInf, 5}}};
  ModelOfFunction model(rosen_suzuki);
  const Optimum limited = optimise(model, problem, {.evaluations = 4});
  EXPECT_EQ(limited.reason, "the limit of solves was reached");
  EXPECT_EQ(limited.history.size(), 4u);
  ModelOfFunction other(rosen_suzuki);
  other.interrupted_at = 5;
  const Optimum interrupted = optimise(other, problem);
  EXPECT_EQ(interrupted.reason, "interrupted");
  EXPECT_EQ(interrupted.best.parameters, limited.best.parameters);
  ModelOfFunction none(rosen_suzuki);
  none.least = 6;
  EXPECT_EQ(optimise(none, problem).reason, "the model has no solution at the start");
}

}  // namespace
}  // namespace netloft
