// SPDX-License-Identifier: BSD-3-Clause
//
// On a plane, seabed/bed equals seabed/plane. On a hill, the contact force is normal to the hill, and
// friction has the right magnitude.
#include "plugins/seabed/bed.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

#include <numbers>

namespace {

using namespace netloft;
using seabed::OnBed;
using seabed::Plane;

constexpr double kSoft = 0.02;

OnBed::Parameters firm() { return {.stiffness = 3e4, .softness = kSoft, .friction = 0.6, .radius = 0}; }

/// A bed with slopes and curvature below the origin.
Bed hill(double height) {
  return {.is_there = true,
          .height = height,
          .slope_x = 0.2,
          .slope_y = -0.1,
          .xx = 0.03,
          .xy = 0.01,
          .yy = -0.02};
}

State<1> node_over(const Bed& bed, double z) {
  State<1> s;
  s.bed[0] = bed, s.x[0] = {0, 0, z};
  return s;
}

TEST(SeabedBed, PressesAsAPlaneWhereItIsLevel) {
  Plane::Parameters plane;
  plane.depth = 0, plane.stiffness = 3e4, plane.softness = kSoft;
  for (const double z : {-0.005, -0.015, -0.1, 0.05}) {
    const State<1> s = node_over({.is_there = true}, z);
    EXPECT_NEAR(OnBed::normal_force(firm(), {2, 0}, {}, s), Plane::normal_force(plane, {2, 0}, s), 1e-9) << z;
  }
}

TEST(SeabedBed, PushesAlongItsNormalAndStiffensWhereItIsHollow) {
  Local<1> out;
  const State<1> s = node_over(hill(-40), -40.1);
  ASSERT_EQ(OnBed::Contact::evaluate(firm(), {2, 0}, {}, s, out), Status::ok);
  const double push = 2 * 3e4 * (0.1 - kSoft / 2);
  EXPECT_NEAR(out.force[0].z, -push, 1e-9);  // of the residual, hence downwards
  EXPECT_NEAR(out.force[0].x, 0.2 * push, 1e-9);
  EXPECT_NEAR(out.force[0].y, -0.1 * push, 1e-9);
  EXPECT_NEAR(out.tangent[2][2], 6e4, 1e-9);
  EXPECT_NEAR(out.tangent[0][0], 6e4 * 0.04 + push * 0.03, 1e-9);
}

// The normal force begins where the gap changes its sign.
TEST(SeabedBed, HasAGapAboveAndBelowItsSurface) {
  OnBed::Parameters p = firm();
  p.radius = 0.25;
  for (const double height : {-0.02, -1e-9, 1e-9, 0.4}) {
    const State<1> s = node_over(hill(-40), -40 + p.radius + height);
    EXPECT_NEAR(OnBed::gap(p, s), height, 1e-14);
    EXPECT_EQ(OnBed::normal_force(p, {2, 0}, {}, s) > 0, height < 0) << height;
  }
}

TEST(SeabedBed, LiesDeeperUnderBobbins) {
  OnBed::Parameters p = firm();
  p.radius = 0.25;
  EXPECT_EQ(OnBed::normal_force(p, {2, 0}, {}, node_over(hill(-40), -39.74)), 0);
  EXPECT_GT(OnBed::normal_force(p, {2, 0}, {}, node_over(hill(-40), -39.80)), 0);
}

TEST(SeabedBed, RubsByItsShareOfTheNormalForceAlongTheGroundThatPasses) {
  const State<1> s = node_over(hill(-40), -40.1);
  MovingNodes<double, 1> m;
  m.x[0] = s.x[0], m.bed[0] = s.bed[0], m.ground = {1.5, 0, 0};
  const Vec3<double> rub = OnBed::Friction::force(firm(), {2, 0}, {}, m)[0];
  EXPECT_NEAR(norm(rub), 0.6 * OnBed::normal_force(firm(), {2, 0}, {}, s), 1e-9);
  EXPECT_NEAR(dot(rub, {-0.2, 0.1, 1}), 0, 1e-9) << "along the hill";
  EXPECT_GT(rub.x, 0) << "aft, with the ground";
  m.ground = {};
  EXPECT_EQ(norm(OnBed::Friction::force(firm(), {2, 0}, {}, m)[0]), 0) << "what stands does not rub";
}

/// At the frequency of the loss factor η, a bed in compression loses η times its elastic energy per radian.
TEST(SeabedBed, LosesItsShareOfASwingInEveryRadian) {
  OnBed::Parameters p = firm();
  p.loss_factor = 0.2, p.loss_frequency = 1.5;
  const double depth = 0.1, amplitude = 1e-3, omega = 2 * std::numbers::pi * p.loss_frequency;
  MovingNodes<double, 1> m;
  m.bed[0] = {.is_there = true, .height = -40}, m.x[0] = {0, 0, -40 - depth};
  double lost = 0;
  constexpr int kSteps = 4000;  // of one period
  for (int i = 0; i < kSteps; ++i) {
    const double v = amplitude * omega * std::cos(2 * std::numbers::pi * (i + 0.5) / kSteps);
    m.v[0] = {0.3, 0, v};
    const Vec3<double> f = OnBed::Loss::force(p, {2, 0}, {}, m)[0];
    EXPECT_EQ(f.x, 0) << "along the bed there is friction";
    lost -= f.z * v / (kSteps * p.loss_frequency);
  }
  EXPECT_NEAR(lost, 2 * std::numbers::pi * 0.2 * 0.5 * 6e4 * amplitude * amplitude, 1e-9);
  m.v[0] = {0, 0, 100};
  const State<1> s = node_over(m.bed[0], m.x[0].z);
  EXPECT_NEAR(-OnBed::Loss::force(p, {2, 0}, {}, m)[0].z, OnBed::normal_force(p, {2, 0}, {}, s), 1e-9)
      << "a bed does not pull";
  m.x[0].z = -39.9;
  EXPECT_EQ(norm(OnBed::Loss::force(p, {2, 0}, {}, m)[0]), 0) << "clear of the bed";
}

/// A bottom whose stiffness factor grows from 0.5 at x = -1 to 1.5 at x = 1, with more friction to starboard.
OnBed::Whole mixed() {
  return {Surface({-1, 1}, {-1, 1}, {0.5, 0.5, 1.5, 1.5}), Surface({-1, 1}, {-1, 1}, {1, 3, 1, 3})};
}

TEST(SeabedBed, PressesAndRubsByWhatTheBedIsMadeOf) {
  State<1> s = node_over(hill(-40), -40.1);
  s.x[0].x = -2, s.x[0].y = 2;  // beyond the grid, factors are those at its edge
  const double N = OnBed::normal_force(firm(), {2, 0}, {}, s);
  EXPECT_NEAR(OnBed::normal_force(firm(), {2, 0}, mixed(), s), 0.5 * N, 1e-9);
  MovingNodes<double, 1> m;
  m.x[0] = s.x[0], m.bed[0] = s.bed[0], m.bed[0].x = s.x[0].x, m.bed[0].y = s.x[0].y, m.ground = {1.5, 0, 0};
  EXPECT_NEAR(norm(OnBed::Friction::force(firm(), {2, 0}, mixed(), m)[0]), 3 * 0.6 * 0.5 * N, 1e-9);
}

TEST(SeabedBed, HasTheForceAndTheStiffnessOfItsEnergyOnAMixedBottom) {
  const auto at = [](double x, double y, double z) {
    Bed b = hill(-40);
    const double h = b.below(Vec3<double>{x, y, z});  // the same hill, relative to this point
    b.height = h, b.slope_x += b.xx * x + b.xy * y, b.slope_y += b.xy * x + b.yy * y, b.x = x, b.y = y;
    State<1> s;
    s.bed[0] = b, s.x[0] = {x, y, z}, s.cu = 1;
    Local<1> out;
    EXPECT_EQ(OnBed::Contact::evaluate(firm(), {2, 0}, mixed(), s, out), Status::ok);
    return out;
  };
  const double x[3] = {0.3, -0.2, -40.1}, h = 1e-5;
  const Local<1> here = at(x[0], x[1], x[2]);
  for (int c = 0; c < 3; ++c) {
    double up[3] = {x[0], x[1], x[2]}, down[3] = {x[0], x[1], x[2]};
    up[c] += h, down[c] -= h;
    const Local<1> a = at(up[0], up[1], up[2]), b = at(down[0], down[1], down[2]);
    EXPECT_NEAR((a.energy - b.energy) / (2 * h), here.force[0][c], 1e-6 * norm(here.force[0]));
    for (int r = 0; r < 3; ++r)
      EXPECT_NEAR((a.force[0][r] - b.force[0][r]) / (2 * h), here.tangent[r][c], 1e-6 * here.tangent[2][2]);
  }
}

/// A tile with one node on a bed at rest: the inputs that the host gives, and the memory of the node.
struct AtRest {
  explicit AtRest(const OnBed::Parameters& p, const OnBed::Whole& whole = {}) {
    family.parameters_ = {p}, family.part_ = {0}, family.data_ = {{2, 0}}, family.wholes_ = {whole};
    t.size = sizeof t, t.count = 1, t.cu = 0.7, t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
    t.x = x, t.force = force, t.tangent = tangent, t.inputs = inputs;
  }
  /// `below`: the bed under the origin.
  void evaluate(const Bed& below, const Vec3<double>& at) {
    const double rows[6] = {below.below(at),
                            below.slope_x + below.xx * at.x + below.xy * at.y,
                            below.slope_y + below.xy * at.x + below.yy * at.y,
                            below.xx,
                            below.xy,
                            below.yy};
    for (std::size_t k = 0; k < 6; ++k) bed[k * kLanes] = rows[k];
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis * kLanes] = at[static_cast<int>(axis)];
    std::fill_n(force, 3 * kLanes, 0.0);
    std::fill_n(tangent, 9 * kLanes, 0.0);
    ASSERT_EQ(OnBed::Friction::tile(family, t), Status::ok);
  }
  void stick_to(const Vec3<double>& anchor) {
    for (std::size_t axis = 0; axis < 3; ++axis) state[axis * kLanes] = anchor[static_cast<int>(axis)];
    state[3 * kLanes] = 1;
  }
  Family<OnBed> family;
  double x[3 * kLanes] = {}, bed[6 * kLanes] = {}, force[3 * kLanes] = {}, tangent[9 * kLanes] = {};
  double state[4 * kLanes] = {}, state_new[4 * kLanes] = {};
  netloft_ground ground{sizeof ground, 0, nullptr, bed};
  netloft_remembered memory{sizeof memory, 0, state, state_new};
  const void* inputs[detail::kInputPlaces] = {&ground, nullptr, &memory};
  netloft_tile t{};
};

OnBed::Parameters sticky() {
  OnBed::Parameters p = firm();
  p.shear_stiffness = 2e4;
  return p;
}

TEST(SeabedBed, SticksAndSlidesAsAPlaneWhereItIsLevelAndAtRest) {
  Plane::Parameters plane;
  plane.depth = 40, plane.stiffness = 3e4, plane.softness = kSoft, plane.friction = 0.6;
  plane.shear_stiffness = 2e4;
  const auto family = make_family<Plane>(plane, {{2, 0}});
  for (const Vec3<double>& at :
       {Vec3<double>{0.01, -0.02, -40.1}, {0.5, 0.3, -40.1}, {0.5, 0.3, -40.01}, {0.5, 0.3, -39}}) {
    AtRest node(sticky());
    node.stick_to({0, 0, -40});
    node.evaluate({.is_there = true, .height = -40}, at);
    const std::vector<double> force(node.force, node.force + 3 * kLanes),
        tangent(node.tangent, node.tangent + 9 * kLanes), state(node.state_new, node.state_new + 4 * kLanes);
    std::fill_n(node.force, 3 * kLanes, 0.0);
    std::fill_n(node.tangent, 9 * kLanes, 0.0);
    ASSERT_EQ(Plane::Friction::tile(family, node.t), Status::ok);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(force[i * kLanes], node.force[i * kLanes], 1e-9);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(tangent[i * kLanes], node.tangent[i * kLanes], 1e-7);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(state[i * kLanes], node.state_new[i * kLanes], 1e-12);
  }
}

/// Compares the tangent with central differences on a hill with a mixed bottom.
void expect_tangent_of_friction(const Vec3<double>& anchor) {
  AtRest node(sticky(), mixed());
  node.stick_to(anchor);
  const Vec3<double> at{0.3, -0.2, -40.1};
  node.evaluate(hill(-40), at);
  const std::vector<double> K(node.tangent, node.tangent + 9 * kLanes);
  EXPECT_GT(std::abs(K[0]), 1);
  for (std::size_t c = 0; c < 3; ++c) {
    const double h = 1e-6;
    double slope[3] = {};
    for (const double sign : {1.0, -1.0}) {
      Vec3<double> there = at;
      there[static_cast<int>(c)] += sign * h;
      node.evaluate(hill(-40), there);
      for (std::size_t r = 0; r < 3; ++r) slope[r] += sign * node.force[r * kLanes] / (2 * h);
    }
    for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(K[(3 * r + c) * kLanes], 0.7 * slope[r], 1e-2) << r << c;
  }
}

TEST(SeabedBed, HasTheDerivativeAsTangentWhileItSticks) { expect_tangent_of_friction({0.28, -0.21, -40.1}); }
TEST(SeabedBed, HasTheDerivativeAsTangentWhileItSlides) { expect_tangent_of_friction({-2, 1, -40.3}); }

TEST(SeabedBed, RemembersNothingWhereItPasses) {
  AtRest node(sticky());
  const double ground[3] = {1.5, 0, 0};
  node.ground.velocity = ground, node.memory.state = nullptr;
  node.evaluate(hill(-40), {0, 0, -40.1});
  EXPECT_LT(node.force[0], 0) << "the residual: aft, with the ground";
  EXPECT_EQ(node.state_new[3 * kLanes], 0);
}

TEST(SeabedBed, IsNothingWhereTheSceneHasNone) {
  Local<1> out;
  ASSERT_EQ(OnBed::Contact::evaluate(firm(), {2, 0}, {}, node_over({}, -1e4), out), Status::ok);
  EXPECT_EQ(out.energy, 0);
}

}  // namespace
