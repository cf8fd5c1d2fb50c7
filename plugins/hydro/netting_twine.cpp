// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/netting_twine.hpp"

namespace netloft::hydro {

namespace {

constexpr double kStillSpeed = 1e-150;  // speed below which the square of the speed is zero [m/s]

struct Factors {
  LaneNumber across, along, knots;  // k, a, m as values, and g, h, n as slopes
};

/// The velocities (1) of netting_twine.hpp for one flow.
struct Motion {
  Motion(double shielding, const netloft_law_tile& f, std::size_t i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<std::size_t>(axis) * kLanes + i;
      U[axis] = shielding * f.flow[row];
      t[axis] = f.direction[row];
    }
    tau = dot(U, t);
    U_n = U - tau * t;
    s = norm(U_n);
    u = norm(U);
    e = std::sqrt(s * s + NettingTwine::kAlong * NettingTwine::kAlong * tau * tau);
  }
  Vec3<double> U, t, U_n;
  double tau, s, u, e;
};

template <class Phi>
Factors factors(const NettingTwine::Parameters& p, const netloft_law_tile& f, const Phi& phi, std::size_t i,
                const Motion& m) {
  const auto Re = [per_speed = f.diameter[i] / f.water_viscosity](double speed) {
    return LaneNumber::variable(speed * per_speed);
  };
  const double half = 0.5 * f.water_density * f.water_viscosity;
  return {half * phi(Re(m.s)), NettingTwine::friction(f.water_density, f.water_viscosity, Re(m.e)),
          half * p.knots / p.knot_diameter * sphere_phi(Re(m.u * p.knot_diameter))};  // (3), (4), (5)
}

void write_force(const netloft_law_tile& f, std::size_t i, const Motion& m, const Factors& c) {
  const Vec3<double> F = c.across.value * m.U_n + (c.along.value * m.tau) * m.t + c.knots.value * m.U;  // (2)
  for (int axis = 0; axis < 3; ++axis) f.force[static_cast<std::size_t>(axis) * kLanes + i] = F[axis];
}

/// Writes the derivatives (6) to (8) of netting_twine.hpp. Products t yᵀ with the same t are first summed as
/// one vector y.
void write_derivatives(double shielding, const netloft_law_tile& f, std::size_t i, const Motion& m,
                       const Factors& c) {
  const double squared = NettingTwine::kAlong * NettingTwine::kAlong, k = c.across.value, a = c.along.value;
  const Vec3<double> n = (1 / std::max(m.s, kStillSpeed)) * m.U_n, e = (1 / std::max(m.u, kStillSpeed)) * m.U;
  const double turn = m.e > kStillSpeed ? c.along.slope * (m.tau / m.e) / m.e : 0;
  const Vec3<double> by_flow = shielding * ((a - k) * m.t + turn * (m.U_n + (squared * m.tau) * m.t)),
                     by_turn = (a - k) * m.U - (turn * m.tau) * (m.U_n - squared * m.U),
                     gn = (shielding * c.across.slope) * n, me = (shielding * c.knots.slope) * e,
                     gn_turned = (m.tau * c.across.slope) * n;
  const double of_flow = shielding * (k + c.knots.value), of_turn = (a - k) * m.tau;
#pragma GCC unroll 3
  for (int p = 0; p < 3; ++p)
    for (int q = 0; q < 3; ++q) {
      const auto entry = static_cast<std::size_t>(3 * p + q) * kLanes + i;
      f.d_flow[entry] = m.t[p] * by_flow[q] + gn[p] * n[q] + me[p] * e[q] + (p == q ? of_flow : 0);
      f.d_direction[entry] = m.t[p] * by_turn[q] - gn_turned[p] * n[q] + (p == q ? of_turn : 0);
    }
  for (std::size_t axis = 0; axis < 3; ++axis) f.d_solidity[axis * kLanes + i] = 0;
}

/// The arrays do not overlap, so that the loop is vectorised.
template <bool derivatives, class Phi>
[[gnu::flatten]] void all_lanes(const NettingTwine::Parameters& parameters, const netloft_law_tile& flow,
                                const Phi& phi) {
  const NettingTwine::Parameters p = parameters;
  const netloft_law_tile f = flow;
#pragma GCC ivdep
  for (std::size_t i = 0; i < f.count; ++i) {
    const Motion motion(p.shielding, f, i);
    const Factors c = factors(p, f, phi, i, motion);
    write_force(f, i, motion, c);
    if constexpr (derivatives) write_derivatives(p.shielding, f, i, motion, c);
  }
}

}  // namespace

void NettingTwine::lanes(const Parameters& p, const netloft_law_tile& f) {
  if (!(f.water_viscosity > 0))
    throw std::runtime_error(
        "netting-twine needs a viscosity of the water above zero, for its Reynolds numbers");
  with_cylinder_phi(p.cylinder, [&](const auto& phi) {
    f.d_flow ? all_lanes<true>(p, f, phi) : all_lanes<false>(p, f, phi);
  });
}

}  // namespace netloft::hydro
