// SPDX-License-Identifier: BSD-3-Clause
//
// Logarithms, exponentials and powers of lane_number.hpp compared with those of the C library in long double,
// over their whole range.
#include "plugins/common/lane_number.hpp"

#include "plugins/common/sphere.hpp"

#include <gtest/gtest.h>
#include <netloft/dual.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace netloft;

constexpr int kSamples = 200000;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double uniform(std::mt19937_64& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

/// |found − exact| in units of the last place of `exact`.
double units(double found, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  return std::abs(static_cast<double>(std::ldexp(found - exact, 53 - exponent)));
}

TEST(LaneLogarithm, IsWithinOneUnitInTheLastPlaceForAllNormalNumbers) {
  std::mt19937_64 random(1);
  for (int i = 0; i < kSamples; ++i) {
    const double any = std::exp2(uniform(random, -1022, 1023.9)), near_one = uniform(random, 0.6, 1.6);
    for (const double x : {any, near_one})
      ASSERT_LT(units(lane::log(x), std::log(static_cast<long double>(x))), 1) << x;
  }
  EXPECT_EQ(lane::log(1), 0);
}

TEST(LaneLogarithm, IsFiniteForEveryArgument) {
  using Limits = std::numeric_limits<double>;
  for (const double x : {0.0, -1.0, Limits::denorm_min(), Limits::max(), Limits::infinity(),
                         -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_TRUE(std::isfinite(lane::log(x))) << x;
}

TEST(LaneExponential, IsWithinOneUnitInTheLastPlace) {
  std::mt19937_64 random(2);
  for (int i = 0; i < kSamples; ++i)
    for (const double x : {uniform(random, -708, 708), uniform(random, -1, 1)})
      ASSERT_LT(units(lane::exp(x), std::exp(static_cast<long double>(x))), 1) << x;
  EXPECT_EQ(lane::exp(0), 1);
}

// The error of a power is half a unit of ln x times p ln x, plus the error of the exponential.
TEST(LaneNumber, PowersDeviateByTheRoundingOfTheirLogarithm) {
  std::mt19937_64 random(3);
  for (int i = 0; i < kSamples; ++i) {
    const double x = std::exp(uniform(random, std::log(1e-9), std::log(1e9))), p = uniform(random, -2, 2);
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(p));
    const LaneNumber power = pow(LaneNumber::variable(x), p);
    ASSERT_LT(std::abs(static_cast<double>(power.value / exact - 1)),
              kEpsilon * (1 + std::abs(p * std::log(x))))
        << x << " to the " << p;
    ASSERT_NEAR(power.slope, p * power.value, 4 * kEpsilon * std::abs(p * power.value));
  }
}

TEST(LaneNumber, HasTheDerivativesOfDualNumbers) {
  const auto formula = [](const auto& x) {
    using std::log, std::pow, std::sqrt;
    return at_most(at_least(-sqrt(x) / (2.0 + log(x)) + 3.0 * pow(x, 0.7) * x - 1.0, -0.9), 40);
  };
  for (const double x : {0.3, 1.0, 2.0, 3.0, 50.0}) {
    const LaneNumber found = formula(LaneNumber::variable(x));
    const auto exact = formula(Dual<1, 1>::variable(x, 0));
    EXPECT_NEAR(found.value, exact.value, 1e-14 * std::abs(exact.value)) << x;
    EXPECT_NEAR(found.slope, x * exact.gradient[0], 1e-13 * std::abs(exact.value)) << x;
  }
}

/// The drag of spheres in a loop over `count` lanes. Compilers vectorise the loop only if all calls in it are
/// inlined.
[[gnu::flatten]] std::vector<double> sphere_drags(const double* Re, std::size_t count) {
  std::vector<double> drag(count);
  for (std::size_t i = 0; i < count; ++i) drag[i] = sphere_phi(LaneNumber::variable(Re[i])).value;
  return drag;
}

TEST(LaneNumber, HasTheSameBitsInEveryLane) {
  std::vector<double> Re(64);
  for (std::size_t i = 0; i < Re.size(); ++i) Re[i] = std::exp(0.3 * static_cast<double>(i) - 4);
  const std::vector<double> all = sphere_drags(Re.data(), Re.size());
  for (std::size_t first = 0; first < Re.size(); ++first)
    for (const std::size_t count : {1, 2, 3, 5}) {
      if (first + count > Re.size()) continue;
      const std::vector<double> some = sphere_drags(Re.data() + first, count);
      EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin() + static_cast<std::ptrdiff_t>(first)));
    }
}

}  // namespace
