// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/lbfgs/wolfe_search.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace netloft::lbfgs {
namespace {

using Function = std::function<Sample(double)>;

/// Searches from 0 and checks conditions (1), within the noise, and (2). `taken` becomes the number of
/// samples.
Sample run(const LineSearch& search, const Function& f, double first, int* taken = nullptr) {
  int count = 0;
  Sample last;
  const Sample start = f(0);
  const auto found = search.find(start, first, [&](double t) { return ++count, last = f(t); });
  EXPECT_TRUE(found.has_value());
  if (taken) *taken = count;
  if (!found) return {};
  EXPECT_EQ(found->t, last.t) << "the sample returned must be the last one taken";
  EXPECT_LE(std::abs(found->slope), search.curvature * std::abs(start.slope));
  EXPECT_LE(found->value, start.value + search.decrease * found->t * start.slope + search.noise);
  return *found;
}

Sample parabola(double t) { return {t, (t - 1) * (t - 1), 2 * (t - 1)}; }

TEST(LineSearch, TakesTheFirstLengthThatWillDo) {
  int taken = 0;
  EXPECT_EQ(run({}, parabola, 0.9, &taken).t, 0.9);
  EXPECT_EQ(taken, 1);
}

TEST(LineSearch, IsExactOnACubicAsFarAsItIsAsked) {
  LineSearch search;
  search.curvature = 1e-3;
  const Function cubic = [](double t) { return Sample{t, t * t * t / 3 - t, t * t - 1}; };
  EXPECT_NEAR(run(search, cubic, 3).t, 1, 1e-3);
}

TEST(LineSearch, GoesFarWhenTheFirstLengthIsShort) { EXPECT_GT(run({}, parabola, 1e-6).t, 0.05); }

TEST(LineSearch, ComesBackWhenTheFirstLengthIsLong) { EXPECT_LT(run({}, parabola, 1e6).t, 2); }

// The function is −t/(t² + 2), number 1 of J. J. Moré and D. J. Thuente, ACM Trans. Math. Softw. 20 (1994)
// 286-307; the first step lengths range from far too short to far too long. Beyond its minimum at √2 it is
// flat: t = 10 is acceptable, 1000 is too long for (1).
TEST(LineSearch, MeetsItsConditionsOnMoreAndThuentesFirstFunction) {
  LineSearch search;
  search.decrease = 1e-3, search.curvature = 0.1;
  const Function f = [](double t) {
    const double d = t * t + 2;
    return Sample{t, -t / d, (t * t - 2) / (d * d)};
  };
  for (const double first : {1e-3, 1e-1, 1e1, 1e3}) EXPECT_GT(run(search, f, first).t, 1);
}

// The function has no value beyond t = 0.5.
TEST(LineSearch, TurnsBackFromWhereThereIsNoValue) {
  const Function walled = [](double t) {
    return t > 0.5 ? Sample{t, std::numeric_limits<double>::infinity(), 0} : parabola(t);
  };
  const Sample s = run({}, walled, 1);
  EXPECT_GT(s.t, 0);
  EXPECT_LE(s.t, 0.5);
}

// A parabola of height 1e-12 is added to 1e6: rounding hides its values, but not its slopes.
TEST(LineSearch, GoesByTheSlopeWhereValuesAreNoise) {
  const Function noisy = [](double t) {
    const double rounding = static_cast<int>(t * 1e4) % 2 ? 1e-8 : -1e-8;
    return Sample{t, 1e6 + rounding + 1e-12 * (t - 1) * (t - 1), 2e-12 * (t - 1)};
  };
  LineSearch search;
  search.noise = 1e-7, search.curvature = 0.1;
  EXPECT_NEAR(run(search, noisy, 0.01).t, 1, 0.11);
  EXPECT_NEAR(run(search, noisy, 100).t, 1, 0.11);
}

TEST(LineSearch, FindsNothingWhereTheSlopeLies) {
  const auto found = LineSearch{}.find({0, 0, -1}, 1, [](double t) { return Sample{t, t, 1}; });
  EXPECT_FALSE(found.has_value());
}

TEST(LineSearch, EndsWhereTheFunctionFallsForEver) {
  int taken = 0;
  const auto found = LineSearch{}.find({0, 0, -1}, 1, [&](double t) { return ++taken, Sample{t, -t, -1}; });
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->value, -1e6);
  EXPECT_LE(taken, LineSearch{}.most_samples + 1);
}

}  // namespace
}  // namespace netloft::lbfgs
