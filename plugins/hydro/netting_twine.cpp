// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/netting_twine.hpp"

namespace netloft::hydro {

namespace {

constexpr double kStillSpeed = 1e-150;  // [m/s], below which its square is zero

/// A factor of (2) and its slope in the logarithm of its Reynolds number.
struct Factor {
  double value, slope;
};

struct Factors {
  Factor across, along, knots;  // k, g; a, h; m, n
};

/// (1) in one lane.
struct Motion {
  Motion(double shielding, const netloft_flow& f, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<std::size_t>(axis) * kLanes + i;
      U[axis] = shielding * f.flow[row], t[axis] = f.direction[row];
    }
    tau = dot(U, t), U_n = U - tau * t;
    s = norm(U_n), u = norm(U);
    e = std::sqrt(s * s + NettingTwine::kAlong * NettingTwine::kAlong * tau * tau);
  }
  Vec3<double> U, t, U_n;
  double tau, s, u, e;
};

Factor cylinder(const NettingTwine::Parameters& p, double half, double Re) {
  const auto phi = cylinder_phi(p.cylinder, Dual<1, 1>::variable(Re, 0));
  return {half * phi.value, half * Re * phi.gradient[0]};  // (3)
}

Factor friction(double density, double viscosity, double along) {
  const double square = along * along + 1, Re = std::sqrt(square), log_slope = along * along / square;
  const double scale = std::numbers::pi * density * viscosity;
  const double root = 0.55 * std::sqrt(Re), third = 0.084 * std::pow(Re, 2.0 / 3);
  return {scale * (root + third), scale * log_slope * (root / 2 + 2 * third / 3)};  // (4)
}

Factor knots(double scale, double Re) {
  const auto psi = sphere_phi(Dual<1, 1>::variable(Re, 0));
  return {scale * psi.value, scale * Re * psi.gradient[0]};  // (5)
}

Factors factors(const NettingTwine::Parameters& p, const netloft_flow& f, std::size_t i, const Motion& m) {
  const double per_speed = f.diameter[i] / f.water_viscosity,
               half = 0.5 * f.water_density * f.water_viscosity;
  return {cylinder(p, half, m.s * per_speed), friction(f.water_density, f.water_viscosity, m.e * per_speed),
          knots(half * p.knots / p.knot_diameter, m.u * per_speed * p.knot_diameter)};
}

void write_force(const netloft_flow& f, std::size_t i, const Motion& m, const Factors& c) {
  const Vec3<double> F = c.across.value * m.U_n + (c.along.value * m.tau) * m.t + c.knots.value * m.U;  // (2)
  for (int axis = 0; axis < 3; ++axis) f.force[static_cast<std::size_t>(axis) * kLanes + i] = F[axis];
}

void write_derivatives(double shielding, const netloft_flow& f, std::size_t i, const Motion& m,
                       const Factors& c) {
  const double squared = NettingTwine::kAlong * NettingTwine::kAlong;
  const Vec3<double> n = (1 / std::max(m.s, kStillSpeed)) * m.U_n, e = (1 / std::max(m.u, kStillSpeed)) * m.U;
  const double turn = m.e > kStillSpeed ? c.along.slope * (m.tau / m.e) / m.e : 0;
  const Vec3<double> by_flow = m.U_n + (squared * m.tau) * m.t, by_turn = m.U_n - squared * m.U;
  for (int p = 0; p < 3; ++p)
    for (int q = 0; q < 3; ++q) {
      const double one = p == q ? 1 : 0, tt = m.t[p] * m.t[q];
      const auto entry = static_cast<std::size_t>(3 * p + q) * kLanes + i;
      f.d_flow[entry] = shielding * (c.across.value * (one - tt) + c.across.slope * n[p] * n[q] +
                                     c.along.value * tt + turn * m.t[p] * by_flow[q] + c.knots.value * one +
                                     c.knots.slope * e[p] * e[q]);  // (6), (8)
      f.d_direction[entry] = -m.tau * (c.across.value * one + c.across.slope * n[p] * n[q]) +
                             (c.along.value - c.across.value) * m.t[p] * m.U[q] +
                             c.along.value * m.tau * one - turn * m.tau * m.t[p] * by_turn[q];  // (7)
    }
  for (std::size_t axis = 0; axis < 3; ++axis) f.d_solidity[axis * kLanes + i] = 0;
}

}  // namespace

void NettingTwine::lanes(const Parameters& p, const netloft_flow& f) {
  if (!(f.water_viscosity > 0))
    throw std::runtime_error("a Reynolds number needs a viscosity of the water above zero");
  for (std::size_t i = 0; i < f.count; ++i) {
    const Motion motion(p.shielding, f, i);
    const Factors c = factors(p, f, i, motion);
    write_force(f, i, motion, c);
    if (f.d_flow) write_derivatives(p.shielding, f, i, motion, c);
  }
}

}  // namespace netloft::hydro
