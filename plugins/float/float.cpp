// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/float/float.hpp"

#include "plugins/common/sphere.hpp"

#include <netloft/dual.hpp>

#include <numbers>

namespace netloft::floats {

void Float::check(const Parameters& p, const Data& d) {
  if (p.drag_law == kSphere && p.diameter == 0)
    throw std::invalid_argument("float.drag_law = \"sphere\" needs float.diameter");
  if (!(d.pieces >= 0)) throw std::invalid_argument("the number of floats at a node must not be negative");
}

double Float::net_buoyancy(const Parameters& p, const Water& w) {
  return p.buoyancy != 0 ? p.buoyancy : (w.density * p.volume - p.mass) * w.gravity;
}

double Float::drag_factor(const Parameters& p, const Water& w) {
  const double area = p.area > 0 ? p.area : std::numbers::pi / 4 * p.diameter * p.diameter;
  return 0.5 * w.density * area;
}

namespace {

/// The drag coefficient C_d and its slope Re dC_d/dRe.
struct Coefficient {
  double value, slope;
};

Coefficient drag_coefficient(const Float::Parameters& p, const Water& w, double speed) {
  if (p.drag_law == Float::kConstant) return {p.drag_coefficient, 0};
  constexpr double kLeast =
      1e-3;  // Reynolds number below which drag is less than the round-off of other forces
  const double Re = std::max(kLeast, speed * p.diameter / w.viscosity);
  const auto at = sphere_drag(Dual<1, 1>::variable(Re, 0));
  return {at.value, Re * at.gradient[0]};
}

}  // namespace

Status Float::Buoyancy::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double up = d.pieces * net_buoyancy(p, s.water);
  out.energy = -up * s.x[0].z;
  out.force[0].z = -up;  // (2)
  return Status::ok;
}

Status Float::Drag::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const Vec3<double> W = s.current[0] - s.v[0];
  const double speed = norm(W), factor = d.pieces * drag_factor(p, s.water);
  const Coefficient C = drag_coefficient(p, s.water, speed);
  out.force[0] = -factor * C.value * speed * W;  // (3)
  if (!s.wants_tangent || speed == 0) return Status::ok;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double D =
          factor * (C.value * (r == c ? speed : 0) + (C.value + C.slope) * W[r] * W[c] / speed);  // (4)
      out.tangent[r][c] += s.cv * D;
      out.tangent[r][2] -= s.cu * D * s.current_dz[0][c];
    }
  return Status::ok;
}

Status Float::Inertia::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double mass = d.pieces * (p.mass + p.added_mass * s.water.density * p.volume);
  out.force[0] = mass * s.a[0];  // (5)
  for (int axis = 0; axis < 3; ++axis) out.tangent[axis][axis] = s.ca * mass;
  return Status::ok;
}

Status Float::Waves::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double mass = d.pieces * (1 + p.added_mass) * s.water.density * p.volume;
  out.force[0] = -mass * s.water_acceleration[0];  // (6)
  return Status::ok;
}

}  // namespace netloft::floats
