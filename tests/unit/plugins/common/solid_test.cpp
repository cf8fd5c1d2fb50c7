// SPDX-License-Identifier: BSD-3-Clause
//
// The inertia of a rigid body does not depend on the choice of its axes and origin.
#include "plugins/common/solid.hpp"

#include <gtest/gtest.h>

namespace {

using namespace netloft;
using solids::Inertia;
using solids::Sided;
using solids::Solid;
using V = Vec3<double>;

constexpr double kSmall = 1e-10;

Solid board() {
  Solid p;
  p.mass = 800, p.inertia_x = 220, p.inertia_y = 716, p.inertia_z = 496;
  p.added_x = 100, p.added_y = 4860, p.added_z = 300;
  p.turning_x = 499, p.turning_y = 20, p.turning_z = 1690;
  return p;
}

Body<double> moving() {
  Body<double> b;
  b.axes = turned_axes(V{0.3, -0.8, 1.1});
  b.x = {5, 3, -40}, b.v = {1.2, -0.4, 0.3}, b.omega = {0.7, -1.1, 0.5};
  b.a = {0.2, 0.9, -0.6}, b.alpha = {-0.3, 0.4, 1.3};
  return b;
}

void expect_same(const Wrench<double>& one, const Wrench<double>& other) {
  EXPECT_LT(norm(one.force - other.force), kSmall * norm(one.force));
  EXPECT_LT(norm(one.moment - other.moment), kSmall * norm(one.moment));
}

/// The same body, written in axes that are rotated back by ψ. The rotation vector ψ then leads from these
/// axes to the principal axes.
TEST(Solid, MovesTheSameWhateverAxesItIsWrittenIn) {
  const V psi{0.4, -0.2, 0.7};
  const Body<double> b = moving();
  Body<double> other = b;
  const auto back = turned_axes(V{-psi.x, -psi.y, -psi.z});
  for (int i = 0; i < 3; ++i)
    other.axes[static_cast<std::size_t>(i)] = b.to_world(back[static_cast<std::size_t>(i)]);
  Solid p = board();
  p.inertia_turned_x = p.added_turned_x = psi.x, p.inertia_turned_y = p.added_turned_y = psi.y;
  p.inertia_turned_z = p.added_turned_z = psi.z;
  expect_same(Inertia::force(board(), Sided{}, b), Inertia::force(p, Sided{}, other));
}

/// The same body with another origin, so that the centres of mass and of added mass are at r.
TEST(Solid, MovesTheSameWhereverItsOriginIs) {
  const V r{0.5, -0.2, 0.3};
  const Body<double> b = moving();
  Body<double> other = b;
  const V to = b.to_world(r);
  other.v = b.v - cross(b.omega, to);
  other.a = b.a - cross(b.alpha, to) - cross(b.omega, cross(b.omega, to));
  Solid p = board();
  p.centre_x = p.added_at_x = r.x, p.centre_y = p.added_at_y = r.y, p.centre_z = p.added_at_z = r.z;
  Wrench<double> expected = Inertia::force(board(), Sided{}, b);
  expected.moment += cross(to, expected.force);
  expect_same(expected, Inertia::force(p, Sided{}, other));
}

/// On the mirror image of a body in the xz plane, forces are mirrored, and moments about x and z are
/// reversed.
TEST(Solid, IsMirroredToTheOtherSide) {
  Solid p = board();
  p.inertia_turned_x = 0.3, p.inertia_turned_z = -0.5, p.added_turned_y = 0.2, p.added_turned_x = 0.6;
  p.added_at_y = 0.4, p.centre_y = -0.1;
  const Body<double> b = moving();
  Body<double> other = b;
  const auto reflected = [](const V& w) { return V{w.x, -w.y, w.z}; };
  const auto axial = [](const V& w) { return V{-w.x, w.y, -w.z}; };
  for (int i = 0; i < 3; ++i) {
    const V& axis = b.axes[static_cast<std::size_t>(i)];
    other.axes[static_cast<std::size_t>(i)] = (i == 1 ? -1.0 : 1.0) * reflected(axis);
  }
  other.v = reflected(b.v), other.a = reflected(b.a), other.omega = axial(b.omega),
  other.alpha = axial(b.alpha);
  const Wrench<double> one = Inertia::force(p, Sided{1}, b);
  expect_same({reflected(one.force), axial(one.moment)}, Inertia::force(p, Sided{-1}, other));
}

}  // namespace
