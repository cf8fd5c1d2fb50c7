// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/chords.hpp"
#include "plugins/common/loss.hpp"

#include <limits>
#include <numbers>

namespace netloft::bars {

/// Straight two-node bars of rope or twine, 64 at a time. Each represents N equal bars side by side.
///   w = x₁ − x₀, tension T, direction t and tangent by axial.hpp (1)–(5)
///   r₀ = −N T t,  r₁ = +N T t      residual ∂E/∂x                    (1)
///   G = V (ρ − ρ_w) g              weight in water, half per node    (2)
///     V = N (π/4) D² l₀
///   F = N l₀ f(W, t)               drag, half per node               (3)
///     W = ½ (c₀ + c₁) − ½ (v₀ + v₁), c the current, v the velocity; f [N/m] the law of drag of the part
///   T_d = N (η/l₀) dl/dt           damping along the bar             (4)
///   r_p = ½ V [(ρ + C_a ρ_w) a_p − C_a ρ_w (t·a_p) t]   inertia      (5)
///     a_p acceleration of node p; added mass acts only across the bar; masses are lumped at the nodes
/// l₀ [m] unstretched length, D [m] diameter, ρ [kg/m³] density of the material, ρ_w of the water, g [m/s²],
/// η [N s] damping (EA times a relaxation time), C_a [1] added mass over displaced mass. N ≥ 0 (1 for a rope)
/// need not be an integer. (5) is the force in water that is not accelerated; `add_waves` adds the force that
/// the acceleration of the water exerts. Source: the trawl-gear paper, section 2.3 and eq. (2); Morison et
/// al. 1950.
struct Lanes {
  double l0[kLanes];                          // [m]
  double EA[kLanes], EA_compression[kLanes];  // N EA and N EA_c of N twines [N]
  double twine[kLanes];                       // N l₀, total length in the water [m]
  double volume[kLanes], density[kLanes], diameter[kLanes];
  double damping[kLanes], added_mass[kLanes];  // N η, and the coefficient C_a
  double loss[kLanes];                         // N times loss_of() of loss.hpp
  double surface[kLanes];                      // factor σ of surface.hpp
};

/// Fills in the numbers of one element (a lane). `parallel` is the number N of bars side by side. `P` holds
/// the properties of one bar.
template <class P>
void pack(const P& p, double rest_length, double parallel, Lanes& lanes, std::size_t lane) {
  lanes.l0[lane] = rest_length;
  lanes.EA[lane] = parallel * p.EA;
  lanes.EA_compression[lane] = parallel * p.EA_compression;
  lanes.twine[lane] = parallel * rest_length;
  lanes.volume[lane] = std::numbers::pi / 4 * p.diameter * p.diameter * lanes.twine[lane];
  lanes.density[lane] = p.density;
  lanes.diameter[lane] = p.diameter;
  lanes.damping[lane] = parallel * p.damping;
  lanes.loss[lane] = parallel * axial::loss_of(p.EA, p.loss_factor, p.loss_frequency);
  lanes.added_mass[lane] = p.added_mass;
  lanes.surface[lane] = p.surface;
}

/// The `parallel` bars of an element as one Member, for solvers with unknown tensions. `P` has EA and
/// EA_compression of one bar.
template <class P>
Member member(const P& p, double rest_length, double parallel) {
  return {{-1, 1, 0}, rest_length, p.EA, p.EA_compression, parallel};
}

/// Mass in air of the bars that each element represents [kg].
inline void mass_of(const Lanes& p, const netloft_tile& t, double* values) {
  for (std::size_t i = 0; i < t.count; ++i) values[i] = p.density[i] * p.volume[i];
}

/// Adds [ A −A; −A A ] to the tangent of a bar, which is a packed lower triangle. `A` is the symmetric
/// stiffness of each bar, six numbers.
inline void add_blocks(const double (&A)[6][kLanes], std::uint32_t count, double* __restrict tangent) {
  int entry = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c <= r; ++c, ++entry) {
      const double* a = A[axial::kPlace[r % 3][c % 3]];
      const double sign = r / 3 == c / 3 ? 1 : -1;
      for (std::size_t i = 0; i < count; ++i) tangent[at(entry, i)] += sign * a[i];
    }
}

/// Adds the metric: M of axial.hpp (6), a constant upper bound of the stiffness.
inline void add_metric(const Lanes& p, netloft_tile& t) {
  double A[6][kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    A[0][i] = A[2][i] = A[5][i] = std::max(p.EA[i], p.EA_compression[i]) / p.l0[i];
    A[1][i] = A[3][i] = A[4][i] = 0;
  }
  add_blocks(A, t.count, t.tangent);
}

inline Status add_elastic(const Lanes& p, netloft_tile& t) {
  if (t.want & NETLOFT_WANT_METRIC) {
    add_metric(p, t);
    return Status::ok;
  }
  // Every loop over the elements (lanes) contains only one operation, so that compilers vectorise it.
  double w[3][kLanes], inverse[kLanes], T[kLanes], k[kLanes], energy[kLanes];
  find_spans(t, w);
  const double(&wx)[kLanes] = w[0], (&wy)[kLanes] = w[1], (&wz)[kLanes] = w[2];
  for (std::size_t i = 0; i < t.count; ++i) {
    const auto b = axial::stretch(wx[i], wy[i], wz[i], p.l0[i], p.EA[i], p.EA_compression[i]);
    inverse[i] = b.inverse;
    T[i] = b.T;
    k[i] = b.k;
    energy[i] = b.energy;
  }
  if (t.energy)
    for (std::size_t i = 0; i < t.count; ++i) t.energy[i] += energy[i];
  if (double* __restrict force = t.force)
    for (std::size_t i = 0; i < t.count; ++i) {
      const double f = T[i] * inverse[i];  // (1)
      force[at(0, i)] -= f * wx[i], force[at(1, i)] -= f * wy[i], force[at(2, i)] -= f * wz[i];
      force[at(3, i)] += f * wx[i], force[at(4, i)] += f * wy[i], force[at(5, i)] += f * wz[i];
    }
  if (t.tangent) {
    double A[6][kLanes];
    const double lowest = t.want & NETLOFT_WANT_CONVEX ? 0.0 : -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < t.count; ++i) {
      const auto a = axial::stiffness({0, inverse[i], T[i], k[i], 0}, wx[i], wy[i], wz[i], t.cu, lowest);
      for (int m = 0; m < 6; ++m) A[m][i] = a.v[m];
    }
    add_blocks(A, t.count, t.tangent);
  }
  return Status::ok;
}

inline Status add_weight(const Lanes& p, netloft_tile& t) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const double half = 0.5 * p.volume[i] * (p.density[i] - t.water_density) * t.gravity;  // (2)
    if (t.energy) t.energy[i] += half * (t.x[2 * kLanes + i] + t.x[5 * kLanes + i]);
    if (t.force) {
      t.force[2 * kLanes + i] += half;
      t.force[5 * kLanes + i] += half;
    }
  }
  return Status::ok;
}

/// Energy of the weight (2) for any number type; tests compare its derivatives with add_weight.
template <class T, class P>
T weight_energy(const P& p, double rest_length, double parallel, const Water& w, const Points<T, 2>& x) {
  const double volume = parallel * std::numbers::pi / 4 * p.diameter * p.diameter * rest_length;
  return 0.5 * volume * (p.density - w.density) * w.gravity * (x[0].z + x[1].z);
}

}  // namespace netloft::bars
