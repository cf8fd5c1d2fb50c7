// SPDX-License-Identifier: BSD-3-Clause
//
// Resistance to opening and knot contact compared with their energies differentiated by dual numbers, and
// with values by hand.
#include "plugins/priour/knot_contact.hpp"
#include "plugins/priour/opening.hpp"

#include "tests/unit/plugins/priour/panels.hpp"

#include <Eigen/Eigenvalues>

#include <numbers>

namespace {

using namespace netloft;
using namespace netloft::priour;

constexpr double kPi = std::numbers::pi;

Triangle::Parameters twine(double opening_stiffness, double opening_angle = 0, double knot_size = 0) {
  Triangle::Parameters p{1e4, 1, 0.004, 1140};
  p.opening_stiffness = opening_stiffness, p.opening_angle = opening_angle, p.knot_size = knot_size;
  return p;
}

/// Places corners so that meshes have the half angle `half_angle(lane)`, in any plane, with bars of 0.07 to
/// 0.13 m.
template <class HalfAngle>
void place_corners(TestTile<3>& tile, const std::vector<Triangle::Data>& data, HalfAngle&& half_angle) {
  std::mt19937_64 random(3);
  const auto draw = [&] {
    return Vec3<double>{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Vec3<double> e = draw(), f = cross(e, draw());
    e = (1 / norm(e)) * e, f = (1 / norm(f)) * f;
    const double alpha = half_angle(lane);
    const Vec3<double> U = uniform(random, 0.07, 0.13) * (std::cos(alpha) * e + std::sin(alpha) * f);
    const Vec3<double> V = uniform(random, 0.07, 0.13) * (std::cos(alpha) * e - std::sin(alpha) * f);
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        tile.x[(3 * corner + static_cast<std::size_t>(axis)) * kLanes + lane] =
            data[lane].u[corner] * U[axis] + data[lane].v[corner] * V[axis];
  }
}

/// Values from `lo` to `hi`, one per lane.
auto spread(double lo, double hi) {
  return [lo, hi](std::size_t lane) { return lo + (hi - lo) * double(lane) / (kLanes - 1); };
}

template <class Kernel, class Oracle = Kernel>
void expect_matches(const Triangle::Parameters& p, double lo, double hi, double tolerance = 1e-12) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(lo, hi));
  tile.want_tangent();
  const auto family = make_family<Triangle>(p, data);
  ASSERT_EQ(Kernel::tile(family, tile.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto e = oracle<Triangle, Oracle, 3>(p, data[lane], kSeaWater, tile, lane);
    EXPECT_NEAR(tile.energy[lane], e.value, tolerance * std::abs(e.value)) << "energy of lane " << lane;
    EXPECT_LT(relative_error(tile.force, e.gradient, lane), tolerance) << "force of lane " << lane;
    EXPECT_LT(relative_error(tile.tangent, e.hessian, lane), tolerance) << "tangent of lane " << lane;
  }
}

TEST(Opening, MatchesItsOracleInOpenMeshes) { expect_matches<OpeningGiven>(twine(0.3), 0.2, 1.4, 1e-11); }

TEST(Opening, MatchesItsOracleAroundTheAngleAtRest) {
  expect_matches<OpeningGiven>(twine(0.3, 0.7), 0.1, 1.4, 1e-10);
}

TEST(Opening, MatchesItsOracleWhereTheSeriesTakesOver) {  // e = 0.1 is α = 0.2255
  expect_matches<OpeningGiven>(twine(0.3), 0.22, 0.23, 1e-11);
}

/// The energy for nearly closed meshes, from three terms of the series of α² in e = 1 − c, with a relative
/// error of e³.
struct NearlyClosed {
  template <class T>
  static T oracle(const Triangle::Parameters& p, const Triangle::Data& d, const Water&,
                  const Points<T, 3>& x) {
    const T e = T(1) - angle::cosine(d, x);
    return Triangle::shape(d).bars * p.opening_stiffness * (e / T(2) + e * e / T(12) + e * e * e / T(45));
  }
};

TEST(Opening, IsSmoothThroughClosedMeshes) {
  expect_matches<OpeningGiven, NearlyClosed>(twine(0.3), 1e-3, 2e-3, 1e-9);
}

TEST(Opening, HasATangentInExactlyClosedMeshes) {
  const auto data = panels();
  const auto p = twine(0.3);
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(0, 0));
  tile.want_tangent();
  const auto family = make_family<Triangle>(p, data);
  ASSERT_EQ(OpeningGiven::tile(family, tile.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto e = oracle<Triangle, NearlyClosed, 3>(p, data[lane], kSeaWater, tile, lane);
    EXPECT_NEAR(tile.energy[lane], 0, 1e-15) << lane;
    EXPECT_LT(relative_error(tile.tangent, e.hessian, lane), 1e-12) << lane;
  }
}

TEST(Opening, HasTheEnergyOfTwoCouplesAtEveryKnot) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(0.3, 1.2));
  const auto family = make_family<Triangle>(twine(0.3, 0.5), data);
  ASSERT_EQ(OpeningGiven::tile(family, tile.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto &u = data[lane].u, &v = data[lane].v;
    const double d = std::abs((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]));
    const double turned = spread(0.3, 1.2)(lane) - 0.5;
    EXPECT_NEAR(tile.energy[lane], d / 2 * 0.3 * turned * turned, 1e-13) << lane;  // equation (1)
  }
}

TEST(Opening, ComesOutOfTheBendingStiffnessOfTheTwines) {
  auto p = twine(0);
  p.EI = 2e-3;
  EXPECT_DOUBLE_EQ(Triangle::opening_stiffness(p, {{0, 1, 0}, {0, 0, 1}, 0.1}), 12 * 2e-3 / 0.1);
  expect_matches<OpeningOfTwines>(p, 0.3, 1.3, 1e-11);
}

TEST(Opening, RefusesTwoAnswersToOneQuestion) {
  auto p = twine(0.3);
  p.EI = 2e-3;
  EXPECT_THROW(Triangle::check(p, {{0, 1, 0}, {0, 0, 1}, 0.1}), std::invalid_argument);
}

Status evaluate_opening(const Triangle::Parameters& p, double half_angle) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(half_angle, half_angle));
  const auto family = make_family<Triangle>(p, data);
  return OpeningGiven::tile(family, tile.t);
}

TEST(Opening, IsOutsideItsDomainAtACusp) {
  EXPECT_THROW(evaluate_opening(twine(0.3, 0.7), 2e-9), OutsideDomain);
  EXPECT_THROW(evaluate_opening(twine(0.3, 0.7), kPi / 2 - 2e-9), OutsideDomain);
  EXPECT_THROW(evaluate_opening(twine(0.3), kPi / 2 - 2e-9), OutsideDomain);
  EXPECT_EQ(evaluate_opening(twine(0.3, 0.7), 1e-6), Status::ok);
  EXPECT_EQ(evaluate_opening(twine(0.3), 2e-9), Status::ok);
  EXPECT_EQ(evaluate_opening(twine(0), kPi / 2), Status::ok);
}

// Knots of 0.06 m on bars of 0.1 m touch at α = 0.2915.
TEST(KnotContact, MatchesItsOracleWhereKnotsTouch) {
  expect_matches<KnotContact>(twine(0, 0, 0.06), 0.01, 0.28, 1e-11);
}

TEST(KnotContact, MatchesItsOracleInFlatMeshes) {
  expect_matches<KnotContact>(twine(0, 0, 0.06), kPi / 2 - 0.28, kPi / 2 - 0.01, 1e-11);
}

TEST(KnotContact, IsNotThereInOpenMeshes) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(0.292, kPi / 2 - 0.292));
  tile.want_tangent();
  const auto family = make_family<Triangle>(twine(0, 0, 0.06), data);
  ASSERT_EQ(KnotContact::tile(family, tile.t), Status::ok);
  for (const double k : tile.tangent) EXPECT_EQ(k, 0);
  for (const double e : tile.energy) EXPECT_EQ(e, 0);
}

TEST(KnotContact, HoldsAMeshUnderTensionWhereItSays) {  // a rhombus pulled lengthwise: -2 T a cos α per knot
  const double a = 0.1, EA = 1e4, T = EA / 100;
  const auto p = twine(0, 0, 0.06);
  const double touch = Triangle::touching_cosine(p, {{0, 1, 0}, {0, 0, 1}, a});
  const double y = std::sqrt(T / (6 * EA)), c = touch + y * (1 - touch), alpha = 0.5 * std::acos(c);
  const double closing = 2 * T * a * std::sin(alpha);
  const double holding = 3 * EA * a * y * y * 2 * std::sin(2 * alpha);  // −dE/dα of equation (3)
  EXPECT_NEAR(holding / closing, 1, 0.05);                              // cos α is not quite one
}

TEST(KnotContact, IsReportedFromTouchToClosed) {
  const Triangle::Data data{{0, 10, 0}, {0, 0, 10}, 0.1};
  const auto p = twine(0, 0, 0.06);
  const auto depth_at = [&](double alpha, const Triangle::Parameters& of) {
    State<3> s;  // twines at ± alpha to the x axis
    s.x[1] = {std::cos(alpha), std::sin(alpha), 0}, s.x[2] = {std::cos(alpha), -std::sin(alpha), 0};
    return KnotContact::depth(of, data, s);
  };
  EXPECT_EQ(depth_at(0.5, p), 0);
  EXPECT_NEAR(depth_at(std::atan(0.3), p), 0, 1e-15);
  EXPECT_NEAR(depth_at(0, p), 1, 1e-15);
  EXPECT_NEAR(depth_at(kPi / 2, p), 1, 1e-15);
  EXPECT_EQ(depth_at(0, twine(0)), 0);
}

TEST(KnotContact, RefusesKnotsLargerThanMeshes) {
  EXPECT_THROW(Triangle::check(twine(0, 0, 0.2), {{0, 1, 0}, {0, 0, 1}, 0.1}), std::invalid_argument);
}

/// Returns the exact tangent and the convex part of a lane as square matrices.
template <class Term>
std::pair<Eigen::MatrixXd, Eigen::MatrixXd> both_matrices(const Family<Triangle>& family, TestTile<3>& tile,
                                                          std::size_t lane) {
  Eigen::MatrixXd matrix[2];
  for (const std::uint32_t want : {std::uint32_t{NETLOFT_WANT_TANGENT}, NETLOFT_WANT_CONVEX}) {
    std::fill(std::begin(tile.tangent), std::end(tile.tangent), 0.0);
    tile.t.want = want, tile.t.tangent = tile.tangent, tile.t.energy = nullptr, tile.t.force = nullptr;
    EXPECT_EQ(Term::tile(family, tile.t), Status::ok);
    Eigen::MatrixXd m(9, 9);
    for (int r = 0; r < 9; ++r)
      for (int c = 0; c <= r; ++c) m(r, c) = m(c, r) = tile.tangent[at(r * (r + 1) / 2 + c, lane)];
    matrix[want == NETLOFT_WANT_CONVEX] = m;
  }
  return {matrix[0], matrix[1]};
}

/// The convex part and its excess over the tangent must be positive semi-definite, and the convex part must
/// not be much larger than the tangent.
template <class Term>
void expect_convex_part(const Triangle::Parameters& p, double lo, double hi) {
  const auto data = panels();
  TestTile<3> tile(kSeaWater);
  place_corners(tile, data, spread(lo, hi));
  const auto family = make_family<Triangle>(p, data);
  for (std::size_t lane = 0; lane < kLanes; lane += 7) {
    const auto [exact, convex] = both_matrices<Term>(family, tile, lane);
    const double size = exact.cwiseAbs().maxCoeff();
    const auto least = [](const Eigen::MatrixXd& m) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()[0];
    };
    EXPECT_GT(least(convex), -1e-12 * size) << lane;
    EXPECT_GT(least(convex - exact), -1e-12 * size) << lane;
    EXPECT_LT(convex.cwiseAbs().maxCoeff(), 4 * size) << lane;
  }
}

TEST(AngleEnergies, HaveAConvexPartAboveTheirTangent) {
  expect_convex_part<OpeningGiven>(twine(0.3), 0, 1.5);
  expect_convex_part<OpeningGiven>(twine(0.3, 0.7), 0.01, 1.5);
  expect_convex_part<KnotContact>(twine(0, 0, 0.06), 0, 0.28);
  expect_convex_part<KnotContact>(twine(0, 0, 0.06), 1.3, kPi / 2);
}

}  // namespace
