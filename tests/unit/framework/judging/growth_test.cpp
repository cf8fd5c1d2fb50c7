// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/growth.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <numbers>

#include "framework/assembler/pattern.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/unit/framework/balance/oscillator.hpp"
#include "tests/unit/solvers/known_answers.hpp"

namespace netloft::test {
namespace {

/// A tridiagonal matrix with constant entries below, on and above its diagonal.
struct ThreeDiagonals {
  ThreeDiagonals(std::int32_t size, double below, double on, double above) {
    pattern.size = size, pattern.symmetric = false, pattern.column_start = {0};
    for (std::int32_t c = 0; c < size; ++c) {
      for (std::int32_t r = std::max(0, c - 1); r < std::min(size, c + 2); ++r) {
        pattern.row.push_back(r);
        values.push_back(r > c ? below : r == c ? on : above);
      }
      pattern.node.push_back(static_cast<std::uint32_t>(c));
      pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
    }
  }
  SparsePattern pattern;
  std::vector<double> values;
};

struct CountedGrowth : Growth {
  Statistics cost;
};

/// M ÿ + C ẏ + K y = 0, where K has the error `error` on its diagonal.
CountedGrowth growth_with(const ThreeDiagonals& K, const std::vector<double>& C, const std::vector<double>& M,
                          double error = 0) {
  const std::vector<double> zeros(K.values.size());
  LinearMotion m{.K = K.values, .C = C, .M = M, .convex = zeros};
  std::vector<double> errors = zeros;
  for (std::int32_t i = 0; i < K.pattern.size; ++i)
    m.convex[find_slot(K.pattern, i, i)] = 1, errors[find_slot(K.pattern, i, i)] = error;
  m.K_error = [&] { return errors; };
  Statistics cost;
  Factors factors(make_factorisation, cost);
  Growth growth = find_growth(K.pattern, m, factors);
  return {std::move(growth), cost};
}

/// The motion C ẏ + K y = 0, which contains e^(−λt) for the eigenvalues λ of K v = λ C v.
CountedGrowth growth_without_mass(const ThreeDiagonals& K, const ThreeDiagonals& C, double error = 0) {
  return growth_with(K, C.values, std::vector<double>(C.values.size()), error);
}

double growth_of(const ThreeDiagonals& K, const ThreeDiagonals& C) {
  return growth_without_mass(K, C).per_power;
}

double growth_of(const ThreeDiagonals& K) { return growth_of(K, {K.pattern.size, 0, 1, 0}); }

// [a b; −b a] has the eigenvalues a ± ib. With |λ| = σ and a = −σ cos θ, |(σ − λ)/(σ + λ)|² is (1 + cos θ)/(1
// − cos θ).
TEST(GrowthOfMatrices, IsThatOfACirculatoryPair) {
  const double cosine = 0.1, sine = std::sqrt(1 - cosine * cosine);
  EXPECT_NEAR(growth_of({2, -sine, -cosine, sine}), std::sqrt(1.1 / 0.9), 1e-2);
  EXPECT_EQ(growth_of({2, -sine, cosine, sine}), 0) << "its symmetric part is positive";
}

// All eigenvalues are 1, but a disturbance grows by 3^19 as it moves down the chain, until it leaves the
// chain. (For a chain of 60, double precision cannot distinguish the growth of 3^59 from an instability.)
TEST(GrowthOfMatrices, PassesWhereEachFeedsTheNextOne) {
  EXPECT_LE(growth_of({20, -3, 1, 0}), kMarginalGrowth);
  EXPECT_GT(growth_of({20, -3, -0.1, 0}), kMarginalGrowth);
}

/// A full matrix of numbers in [-1, 1] with `shift` on its diagonal.
ThreeDiagonals random_matrix(int size, double shift, unsigned seed) {
  ThreeDiagonals K(size, 0, 0, 0);
  K.pattern.row.clear(), K.pattern.column_start = {0},
                         K.values = random_numbers(static_cast<std::size_t>(size * size), seed);
  for (int c = 0; c < size; ++c) {
    for (int r = 0; r < size; ++r) K.pattern.row.push_back(r);
    K.pattern.column_start.push_back(static_cast<std::int32_t>(K.pattern.row.size()));
    K.values[static_cast<std::size_t>(c * size + c)] += shift;
  }
  return K;
}

// The verdict is compared with all eigenvalues of the full matrix, whose time scales range over six decades.
TEST(GrowthOfMatrices, IsFoundWhereverSomeEigenvalueGrows) {
  constexpr int kSize = 60;
  int grow = 0, decay = 0, marginal = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    ThreeDiagonals K = random_matrix(kSize, 2 + 0.1 * seed, seed), C = K;
    std::fill(C.values.begin(), C.values.end(), 0.0);
    for (int i = 0; i < kSize; ++i) {
      const double scale = std::pow(10, 3 - 6.0 * i / kSize);
      C.values[static_cast<std::size_t>(i * kSize + i)] = 1;
      for (int c = 0; c < kSize; ++c) K.values[static_cast<std::size_t>(c * kSize + i)] *= scale;
    }
    const Eigen::MatrixXd full = Eigen::Map<const Eigen::MatrixXd>(K.values.data(), kSize, kSize);
    double c = -1;  // c of (6) in growth.hpp of the eigenvalue that grows most
    for (const auto& lambda : full.eigenvalues()) c = std::max(c, -lambda.real() / std::abs(lambda));
    const Growth growth = growth_without_mass(K, C);
    if (c > 0.011) {
      EXPECT_TRUE(growth.grows()) << seed << ": " << c;
    } else if (c <= 0) {
      EXPECT_EQ(growth.verdict, GrowthVerdict::none) << seed << ": " << c;
    }
    ++(c > 0.011 ? grow : c <= 0 ? decay : marginal);
  }
  EXPECT_GT(grow, 10);
  EXPECT_GT(decay, 10);
}

using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Vector<double, 6>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The plate of framework/guides/body.md without mass, in equilibrium on its warp at 30 degrees to the flow.
/// Its matrices are differences of forces that are implemented here again, independently.
struct PlateOnWarp {
  double damping, bracket;
  Eigen::Matrix3d axes = Eigen::AngleAxisd(-std::numbers::pi / 6, Vec3::UnitZ()).toRotationMatrix();
  Vec3 lever = bracket * Vec3(-0.17320508075688773, -1, 0.5),
       pull = force_of_water(axes, Vec3::Zero()) + kWeight;

  static constexpr double kStiffness = 1e8, kLength = 50;
  inline static const Vec3 kWeight{0, 0, -1640}, kHangs{0, 0, -0.3};

  static double pressure(const Vec3& W) { return 0.5 * 1025 * 2 * W.norm(); }
  static Vec3 force_of_water(const Eigen::Matrix3d& R, const Vec3& v) {
    const Vec3 W = Vec3(2, 0, 0) - v, n = R.col(1);
    return pressure(W) * (1.6 * W.dot(n) * n + 0.16 * (W - W.dot(n) * n));
  }
  Vec3 start_of_warp() const { return pull.normalized() * kLength * (1 + pull.norm() / kStiffness); }
  Vec6 force(const Vec6& q, const Vec6& v) const {
    const double angle = q.tail<3>().norm();
    const Vec3 axis = angle > 0 ? Vec3(q.tail<3>() / angle) : Vec3::UnitX();
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis) * axes;
    const Vec3 arm = R * lever, at = start_of_warp() - axes * lever + q.head<3>() + arm;
    const Vec3 warp = -kStiffness * (at.norm() / kLength - 1) * at.normalized();
    Vec6 f;
    f << force_of_water(R, v.head<3>()) + kWeight + warp,
        -damping * pressure(Vec3(2, 0, 0) - v.head<3>()) * v.tail<3>() + (R * kHangs).cross(kWeight) +
            arm.cross(warp);
    return f;
  }
  Mat6 tangent(bool of_places) const {
    Mat6 A;
    for (int i = 0; i < 6; ++i) {
      const Vec6 d = 1e-6 * Vec6::Unit(i), none = Vec6::Zero();
      A.col(i) = of_places ? force(-d, none) - force(d, none) : force(none, -d) - force(none, d);
    }
    return A / 2e-6;
  }
  /// Stiffness from the stretch of the warp and from its tension.
  Mat6 convex() const {
    const Vec3 arm = axes * lever, along = pull.normalized();
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(),
        Eigen::Matrix3d{{0, arm.z(), -arm.y()}, {-arm.z(), 0, arm.x()}, {arm.y(), -arm.x(), 0}};
    const double k = kStiffness / kLength;
    return J.transpose() * (k * along * along.transpose()) * J +
           1e-6 * k * (J.transpose() * J + Mat6::Identity());
  }
  LinearMotion motion() const {
    const auto values = [](const Mat6& A) { return std::vector<double>(A.data(), A.data() + 36); };
    return {values(tangent(true)), values(tangent(false)), std::vector<double>(36), values(convex())};
  }
};

TEST(GrowthOfMatrices, IsNoneOfAPlateWithoutMassOnItsWarp) {
  for (const double damping : {0.1, 0.3, 1.0, 3.0, 10.0})
    for (const double bracket : {0.25, 0.5, 1.0, 2.0}) {
      const PlateOnWarp plate{damping, bracket};
      EXPECT_LE(plate.force(Vec6::Zero(), Vec6::Zero()).norm(), 1e-6 * plate.pull.norm());
      const Eigen::MatrixXd damps = plate.tangent(false), holds = plate.tangent(true);
      const Eigen::MatrixXd rates = -damps.lu().solve(holds);
      ASSERT_LT(rates.eigenvalues().real().maxCoeff(), -0.01) << "by all eigenvalues";
      Statistics cost;
      Factors factors(make_factorisation, cost);
      const Growth growth = find_growth(random_matrix(6, 0, 1).pattern, plate.motion(), factors);
      EXPECT_EQ(growth.verdict, GrowthVerdict::none) << damping << ", " << bracket << ": " << growth.rate;
    }
}

// The eigenvalues are s = 1 ± 10i, and s = 0.01, which is mapped almost onto the unit circle by the σ that is
// best for the pair.
TEST(GrowthOfMatrices, TellsOfWhatDivergesBehindWhatSwingsFaster) {
  ThreeDiagonals K(3, 0, 0, 0);
  const ThreeDiagonals C(3, 0, 1, 0);
  const auto at = [&](int r, int c) -> double& { return K.values[find_slot(K.pattern, r, c)]; };
  at(0, 0) = at(1, 1) = -1, at(0, 1) = 10, at(1, 0) = -10, at(2, 2) = 1;
  const Growth swings = growth_without_mass(K, C);
  ASSERT_TRUE(swings.grows() && swings.swings());
  EXPECT_NEAR(std::hypot(swings.mode[1], swings.mode_later[1]),
              std::hypot(swings.mode[0], swings.mode_later[0]), 1e-6)
      << "both unknowns go as far, in turn";
  at(2, 2) = -0.01;
  const Growth diverges = growth_without_mass(K, C);
  ASSERT_TRUE(diverges.grows());
  EXPECT_FALSE(diverges.swings()) << diverges.rate << ", " << diverges.frequency;
  EXPECT_NEAR(diverges.rate, 0.01, 1e-6);
}

// The pair s = 1 ± 0.5i, which grows five hundredfold in one period, counts as flutter; 1 ± 0.05i does not.
TEST(GrowthOfMatrices, CallsAPairFlutterUnlessItOutgrowsAllDigitsInHalfATurn) {
  for (const double frequency : {0.5, 0.05}) {
    ThreeDiagonals K(2, 0, 0, 0);
    const ThreeDiagonals C(2, 0, 1, 0);
    const auto at = [&](int r, int c) -> double& { return K.values[find_slot(K.pattern, r, c)]; };
    at(0, 0) = at(1, 1) = -1, at(0, 1) = frequency, at(1, 0) = -frequency;
    const Growth growth = growth_without_mass(K, C);
    ASSERT_TRUE(growth.grows());
    EXPECT_NEAR(growth.frequency, frequency, 1e-6);
    EXPECT_EQ(growth.swings(), frequency > 0.1);
  }
}

// The pair s = 0.09 ± 10i is within the marginal band (6) of growth.hpp; -0.09 ± 10i decays.
TEST(GrowthOfMatrices, IsMarginalWhereAPairHardlyGrows) {
  const ThreeDiagonals C(2, 0, 1, 0), grows(2, -10, -0.09, 10), decays(2, -10, 0.09, 10);
  EXPECT_EQ(growth_without_mass(grows, C).verdict, GrowthVerdict::marginal);
  EXPECT_EQ(growth_without_mass(decays, C).verdict, GrowthVerdict::none);
}

// The stiffness has the eigenvalue λ = -1e-3 or zero, and an error of 1e-2.
TEST(GrowthOfMatrices, IsMarginalWhereTheStiffnessIsNotKnownThatWell) {
  ThreeDiagonals K(2, 0, 1, 0);
  K.values.front() = -1e-3;
  const ThreeDiagonals C(2, 0, 1, 0);
  const auto verdict = [&](double error) { return growth_without_mass(K, C, error).verdict; };
  EXPECT_EQ(verdict(0), GrowthVerdict::grows);
  EXPECT_EQ(verdict(1e-4), GrowthVerdict::grows);
  EXPECT_EQ(verdict(-1e-2), GrowthVerdict::grows) << "it would grow all the more";
  EXPECT_EQ(verdict(1e-2), GrowthVerdict::marginal);
}

// Each σ takes one factorisation and 24 solutions. All rates are between 2 and 7, so that one σ is enough. If
// one unknown decays at the rate 1e-5, smaller ones are needed, down to kLeastSigma.
TEST(GrowthOfMatrices, CountsWhatItTakes) {
  ThreeDiagonals K(200, -3, 2, 3.5), C(200, 0, 1, 0);
  const auto expect_shifts = [&](int shifts) {
    const CountedGrowth growth = growth_without_mass(K, C);
    ASSERT_EQ(growth.verdict, GrowthVerdict::none);
    EXPECT_EQ(growth.cost.factorisations, shifts);
    EXPECT_EQ(growth.cost.solves, shifts * 24);
  };
  expect_shifts(1);
  C.values.back() = 2e5;
  expect_shifts(3);
}

TEST(GrowthOfMatrices, HasTheSameBitsEachTime) {
  const ThreeDiagonals K = random_matrix(50, 3, 7);
  ThreeDiagonals unit = random_matrix(50, 3, 7);
  std::fill(unit.values.begin(), unit.values.end(), 0.0);
  for (std::size_t i = 0; i < 50; ++i) unit.values[51 * i] = 1;
  const Growth a = growth_without_mass(K, unit), b = growth_without_mass(K, unit);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.mode, b.mode);
}

// The growing eigenvalue is λ = 2 − √(3 × 3.1), with the eigenvector (√3.1, −√3).
TEST(GrowthOfMatrices, TellsWhatGrows) {
  const ThreeDiagonals K(2, 3, 2, 3.1), C(2, 0, 1, 0);
  const Growth growth = growth_without_mass(K, C);
  ASSERT_TRUE(growth.grows());
  EXPECT_NEAR(growth.mode[0] / growth.mode[1], -std::sqrt(3.1 / 3), 1e-6);
}

// The eigenvalues are λ = ∓1e9, 1 and 1, as in a gear with a strongly compressed (or taut) member. The
// symmetric part is indefinite in both cases.
TEST(GrowthOfMatrices, SeesWhatGrowsMuchFasterThanTheRest) {
  ThreeDiagonals K(3, 2.5, 1, 0);
  K.values.front() = -1e9;
  EXPECT_GT(growth_of(K), kMarginalGrowth);
  K.values.front() = 1e9;
  EXPECT_LE(growth_of(K), kMarginalGrowth);
}

// The eigenvalues satisfy λ² − (K₁₁/C₁₁ + K₂₂/C₂₂) λ + det K/det C = 0. The sum of the roots can change its
// sign with C, their product cannot.
TEST(GrowthOfMatrices, DependsOnTheDampingWhereItIsFlutterAlone) {
  ThreeDiagonals flutter(2, -3, 2, 3), divergence(2, -1, 2, 1), C(2, 0, 1, 0);
  flutter.values.back() = divergence.values.back() = -1;
  for (const double first : {1.0, 4.0}) {
    C.values.front() = first;
    EXPECT_EQ(growth_of(flutter, C) > kMarginalGrowth, 2 / first - 1 < 0) << first;
    EXPECT_GT(growth_of(divergence, C), kMarginalGrowth) << first;
  }
}

// The eigenvalues satisfy λ² − (K₁₁ + K₂₂) λ + det K = 0.
TEST(GrowthOfMatrices, TellsHowFastItGrowsAndSwings) {
  const ThreeDiagonals C(2, 0, 1, 0), flutter(2, -3, -0.5, 3), divergence(2, 3, 2, 3.1);
  const Growth swings = growth_without_mass(flutter, C);
  EXPECT_NEAR(swings.rate, 0.5, 1e-6);
  EXPECT_NEAR(swings.frequency, 3, 1e-6);
  const Growth topples = growth_without_mass(divergence, C);
  EXPECT_NEAR(topples.rate, std::sqrt(9.3) - 2, 1e-6);
  EXPECT_EQ(topples.frequency, 0);
}

/// The growth of a single body with mass m, damping c and stiffness k.
Growth growth_of_one(double m, double c, double k) { return growth_with({1, 0, k, 0}, {c}, {m}); }

// The eigenvalues are s = −c/2m ± (c²/4m² − k/m)^½.
TEST(GrowthWithMass, IsThatOfAPendulum) {
  EXPECT_EQ(growth_of_one(2, 0.3, 50).verdict, GrowthVerdict::none) << "hangs";
  const Growth topples = growth_of_one(2, 0.3, -50);
  ASSERT_TRUE(topples.grows());
  EXPECT_NEAR(topples.rate, -0.075 + std::sqrt(25 + 0.075 * 0.075), 1e-8);
  EXPECT_EQ(topples.frequency, 0);
  const Growth swings = growth_of_one(2, -0.3, 50);
  ASSERT_TRUE(swings.grows());
  EXPECT_NEAR(swings.rate, 0.075, 1e-8);
  EXPECT_NEAR(swings.frequency, std::sqrt(25 - 0.075 * 0.075), 1e-8);
}

// One body is driven (negative damping), but more weakly than its neighbour is damped. Without masses, 0.1 s²
// − 1.8 s − 3 = 0, so that a motion grows at the rate s = 19.5.
TEST(GrowthWithMass, SwingsNotWhereANeighbourDampsWhatDrivesIt) {
  const ThreeDiagonals K(2, -1, 2, -1);
  const std::vector<double> C{-0.1, 0, 0, 1}, unit{1, 0, 0, 1};
  EXPECT_EQ(growth_with(K, C, unit).verdict, GrowthVerdict::none);
  EXPECT_EQ(growth_with(K, C, {0, 0, 0, 0}).verdict, GrowthVerdict::grows);
}

// A wire of masses of 1, with ω up to 2e4/s. The end has so little mass that it decays at the rate 2e6/s, and
// it does not affect the other masses: the eigenvalues are those of the wire and of the end, and all decay.
// For the σ that is best for the end, the eigenvalues of the wire are close to each other.
TEST(GrowthWithMass, IsNoneOfAWireWhoseEndIsMuchFaster) {
  for (const std::int32_t size : {200, 600, 2000}) {
    ThreeDiagonals K(size, -1e8, 2e8, -1e8);
    const SparsePattern& p = K.pattern;
    K.values[find_slot(p, size - 1, size - 2)] = 0;
    std::vector<double> C(K.values.size()), M(K.values.size());
    for (std::int32_t i = 0; i < size; ++i) C[find_slot(p, i, i)] = M[find_slot(p, i, i)] = 1;
    C.back() = 100, M.back() = 5e-5;
    const Growth growth = growth_with(K, C, M);
    EXPECT_EQ(growth.verdict, GrowthVerdict::none) << size << ": " << growth.rate;
  }
}

// Two bodies, which nothing joins to the wire or to each other, swing at 7/s like the wire beside them. They
// grow at the rates 0.15/s and 0.13/s, so that the Ritz values of 48 steps are not accurate.
TEST(GrowthWithMass, IsFoundAmongManySwingingNeighbours) {
  constexpr std::int32_t kSize = 50;
  ThreeDiagonals K(kSize, -100, 200, -100);
  std::vector<double> C(K.values.size()), M(K.values.size());
  for (std::int32_t i = 0; i < kSize; ++i) C[find_slot(K.pattern, i, i)] = M[find_slot(K.pattern, i, i)] = 1;
  for (const std::int32_t body : {kSize - 2, kSize - 1}) {
    const bool is_last = body == kSize - 1;
    for (const auto& [row, column] : {std::pair(body, body - 1), std::pair(body - 1, body)})
      K.values[find_slot(K.pattern, row, column)] = 0;
    K.values[find_slot(K.pattern, body, body)] = is_last ? 50 : 49;
    C[find_slot(K.pattern, body, body)] = is_last ? -0.3 : -0.255;
  }
  const Growth growth = growth_with(K, C, M);
  EXPECT_TRUE(growth.grows());
  EXPECT_NEAR(growth.rate, 0.15, 1e-3);
}

/// Ziegler's column: two rods of length 1 in a row, masses 2 and 1 at their ends, springs of 1 and dampers of
/// `damping` in both hinges, and a force P that follows the second rod. H. Ziegler, Die Stabilitätskriterien
/// der Elastomechanik, Ingenieur-Archiv 20 (1952).
Growth growth_of_column(double P, double damping) {
  ThreeDiagonals K(2, 0, 0, 0);
  K.values = {2 - P, -1, P - 1, 1};  // column by column
  return growth_with(K, {2 * damping, -damping, -damping, damping}, {3, 1, 1, 1});
}

// The characteristic equation 2 s⁴ + (7 − 2P) s² + 1 = 0 has roots off the imaginary axis for P > 7/2 − √2.
// Just beyond, with d = 2P − 7 and s² = (d ± i (8 − d²)^½)/4, the growth rate is the real part of s.
TEST(GrowthWithMass, FluttersByZieglersLoadWithoutDamping) {
  const double least = 3.5 - std::sqrt(2.0);
  EXPECT_NE(growth_of_column(0.99 * least, 0).verdict, GrowthVerdict::grows);
  const Growth g = growth_of_column(1.01 * least, 0);
  ASSERT_TRUE(g.grows());
  const double d = 2 * 1.01 * least - 7;
  const std::complex<double> s = std::sqrt(std::complex<double>(d / 4, std::sqrt(8 - d * d) / 4));
  EXPECT_NEAR(g.rate, s.real(), 1e-3 * s.real());
  EXPECT_NEAR(g.frequency, s.imag(), 1e-3 * s.imag());
}

// By Routh's criterion, 2s⁴ + 7γ s³ + (7 − 2P + γ²) s² + 2γ s + 1 = 0 has no root with a positive real part
// for P < 41/28 + γ²/2: a little damping reduces the critical load by a third (G. Herrmann and I.-C. Jong, On
// the destabilizing effect of damping in nonconservative elastic systems, J. Appl. Mech. 32, 1965).
TEST(GrowthWithMass, FluttersSoonerWithALittleDamping) {
  for (const double gamma : {0.1, 0.5, 1.0}) {
    const double least = 41.0 / 28 + gamma * gamma / 2;
    EXPECT_NE(growth_of_column(0.99 * least, gamma).verdict, GrowthVerdict::grows) << gamma;
    EXPECT_GT(growth_of_column(1.05 * least, gamma).rate, 0) << gamma;
  }
  EXPECT_TRUE(growth_of_column(1.8, 0.1).grows()) << "which stands without damping";
}

// The motion (x + iy)¨ = −(1 − ib)(x + iy) grows, although the symmetric part of K is positive, so that a
// first-order motion would decay.
TEST(GrowthWithMass, IsNotRuledOutByAPositiveSymmetricPart) {
  const ThreeDiagonals K(2, -0.3, 1, 0.3);
  const Growth g = growth_with(K, {0, 0, 0, 0}, {1, 0, 0, 1});
  ASSERT_TRUE(g.grows());
  EXPECT_NEAR(g.rate, std::sqrt(std::complex<double>(-1, 0.3)).real(), 1e-6);
  EXPECT_EQ(growth_without_mass(K, {2, 0, 1, 0}).verdict, GrowthVerdict::none);
}

// Three springs in a row, with a mass behind a node that has neither mass nor damping. The stiffness that
// acts on the mass is k₁ + k₂k₃/(k₂ + k₃).
TEST(GrowthWithMass, FollowsThroughNodesWithoutMass) {
  const auto growth_for = [](double k1, double k2, double k3) {
    ThreeDiagonals K(2, -k2, 0, -k2);
    K.values = {k1 + k2, -k2, -k2, k2 + k3};
    return growth_with(K, {0, 0, 0, 0}, {2, 0, 0, 0});
  };
  EXPECT_EQ(growth_for(-3, 10, 10).verdict, GrowthVerdict::none);
  const Growth g = growth_for(-7, 10, 10);
  ASSERT_TRUE(g.grows());
  EXPECT_NEAR(g.rate, 1, 1e-6);
  EXPECT_NEAR(g.mode[1] / g.mode[0], 0.5, 1e-6);
}

// The energy criterion (9) of linear_motion.hpp needs only Cholesky factors of M, C and K.
TEST(GrowthWithMass, AsksNoMotionWhereItsEnergyFalls) {
  const ThreeDiagonals K(200, -1, 2.5, -1), unit(200, 0, 1, 0);
  const CountedGrowth g = growth_with(K, unit.values, unit.values);
  EXPECT_EQ(g.verdict, GrowthVerdict::none);
  EXPECT_EQ(g.cost.factorisations, 3);
  EXPECT_EQ(g.cost.solves, 0);
}

// The verdict is compared with all eigenvalues of the full problem.
TEST(GrowthWithMass, IsFoundWhereverSomeEigenvalueGrows) {
  constexpr int kSize = 30;
  int grow = 0, decay = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const ThreeDiagonals K = random_matrix(kSize, 6, seed), C = random_matrix(kSize, 0.15 * seed, seed + 100);
    std::vector<double> M(C.values.size());
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2 * kSize, 2 * kSize);
    for (int i = 0; i < kSize; ++i) {
      const double mass = M[static_cast<std::size_t>(i * kSize + i)] = std::pow(10, 4.0 * i / kSize - 2);
      motion(i, kSize + i) = 1;
      for (int c = 0; c < kSize; ++c) {
        motion(kSize + i, c) = -K.values[static_cast<std::size_t>(c * kSize + i)] / mass;
        motion(kSize + i, kSize + c) = -C.values[static_cast<std::size_t>(c * kSize + i)] / mass;
      }
    }
    double most = -1;  // largest c = Re s/|s|, see (6) of growth.hpp
    for (const auto& s : motion.eigenvalues()) most = std::max(most, s.real() / std::abs(s));
    const Growth g = growth_with(K, C.values, M);
    if (most > 0.1) {
      EXPECT_TRUE(g.grows()) << seed << ": " << most;
    } else if (most > 0.02) {
      EXPECT_NE(g.verdict, GrowthVerdict::none) << seed << ": " << most;
    } else if (most <= 0) {
      EXPECT_EQ(g.verdict, GrowthVerdict::none) << seed << ": " << most;
    }
    ++(most > 0.1 ? grow : decay);
  }
  EXPECT_GT(grow, 10);
  EXPECT_GT(decay, 10);
}

/// A float of 5 kg at the head of a spring along x, with a lateral force that turns with the spring; the
/// float may move in x and y. For the spring, of length l and rest length 1:
///   K₁₁ = k (3 l² − 1)/2,   K₂₂ = k (l² − 1)/2,   K₁₂ = −K₂₁ = 3 push,   k = 1000 N/m
struct FloatOnSpring {
  double squared = 0.55, push = 0, speed = 0;  // l² [m²], [N], [m/s] along x
  static constexpr double kMass = 5;           // [kg]

  Growth growth() const {
    Sketch s;
    s.scene.water.gravity = 0;
    s.scene.current.samples = {{0, {speed, 0, 0}}};
    const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(std::sqrt(squared), 0, 0, 1 << 2);
    s.part("spring", "test/spring", {{"k", 1000.0}}, {foot, head}).data["rest_length"] = {1};
    s.part("push", "test/follower", {{"k", push}}, {foot, head}).data["rest_length"] = {1};
    s.part("float", "float/float", {{"float.buoyancy", 10.0}, {"float.diameter", 0.2}, {"float.mass", kMass}},
           {head})
        .data["pieces"] = {1};
    Assembled a(s.scene);
    Statistics cost;
    Factors factors(make_factorisation, cost);
    return find_growth(a.assembler, {a.assembler.start()}, factors);
  }

  /// The eigenvalue s with the largest real part. The drag damps twice as much along the flow as across it.
  std::complex<double> expected() const {
    const double k1 = 500 * (3 * squared - 1), k2 = 500 * (squared - 1), c = damping();
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(4, 4);
    motion.topRightCorner<2, 2>().setIdentity();
    motion.bottomLeftCorner<2, 2>() << -k1, -3 * push, 3 * push, -k2;
    motion.bottomRightCorner<2, 2>() << -2 * c, 0, 0, -c;
    motion.bottomRows<2>() /= kMass;
    std::complex<double> most = -1e9;
    for (const auto& s : motion.eigenvalues())
      if (s.real() > most.real()) most = s;
    return most;
  }
  /// Damping coefficient ½ ρ C_d (π/4) D² |W| [N s/m].
  double damping() const { return 0.5 * 1025 * 0.47 * 0.25 * std::numbers::pi * 0.04 * speed; }
};

// There is a divergence because det K = −0.325 x 0.225 k² + 9 push² < 0.
TEST(Growth, IsDivergenceWhateverTheFlow) {
  for (const double speed : {0.0, 1.0, 5.0}) {
    const FloatOnSpring f{.push = 30, .speed = speed};
    const Growth g = f.growth();
    ASSERT_TRUE(g.grows());
    EXPECT_EQ(g.frequency, 0);
    EXPECT_NEAR(g.rate, f.expected().real(), 1e-3 * g.rate);
  }
}

TEST(Growth, IsToldInSeconds) {
  const FloatOnSpring f{.push = 200, .speed = 1};
  const Growth g = f.growth();
  ASSERT_TRUE(g.grows());
  EXPECT_NEAR(g.rate, f.expected().real(), 1e-3 * g.rate);
  EXPECT_NEAR(g.frequency, std::abs(f.expected().imag()), 1e-3 * g.frequency);
}

// The float of the previous test, in still water: the turning force drives an oscillation. Whether it grows
// would depend on its damping, and still water has none.
TEST(Growth, IsMarginalWhereWhatSwingsIsNotDamped) {
  const FloatOnSpring f{.push = 200};
  EXPECT_GT(f.expected().real(), 1);
  EXPECT_EQ(f.growth().verdict, GrowthVerdict::marginal);
}

// With a taut spring, K₁₁ and K₂₂ are positive. The turning force causes flutter, which a sufficiently fast
// flow damps.
TEST(Growth, IsFlutterThatFastWaterCalms) {
  FloatOnSpring f{.squared = 1.2, .push = 250};
  double calm = 0;
  while (f.expected().real() > 0) f.speed = calm += 0.01;
  for (const double of : {0.5, 0.9, 1.1, 2.0}) {
    f.speed = of * calm;
    EXPECT_EQ(f.growth().grows(), of < 1) << of << " of " << calm << " m/s";
  }
}

/// A float of 5 kg on a rod of 2 m, above or below the foot of the rod, in a current.
Scene float_on_rod(double z, std::array<double, 3> current, const std::string& drag_law) {
  Sketch s;
  s.scene.current.samples = {{0, current}};
  const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(0.05, 0.02, z);
  Part& rod = s.rope("rod", {foot, head}, 2, 1e5);
  rod.parameters["rope.EA_compression"] = 1e5, rod.parameters["rope.diameter"] = 0.001;
  s.part("float", "float/float",
         {{"float.buoyancy", 100.0},
          {"float.diameter", 0.2},
          {"float.mass", 5.0},
          {"float.drag_law", drag_law}},
         {head})
      .data["pieces"] = {1};
  return s.scene;
}

/// Growth rate of a motion that starts with 0.1 mm of `mode`: the increase of the logarithm of the largest
/// displacement along `mode`, from the first third of `duration` to the last, divided by the time.
double rate_of_motion(const Scene& scene, const std::vector<double>& u, const std::vector<double>& mode,
                      double duration) {
  Moving m(scene, "newton");
  MarchState from = state_at_rest(m.assembler, u);
  for (std::size_t i = 0; i < u.size(); ++i) from.u[i] += 1e-4 * mode[i];
  double first = 0, last = 0;
  m.watch.on_step = [&](const StepRecord& step, std::span<const double> at) {
    double along = 0;
    for (std::size_t i = 0; i < u.size(); ++i) along += mode[i] * (at[i] - u[i]);
    double& largest = step.t < duration / 3 ? first : last;
    if (step.t < duration / 3 || step.t > 2 * duration / 3) largest = std::max(largest, std::abs(along));
    return false;
  };
  MarchSettings settings;
  settings.duration = duration, settings.step = duration / 1500, settings.adaptive = false;
  const MarchResult r = m.run("newmark", {{"chi", 0.0}}, settings, &from);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return std::log(last / first) / (2 * duration / 3);
}

// A third of the duration is a whole number of periods.
TEST(Growth, IsThatOfTheMotionOfAFloatInItsDragCrisis) {
  const Scene scene = float_on_rod(2, {1.7, 0, 0}, "sphere");
  const Solved s = solve_with("newton", scene);
  ASSERT_EQ(s.solution.status, SolveStatus::unstable) << s.solution.reason;
  EXPECT_TRUE(flutters(s.solution));
  EXPECT_EQ(s.solution.stability, Stability::swinging);
  const double swings = 6 * std::numbers::pi / s.solution.growing.frequency;
  EXPECT_NEAR(rate_of_motion(scene, s.solution.u, s.solution.growing.mode, swings), s.solution.growing.rate,
              0.1 * s.solution.growing.rate);
}

TEST(Growth, IsThatOfTheMotionOfAFloatThatTopples) {
  const Scene scene = float_on_rod(-2, {0, 0, 0.2}, "constant");
  const Solved s = solve_with("newton", scene, {{"method", std::string("classic")}});
  ASSERT_EQ(s.solution.status, SolveStatus::unstable) << s.solution.reason;
  EXPECT_FALSE(flutters(s.solution));
  EXPECT_EQ(s.solution.stability, Stability::unstable);
  const double duration = 3 / s.solution.growing.rate;
  EXPECT_NEAR(rate_of_motion(scene, s.solution.u, s.solution.growing.mode, duration), s.solution.growing.rate,
              0.1 * s.solution.growing.rate);
}

/// A float of 5 kg on a rod, above or below the foot of the rod, and 20 m away a float of mass `mass` on a
/// rod of the same length.
Scene two_floats_on_rods(double z, double mass, double other_z) {
  Sketch s;
  s.scene.current.samples = {{0, {0, 0, 0.2}}};
  const auto add = [&](double x, double height, double of_mass) {
    const auto foot = s.node(x, 0, 0, kAllAxes), head = s.node(x + 0.05, 0.02, height);
    Part& rod = s.rope("rod", {foot, head}, 2, 1e5);
    rod.parameters["rope.EA_compression"] = 1e5, rod.parameters["rope.diameter"] = 0.001;
    s.part("float", "float/float",
           {{"float.buoyancy", 100.0}, {"float.diameter", 0.2}, {"float.mass", of_mass}}, {head})
        .data["pieces"] = {1};
  };
  add(0, z, 5);
  add(20, other_z, mass);
  return s.scene;
}

// The rods have a mass of 0.01 kg, and the floats have no volume, so that they move no water.
TEST(Growth, IsLocalIfItMovesLittleOfTheMass) {
  const Values classic{{"method", std::string("classic")}};
  const Solution small = solve_with("newton", two_floats_on_rods(-2, 20000, 2), classic).solution;
  EXPECT_EQ(small.status, SolveStatus::converged) << small.reason;
  EXPECT_EQ(small.stability, Stability::local);
  EXPECT_NEAR(small.growing.share, 5.0 / 20005, 0.01 * 5 / 20005);
  const Solution large = solve_with("newton", two_floats_on_rods(-2, 500, 2), classic).solution;
  EXPECT_EQ(large.status, SolveStatus::unstable) << large.reason;
  EXPECT_NEAR(large.growing.share, 5.0 / 505, 0.01 * 5 / 505);
}

TEST(Growth, IsNotLocalIfTheRestGrowsToo) {
  const Values classic{{"method", std::string("classic")}};
  const Solution both = solve_with("newton", two_floats_on_rods(-2, 20000, -2), classic).solution;
  EXPECT_EQ(both.status, SolveStatus::unstable) << both.reason;
  EXPECT_EQ(both.stability, Stability::unstable);
}

TEST(Growth, IsNoneOfAFloatThatStandsUp) {
  const Solved s = solve_with("newton", float_on_rod(2, {0, 0, 0.2}, "constant"));
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_EQ(s.solution.stability, Stability::stable);
}

}  // namespace
}  // namespace netloft::test
