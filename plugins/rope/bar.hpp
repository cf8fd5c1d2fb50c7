// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/axial.hpp"

#include <numbers>

namespace netloft::rope {

/// Straight two-node bar of a rope; the spring of the paper's section 2.3 with a slack branch.
///   w = x₁ − x₀; tension and tangent by axial (1)–(5)
///   r₀ = −T t,  r₁ = +T t          residual ∂E/∂x                    (1)
///   W = (π/4) D² l₀ (ρ − ρ_w) g    weight in water, half per node    (2)
///   E = T_c l                      at constant tension, no spring    (3)
///   F = l₀ f(W, t)                 drag, half per node               (4)
///     W = ½ (c₀ + c₁) − ½ (v₀ + v₁), c the current at the nodes; f [N/m] the law of the part
///   T_d = (η/l₀) dl/dt             damping along the bar             (5)
///   r_p = ½ V [(ρ + C_a ρ_w) a_p − C_a ρ_w (t·a_p) t]   inertia      (6)
///     V = (π/4) D² l₀; added mass only across the rope, of the chord t; masses lumped at the nodes
/// D [m] diameter, ρ [kg/m³] density of the rope, ρ_w of the water, g [m/s²], T_c [N] tension that a winch or
/// a weight over a pulley holds whatever the length, η [N s] damping (EA times a relaxation time), C_a [1]
/// added mass over displaced mass. The water's own acceleration is left out: currents are steady. Source: the
/// trawl-gear paper, section 2.3 and eq. (2); Morison et al. 1950.
struct Bar {
  static constexpr auto stencil = NETLOFT_BAR;

  struct Parameters {
    double EA = 0, EA_compression = 0, diameter = 0, density = 0;
    double constant_tension = 0, damping = 0, added_mass = 0;
  };
  struct Data {
    double rest_length = 0;  // l₀ [m]
  };
  struct Lanes {
    double l0[kLanes], EA[kLanes], EA_compression[kLanes];
    double volume[kLanes], density[kLanes], diameter[kLanes];
    double constant_tension[kLanes], damping[kLanes], added_mass[kLanes];
  };

  static void check(const Parameters&, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);
  static axial::Bar stretch(const Parameters& p, const Data& d, const State<2>& s);

  struct Elastic {
    static Status tile(const Family<Bar>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      if (p.constant_tension > 0) return T(0);
      return axial::energy(x[1] - x[0], d.rest_length, {p.EA, p.EA_compression});
    }
  };

  /// (3); its elastic term is zero.
  struct Tension {
    static Status tile(const Family<Bar>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data&, const Water&, const Points<T, 2>& x) {
      return p.constant_tension * norm(x[1] - x[0]);
    }
  };

  struct Weight {
    static Status tile(const Family<Bar>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water& w, const Points<T, 2>& x) {
      const double volume = std::numbers::pi / 4 * p.diameter * p.diameter * d.rest_length;
      return 0.5 * volume * (p.density - w.density) * w.gravity * (x[0].z + x[1].z);
    }
  };

  struct Drag {  // (4)
    static Status tile(const Family<Bar>& family, netloft_tile& t);
  };
  struct Damping {  // (5)
    static Status tile(const Family<Bar>& family, netloft_tile& t);
  };
  struct Inertia {  // (6)
    static Status tile(const Family<Bar>& family, netloft_tile& t);
  };

  /// Drag of each bar [N], and the angle between bar and flow, 0 to π/2 [rad]; zero in still water.
  static void drag_of(const Family<Bar>& family, const netloft_tile& t, double* values);
  static void angle_of(const Family<Bar>& family, const netloft_tile& t, double* values);
};

}  // namespace netloft::rope
