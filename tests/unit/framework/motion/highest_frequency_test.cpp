// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/highest_frequency.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

namespace netloft {
namespace {

/// Unequal masses between springs, both ends held.
struct Chain {
  std::vector<double> spring, mass;  // [N/m], one more than masses [kg]

  explicit Chain(std::size_t masses, double k = 1000, double m = 2)
      : spring(masses + 1, k), mass(masses, m) {}
  std::size_t size() const { return mass.size(); }
  Pencil pencil() const {
    using In = std::span<const double>;
    using Out = std::span<double>;
    return {size(), [this](In x, Out y) { pull(x, y); },
            [this](In x, Out y) {
              for (std::size_t i = 0; i < size(); ++i) y[i] = mass[i] * x[i];
            },
            [this](In x, Out y) {
              for (std::size_t i = 0; i < size(); ++i) y[i] = x[i] / mass[i];
            }};
  }
  void pull(std::span<const double> x, std::span<double> y) const {
    for (std::size_t i = 0; i < size(); ++i) {
      const double before = i > 0 ? x[i - 1] : 0, after = i + 1 < size() ? x[i + 1] : 0;
      y[i] = spring[i] * (x[i] - before) + spring[i + 1] * (x[i] - after);
    }
  }
  /// The highest frequency, from all eigenvalues of the full matrices.
  double omega() const {
    const auto n = static_cast<Eigen::Index>(size());
    Eigen::MatrixXd K(n, n), M = Eigen::MatrixXd::Zero(n, n);
    std::vector<double> unit(size()), column(size());
    for (Eigen::Index c = 0; c < n; ++c) {
      unit.assign(size(), 0.0), unit[static_cast<std::size_t>(c)] = 1;
      pull(unit, column);
      for (Eigen::Index r = 0; r < n; ++r) K(r, c) = column[static_cast<std::size_t>(r)];
      M(c, c) = mass[static_cast<std::size_t>(c)];
    }
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(K, M, Eigen::EigenvaluesOnly);
    return std::sqrt(all.eigenvalues()(n - 1));
  }
};

TEST(HighestFrequency, IsThatOfAChainFromAbove) {
  const Chain chain(300);
  const double exact = 2 * std::sqrt(1000.0 / 2) * std::sin(300 * M_PI / 2 / 301);
  const double found = find_highest_mode(chain.pencil()).omega;
  EXPECT_GE(found, exact);
  EXPECT_LE(found, 1.005 * exact);
}

/// A heavy ball on a rope whose bars are stiff only along their axes: four of twelve modes have a stiffness.
TEST(HighestFrequency, IsFoundWhereFewModesAreStiff) {
  Chain chain(12, 0, 0.011);
  for (const std::size_t k : {0u, 1u, 2u, 3u}) chain.spring[k] = 8e4;
  chain.mass[3] = 5;
  const HighestMode mode = find_highest_mode(chain.pencil());
  EXPECT_NEAR(mode.omega, chain.omega(), 1e-6 * chain.omega());
  EXPECT_NEAR(highest_frequency_near(chain.pencil(), mode.shape), chain.omega(), 1e-2 * chain.omega());
}

TEST(HighestFrequency, HasTheShapeOfItsMode) {
  Chain chain(40);
  chain.spring[7] = 5000, chain.mass[30] = 0.1;
  const HighestMode mode = find_highest_mode(chain.pencil());
  std::vector<double> pulled(40);
  chain.pull(mode.shape, pulled);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_NEAR(pulled[i], mode.omega * mode.omega * chain.mass[i] * mode.shape[i], 1e-5 * mode.omega) << i;
}

/// A stiff spring near one end has become soft, and one near the other end stiff. The known mode is that of
/// the former, which is almost orthogonal to that of the latter.
TEST(HighestFrequency, IsFoundWhereTheKnownModeHasNoPart) {
  Chain before(300), now(300);
  before.spring[20] = 4000;
  const std::vector<double> known = find_highest_mode(before.pencil()).shape;
  for (const double stiff : {1100.0, 1500.0, 4000.0, 4e5}) {
    now.spring[250] = stiff;
    const double found = highest_frequency_near(now.pencil(), known);
    EXPECT_GE(found, 0.995 * now.omega()) << stiff;
    EXPECT_LE(found, 1.03 * now.omega()) << stiff;
  }
}

TEST(HighestFrequency, TakesFewerStepsNearAKnownMode) {
  Chain chain(300);
  chain.spring[20] = 4000;
  const std::vector<double> known = find_highest_mode(chain.pencil()).shape;
  Pencil counted = chain.pencil();
  int steps = 0;
  counted.stiffness = [&](std::span<const double> x, std::span<double> y) { ++steps, chain.pull(x, y); };
  const double found = highest_frequency_near(counted, known);
  EXPECT_EQ(steps, 12);
  EXPECT_GE(found, 0.999 * chain.omega());
  EXPECT_LE(found, 1.03 * chain.omega());
}

}  // namespace
}  // namespace netloft
