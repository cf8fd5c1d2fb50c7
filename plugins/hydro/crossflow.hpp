// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/law.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::hydro {

/// Force of the water on a metre of twine: the sum of the forces of the flow across and along the twine.
///   U = r W,  τ = U·t,  U_n = U − τ t,  s = ‖U_n‖,  û = U_n/s           (1)
///   F = k(s) U_n + κ |τ| τ t,  κ = ½ ρ D C_t                            (2)
///   ∂F/∂U = k (I − t tᵀ) + g û ûᵀ + 2 κ |τ| t tᵀ,  g = s dk/ds           (3)
///   ∂F/∂t = −τ (k I + g û ûᵀ) − k t Uᵀ + κ |τ| (2 t Uᵀ + τ I)           (4)
///   ∂F/∂W = r ∂F/∂U                                                     (5)
/// W [m/s] velocity of the water relative to the twine, r [1] factor on W behind other netting, t unit vector
/// along the twine, D [m] diameter, ρ [kg/m³] density of the water, C_t [1] coefficient of friction; each law
/// has its own k [kg/(m s)]. The force is regular everywhere: if there is no flow across the twine, û and g
/// are zero. Source: cross-flow principle, as in the trawl-gear paper, eqs. (2) and (4).
struct CrossFlow {
  double shielding;   // factor r on W
  double tangential;  // friction C_t
};

/// The resistance factor k and the slope g of (2), (3).
struct Resistance {
  double k, g;
};

inline constexpr double kStill = 1e-150;  // speed below which s² is zero [m/s]

/// (2) for dual numbers: the reference implementation for tests. `across(s)` returns k.
template <class T, class Across>
Vec3<T> cross_flow_force(const CrossFlow& c, const Flow<T>& f, Across&& across) {
  using std::abs;
  const Vec3<T> U = c.shielding * f.flow;
  const T tau = dot(U, f.direction);
  const Vec3<T> U_n = U - tau * f.direction;
  const double friction = 0.5 * f.density * f.diameter * c.tangential;
  return across(norm(U_n)) * U_n + (friction * abs(tau) * tau) * f.direction;
}

/// Computes (1)–(5) for flow i of a tile. `across(i, s)` returns the Resistance.
template <bool Derivatives, class Across>
inline void cross_flow_lane(const CrossFlow& c, const netloft_law_tile& f, std::size_t i, Across&& across) {
  const auto row = [i](const double* a, std::size_t r) { return a[r * kLanes + i]; };
  const double U[3] = {c.shielding * row(f.flow, 0), c.shielding * row(f.flow, 1),
                       c.shielding * row(f.flow, 2)};
  const double t[3] = {row(f.direction, 0), row(f.direction, 1), row(f.direction, 2)};
  const double tau = U[0] * t[0] + U[1] * t[1] + U[2] * t[2];
  const double n[3] = {U[0] - tau * t[0], U[1] - tau * t[1], U[2] - tau * t[2]};
  const double s = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  const Resistance a = across(i, s);
  const double along = 0.5 * f.water_density * f.diameter[i] * c.tangential * std::abs(tau);
  for (std::size_t p = 0; p < 3; ++p) f.force[p * kLanes + i] = a.k * n[p] + along * tau * t[p];  // (2)
  if constexpr (Derivatives) {
    const double inverse = 1 / std::max(s, kStill);
    const double u[3] = {n[0] * inverse, n[1] * inverse, n[2] * inverse};
    for (std::size_t p = 0; p < 3; ++p)
      for (std::size_t q = 0; q < 3; ++q) {
        const double one = p == q ? 1 : 0, across_pq = a.k * one + a.g * u[p] * u[q];
        f.d_flow[(3 * p + q) * kLanes + i] =
            c.shielding * (across_pq + (2 * along - a.k) * t[p] * t[q]);  // (3), (5)
        f.d_direction[(3 * p + q) * kLanes + i] =
            -tau * (across_pq - along * one) + (2 * along - a.k) * t[p] * U[q];  // (4)
      }
    for (std::size_t p = 0; p < 3; ++p) f.d_solidity[p * kLanes + i] = 0;
  }
}

/// Computes (1)–(5) for all flows of a tile. `__restrict` tells the compiler that arrays do not overlap, so
/// that it vectorises the loop.
template <bool Derivatives, class Across>
[[gnu::flatten]] void cross_flow_all_lanes(const CrossFlow& c, const netloft_law_tile& flow,
                                           Across&& across) {
  const CrossFlow flows = c;
  const netloft_law_tile f = flow;
#pragma GCC ivdep
  for (std::size_t i = 0; i < f.count; ++i) cross_flow_lane<Derivatives>(flows, f, i, across);
}

template <class Across>
void cross_flow_lanes(const CrossFlow& c, const netloft_law_tile& f, Across&& across) {
  if (f.d_flow)
    cross_flow_all_lanes<true>(c, f, across);
  else
    cross_flow_all_lanes<false>(c, f, across);
}

}  // namespace netloft::hydro
