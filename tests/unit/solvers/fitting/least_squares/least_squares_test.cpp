// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/least_squares/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

using Numbers = std::vector<double>;

/// A model given by a function, with central differences for slopes.
class FunctionModel : public Model {
 public:
  using Function = std::function<std::optional<Numbers>(const Numbers&)>;
  explicit FunctionModel(Function f) : f_(std::move(f)) {}
  std::optional<Numbers> predict(const Numbers& x) override { return ++calls, f_(x); }
  std::optional<std::vector<Numbers>> slopes(const Numbers& x) override {
    std::vector<Numbers> rows(f_(x)->size());
    for (std::size_t j = 0; j < x.size(); ++j) {
      Numbers a = x, b = x;
      a[j] -= 1e-5, b[j] += 1e-5;
      const Numbers fa = *f_(a), fb = *f_(b);
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back((fb[i] - fa[i]) / 2e-5);
    }
    return rows;
  }
  int calls = 0;

 private:
  Function f_;
};

// One parameter has the prior 1 ± 2 and is measured twice as 4 ± 1: the weights are 1/4, 1, 1.
TEST(LeastSquares, WeighsPriorAndMeasurements) {
  FunctionModel model([](const Numbers& x) { return Numbers{x[0], x[0]}; });
  const Fit f = fit(model, {{1, 2}}, {{4, 1}, {4, 1}}, {30, 1e-12});
  ASSERT_TRUE(f.converged) << f.reason;
  EXPECT_NEAR(f.parameters[0], (0.25 * 1 + 2 * 4) / 2.25, 1e-3);
  EXPECT_NEAR(f.deviations[0], 1 / std::sqrt(2.25), 1e-9);
  EXPECT_NEAR(f.model_deviations[1], 1 / std::sqrt(2.25), 1e-9);
}

// A measurement of f = a + b determines the sum, but not the difference. In units of the priors, N of (2) is
// I + w (1 1; 1 1).
TEST(LeastSquares, SaysWhatCannotBeToldApart) {
  FunctionModel model([](const Numbers& x) { return Numbers{x[0] + x[1]}; });
  const Fit f = fit(model, {{0, 1}, {0, 1}}, {{1, 0.1}});
  ASSERT_TRUE(f.converged);
  EXPECT_NEAR(f.parameters[0], f.parameters[1], 1e-9);
  EXPECT_NEAR(f.correlations[0][1], -100.0 / 101, 1e-9);
  EXPECT_EQ(f.correlations[0][0], 1);
}

TEST(LeastSquares, PredictsWhatIsHeldBack) {
  FunctionModel model([](const Numbers& x) { return Numbers{x[0], 3 * x[0]}; });
  const Fit f = fit(model, {{0, 100}}, {{2, 0.1}}, {30, 1e-12});
  EXPECT_NEAR(f.predictions[1], 6, 1e-3);
  EXPECT_NEAR(f.model_deviations[1], 0.3, 1e-3);
}

TEST(LeastSquares, FollowsACurvedValley) {
  FunctionModel model([](const Numbers& x) { return Numbers{10 * (x[1] - x[0] * x[0]), 1 - x[0]}; });
  const Fit f = fit(model, {{-1.2, 1e3}, {1, 1e3}}, {{0, 0.01}, {0, 0.01}}, {200, 1e-6});
  ASSERT_TRUE(f.converged) << f.reason;
  EXPECT_NEAR(f.parameters[0], 1, 1e-3);
  EXPECT_NEAR(f.parameters[1], 1, 1e-3);
}

TEST(LeastSquares, StopsAtTheEndOfARange) {
  FunctionModel model([](const Numbers& x) { return Numbers{x[0] + 0.5 * x[1], x[1]}; });
  const Fit f = fit(model, {{0, 10, -1, 1}, {0, 10, -5, 5}}, {{7, 0.1}, {2, 0.1}});
  ASSERT_TRUE(f.converged) << f.reason;
  EXPECT_EQ(f.parameters[0], 1);
  EXPECT_TRUE(f.at_end[0]);
  EXPECT_FALSE(f.at_end[1]);
  EXPECT_GT(f.parameters[1], 2) << "the other one makes up for it";
}

TEST(LeastSquares, ComesBackFromWhereThereIsNoAnswer) {
  FunctionModel model([](const Numbers& x) -> std::optional<Numbers> {
    if (x[0] > 2) return std::nullopt;
    return Numbers{std::exp(-x[0])};
  });
  const Fit f = fit(model, {{0, 10}}, {{0.2, 0.001}});
  ASSERT_TRUE(f.converged) << f.reason;
  EXPECT_NEAR(f.parameters[0], std::log(5), 0.01);
}

TEST(LeastSquares, SaysThatItCannotBegin) {
  FunctionModel model([](const Numbers&) { return std::nullopt; });
  const Fit f = fit(model, {{0, 1}}, {{0.2, 0.001}});
  EXPECT_FALSE(f.converged);
  EXPECT_TRUE(f.parameters.empty());
}

TEST(LeastSquares, SaysThatThereAreNoSlopes) {
  class OfOnePoint : public Model {
    std::optional<Numbers> predict(const Numbers&) override { return Numbers{0.1}; }
    std::optional<std::vector<Numbers>> slopes(const Numbers&) override { return std::nullopt; }
  } model;
  const Fit f = fit(model, {{0, 1}}, {{0.2, 0.001}});
  EXPECT_FALSE(f.converged);
  EXPECT_NE(f.reason.find("no slopes"), std::string::npos) << f.reason;
  EXPECT_TRUE(f.parameters.empty());
}

/// A model that is interrupted at a given call of `predict` or `slopes`.
class InterruptedModel : public FunctionModel {
 public:
  InterruptedModel(Function f, int calls) : FunctionModel(std::move(f)), left_(calls) {}
  std::optional<Numbers> predict(const Numbers& x) override {
    return left_-- > 0 ? FunctionModel::predict(x) : std::nullopt;
  }
  std::optional<std::vector<Numbers>> slopes(const Numbers& x) override {
    return left_-- > 0 ? FunctionModel::slopes(x) : std::nullopt;
  }
  bool is_interrupted() const override { return left_ < 0; }

 private:
  int left_;
};

// The fit is interrupted at each call in turn. A point with known slopes must remain complete.
TEST(LeastSquares, KeepsTheBestPointWhoseSlopesAreKnownWhenInterrupted) {
  for (int calls = 0; calls < 12; ++calls) {
    InterruptedModel model([](const Numbers& x) { return Numbers{x[0] * x[0], x[0] + x[1]}; }, calls);
    const Fit f = fit(model, {{1, 2}, {1, 2}}, {{9, 0.01}, {2, 0.01}}, {30, 1e-9});
    if (f.converged) break;
    EXPECT_EQ(f.reason, "interrupted");
    ASSERT_EQ(f.parameters.size(), calls < 2 ? 0u : 2u) << calls;
    if (f.parameters.empty()) continue;
    EXPECT_EQ(f.predictions[0], f.parameters[0] * f.parameters[0]) << "another point's predictions";
    // N = I + JᵀJ of (2) at this very point
    const double a = 2 * f.parameters[0] * 2 / 0.01, b = 2 / 0.01;
    const double n00 = 1 + a * a + b * b, n01 = b * b, n11 = 1 + b * b;
    EXPECT_NEAR(f.deviations[1], 2 * std::sqrt(n00 / (n00 * n11 - n01 * n01)), 1e-5);
  }
}

TEST(LeastSquares, EndsWhenItsStepsAreUsedUp) {
  FunctionModel model([](const Numbers& x) { return Numbers{10 * (x[1] - x[0] * x[0]), 1 - x[0]}; });
  const Fit f = fit(model, {{-1.2, 1e3}, {1, 1e3}}, {{0, 0.01}, {0, 0.01}}, {3, 1e-6});
  EXPECT_FALSE(f.converged);
  EXPECT_EQ(f.steps, 3);
  EXPECT_FALSE(f.parameters.empty());
}

}  // namespace
}  // namespace netloft
