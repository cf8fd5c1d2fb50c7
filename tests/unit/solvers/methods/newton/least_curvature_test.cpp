// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/least_curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::newton {
namespace {

constexpr double kShift = 1e-7;

/// A problem with diagonal K and M: its eigenvalues λ are the quotients K_ii/M_ii, and its eigenvectors v the
/// axes.
struct Diagonal {
  std::vector<double> stiffness, metric;
  netloft_problem interface {};

  explicit Diagonal(std::vector<double> lambda) {
    for (std::size_t i = 0; i < lambda.size(); ++i) {
      metric.push_back(1 + 0.1 * static_cast<double>(i % 7));
      stiffness.push_back(lambda[i] * metric[i]);
    }
    interface.size = sizeof interface, interface.host = this;
    interface.unknowns = static_cast<std::uint32_t>(lambda.size());
    interface.solve = [](void* host, const double* rhs, double* x) {
      const auto& d = *static_cast<Diagonal*>(host);
      for (std::size_t i = 0; i < d.metric.size(); ++i)
        x[i] = rhs[i] / (d.stiffness[i] + kShift * d.metric[i]);
      return int{NETLOFT_OK};
    };
    interface.multiply = [](void* host, int, double shift, const double* x, double* y) {
      const auto& d = *static_cast<Diagonal*>(host);
      for (std::size_t i = 0; i < d.metric.size(); ++i) y[i] = shift * d.metric[i] * x[i];
      return int{NETLOFT_OK};
    };
  }
};

/// The eigenvalues `first`, and larger ones that spread over decades as those of a net.
std::vector<double> spectrum(std::vector<double> first, std::size_t size) {
  for (std::size_t i = first.size(); i < size; ++i)
    first.push_back(std::pow(10.0, -7 + 7.0 * static_cast<double>(i) / static_cast<double>(size)));
  return first;
}

TEST(LeastCurvature, IsTheLeastEigenvalueAndItsVector) {
  Diagonal d(spectrum({-3e-8}, 500));
  Problem problem(d.interface);
  LeastCurvature curvature(problem.size());
  EXPECT_NEAR(curvature.find(problem, kShift), -3e-8, 3e-10);
  double rest = 0;
  for (std::size_t i = 1; i < 500; ++i) rest = std::max(rest, std::abs(curvature.direction()[i]));
  EXPECT_LT(rest, 1e-2 * std::abs(curvature.direction()[0]));
}

TEST(LeastCurvature, TakesNoMoreStepsThanItsDirectionNeeds) {
  Diagonal d(spectrum({-9e-8}, 500));
  static int solves = 0;
  static const auto solve = d.interface.solve;
  d.interface.solve = [](void* host, const double* rhs, double* x) { return ++solves, solve(host, rhs, x); };
  Problem problem(d.interface);
  EXPECT_NEAR(LeastCurvature(problem.size()).find(problem, kShift), -9e-8, 1e-9);
  EXPECT_LT(solves, 5);  // of 11
}

TEST(LeastCurvature, SeesOneAmongSeveralNegativeOnes) {
  Diagonal d(spectrum({-1e-9, -2.0e-8, -2.2e-8}, 300));
  Problem problem(d.interface);
  EXPECT_NEAR(LeastCurvature(problem.size()).find(problem, kShift), -2.2e-8, 1e-9);
}

TEST(LeastCurvature, IsPositiveWhereNothingCurvesDownwards) {
  Diagonal d(spectrum({}, 200));
  Problem problem(d.interface);
  EXPECT_GT(LeastCurvature(problem.size()).find(problem, kShift), 0);
}

TEST(LeastCurvature, IsExactInOneDimension) {
  Diagonal d({-5e-8});
  Problem problem(d.interface);
  LeastCurvature curvature(problem.size());
  EXPECT_NEAR(curvature.find(problem, kShift), -5e-8, 1e-15);
  EXPECT_NE(curvature.direction()[0], 0);
}

TEST(LeastCurvature, IsNoNumberWithoutAMetric) {
  Diagonal d({-5e-8, 1});
  d.metric = {0, 0}, d.stiffness = {1, 1};
  Problem problem(d.interface);
  EXPECT_TRUE(std::isnan(LeastCurvature(problem.size()).find(problem, kShift)));
}

}  // namespace
}  // namespace netloft::newton
