// SPDX-License-Identifier: BSD-3-Clause
//
// The flat plate of board/otter compared with a vortex lattice at small angles, and with known values at
// larger angles.
#include "plugins/board/plate.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace netloft::boards {
namespace {

constexpr double kDegree = M_PI / 180;

PlateForce<double> at_incidence(double degrees, double chord, double span) {
  return plate_force(Vec3<double>{std::cos(degrees * kDegree), std::sin(degrees * kDegree), 0}, chord, span);
}

/// dC_L/dα and the centre of pressure over the chord of a flat plate at small angles, by horseshoe vortices
/// (J. J. Bertin and M. L. Smith, Aerodynamics for engineers, 1989, section 7.5).
std::pair<double, double> of_lattice(double aspect) {
  constexpr int kChord = 10, kSpan = 30, kAll = kChord * kSpan;
  const double dx = 1.0 / kChord, dy = aspect / kSpan;
  const auto leg = [](double x, double y) { return (1 + std::hypot(x, y) / x) / y; };
  Eigen::MatrixXd wash(kAll, kAll);
  for (int i = 0; i < kAll; ++i)
    for (int j = 0; j < kAll; ++j) {
      const double x = (i / kSpan - j / kSpan + 0.5) * dx, y = (i % kSpan - j % kSpan) * dy;
      wash(i, j) = (leg(x, y + dy / 2) - leg(x, y - dy / 2)) / (4 * M_PI);
    }
  const Eigen::VectorXd circulation = wash.partialPivLu().solve(Eigen::VectorXd::Ones(kAll));
  double all = 0, moment = 0;
  for (int j = 0; j < kAll; ++j) {
    all += circulation[j];
    moment += circulation[j] * (j / kSpan + 0.25) * dx;
  }
  return {2 * all * dy / aspect, moment / all};
}

TEST(FlatPlate, LiftsAtSmallAnglesAsALatticeOfVortices) {
  for (const double aspect : {0.4, 0.5, 0.667, 0.8, 1.0, 1.5, 2.0, 3.0}) {
    const auto [slope, centre] = of_lattice(aspect);
    const auto plate = at_incidence(0.01, 1, aspect);
    EXPECT_NEAR(plate.normal / (0.01 * kDegree), slope, 0.05 * slope) << aspect;
    EXPECT_NEAR(0.5 + plate.ahead_chord, centre, 0.004) << aspect;
  }
}

TEST(FlatPlate, IsADiscOfDragAcrossTheFlow) {
  const auto plate = at_incidence(90, 2, 1);
  EXPECT_NEAR(plate.normal, 1.11 + 0.018 * 2, 1e-12);
  EXPECT_NEAR(plate.ahead_chord, 0, 1e-12);
}

/// A plate in a flow along its span is the same as a plate of the reciprocal aspect ratio.
TEST(FlatPlate, IsTheSamePlateSeenFromItsOtherEdge) {
  for (const double degrees : {5.0, 25.0, 36.0, 50.0, 80.0}) {
    const auto along = at_incidence(degrees, 2.7, 1.8);
    const auto up =
        plate_force(Vec3<double>{0, std::sin(degrees * kDegree), std::cos(degrees * kDegree)}, 1.8, 2.7);
    EXPECT_NEAR(along.normal, up.normal, 1e-12);
    EXPECT_NEAR(along.ahead_chord, up.ahead_span, 1e-12);
  }
}

TEST(FlatPlate, IsHalfOfOneOfTwiceTheSpanOnTheBed) {
  const Vec3<double> w{std::cos(0.5), std::sin(0.5), 0};
  const auto on_bed = plate_force(w, 2.7, 1.8, 1.0), whole = plate_force(w, 2.7, 3.6);
  EXPECT_NEAR(on_bed.normal, whole.normal, 0.03);  // the difference is only that the bed does not change C_90
  EXPECT_NEAR(on_bed.ahead_chord, whole.ahead_chord, 1e-12);
}

TEST(FlatPlate, HasNoJumpAnywhere) {
  for (const double aspect : {0.3, 1.0, 3.0}) {
    double last = at_incidence(0.05, 1, aspect).normal;
    for (double degrees = 0.1; degrees <= 90; degrees += 0.05) {
      const double now = at_incidence(degrees, 1, aspect).normal;
      EXPECT_LT(std::abs(now - last), 0.01) << aspect << " at " << degrees;
      last = now;
    }
  }
}

/// Square plates have the greatest lift coefficient, about 1.1, near 34°; plates of twice the width have 1.0
/// near 24° (Hoerner and Borst).
TEST(FlatPlate, StallsWhereSquareAndWidePlatesDo) {
  for (const auto& [aspect, angle] : {std::pair{1.0, 36.0}, std::pair{2.0, 26.0}}) {
    double best = 0, most = 0;
    for (double degrees = 5; degrees <= 60; degrees += 0.5) {
      const double lift = at_incidence(degrees, 1, aspect).normal * std::cos(degrees * kDegree);
      if (lift > most) most = lift, best = degrees;
    }
    EXPECT_NEAR(best, angle, 5) << aspect;
    EXPECT_GT(most, 0.9);
    EXPECT_LT(most, 1.5);
  }
}

}  // namespace
}  // namespace netloft::boards
