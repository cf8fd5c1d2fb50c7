// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/bars_in_water.hpp"
#include "plugins/common/surface.hpp"

namespace netloft::rope {

/// Straight two-node bar of a rope: the spring of section 2.3 of the trawl-gear paper, with a small stiffness
/// when slack. Its forces are (1)–(5) of plugins/common/bars.hpp with N = 1, and in addition
///   E = T_c l                      at constant tension, no spring    (1)
///   l₀(t) = σ(t) l₀                rope is paid out or hauled in     (2)
/// T_c [N] is the tension that a winch or a weight over a pulley holds at any length l. σ [1] comes from a
/// table, linear between its times, and is the same for all bars of a rope. Length, weight, drag and mass are
/// proportional to σ; only sag.hpp uses the constant l₀. If the weight in water w [N/m] is given, the weight
/// is computed with the density
///   ρ = ρ_w + w/(g A),  A = (π/4) D²                                (3)
/// (ρ_w density of the water, D diameter), and the density of the rope is used for inertia only.
struct Bar {
  static constexpr auto stencil = NETLOFT_BAR;

  struct Parameters {
    double EA = 0, EA_compression = 0, diameter = 0, density = 0;
    double weight_in_water = 0;  // weight w of (3)
    double constant_tension = 0, damping = 0, loss_factor = 0, loss_frequency = 10;
    double added_mass = 0, sag = 0, surface = 0;
    netloft_table length_share{};  // columns: time t [s], factor σ
  };
  struct Data {
    double rest_length = 0;  // unstretched length l₀ [m]
  };
  struct Lanes : bars::Lanes {
    double constant_tension[kLanes], weight_in_water[kLanes];
    netloft_table length_share[kLanes];
    // changes: the length of some rope depends on time. is_weighed: some rope has a given weight in water.
    bool changes, is_weighed;
  };

  /// The factor σ of (2) on the length of the rope.
  static double factor_at(const netloft_table& table, double time);
  /// The relative rate at which the rope becomes longer, (dσ/dt)/σ [1/s]. At the time of a row of the table,
  /// it is the rate before that row.
  static double growth_at(const netloft_table& table, double time);
  /// Returns the data of the bars at the time of the tile: `lanes` itself if no rope changes its length,
  /// otherwise `room`, filled with the lengths (2).
  static const Lanes& now(const Lanes& lanes, const netloft_tile& t, Lanes& room);
  /// The density that gives the weight of a rope [kg/m3]: (3), or `density` if no weight in water is given.
  static double density_by_weight(double weight_in_water, double density, double diameter,
                                  double water_density, double gravity);

  static void check(const Parameters& p, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);
  static axial::Bar stretch(const Parameters& p, const Data& d, const State<2>& s);
  /// The bar for solvers in which tensions are unknowns. At constant tension, its stiffness is zero.
  static std::array<Member, 1> members(const Parameters& p, const Data& d, double time);

  struct Elastic {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_elastic(now(f.lanes(t), t, room), t);
    }
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      if (p.constant_tension > 0) return T(0);
      return axial::energy(x[1] - x[0], d.rest_length, {p.EA, p.EA_compression});
    }
  };

  /// The constant tension (1). A bar with a constant tension has no elastic force.
  struct Tension {
    static Status tile(const Family<Bar>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data&, const Water&, const Points<T, 2>& x) {
      return p.constant_tension * norm(x[1] - x[0]);
    }
  };

  struct Weight {
    /// Returns the data of the bars with the densities (3): `at_time` itself if no rope has a given weight in
    /// water, otherwise `room`.
    static const Lanes& weighed(const Lanes& at_time, const netloft_tile& t, Lanes& room);
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_weight(weighed(now(f.lanes(t), t, room), t, room), t);
    }
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water& w, const Points<T, 2>& x) {
      Parameters weighed = p;
      weighed.density = density_by_weight(p.weight_in_water, p.density, p.diameter, w.density, w.gravity);
      return bars::weight_energy(weighed, d.rest_length, 1, w, x);
    }
  };

  struct Drag {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_drag(now(f.lanes(t), t, room), f.law(0), t);
    }
  };
  struct DryDrag {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      const Lanes& p = now(f.lanes(t), t, room);
      return surface::take_dry_drag<2>(p, t, [&](netloft_tile& in) { bars::add_drag(p, f.law(0), in); });
    }
  };
  struct DryBuoyancy {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return surface::take_dry_buoyancy(now(f.lanes(t), t, room), t);
    }
  };
  struct Damping {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_damping(now(f.lanes(t), t, room), t);
    }
  };
  struct Loss {
    static Status tile(const Family<Bar>& f, netloft_tile& t);
  };
  struct Inertia {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_inertia(now(f.lanes(t), t, room), t);
    }
  };

  struct Waves {
    static Status tile(const Family<Bar>& f, netloft_tile& t) {
      Lanes room;
      return bars::add_waves(now(f.lanes(t), t, room), t);
    }
  };

  static void drag_of(const Family<Bar>& f, const netloft_tile& t, double* values) {
    Lanes room;
    bars::drag_of(now(f.lanes(t), t, room), f.law(0), t, values);
  }
  static void mass_of(const Family<Bar>& f, const netloft_tile& t, double* values) {
    Lanes room;
    bars::mass_of(now(f.lanes(t), t, room), t, values);
  }
  static void angle_of(const Family<Bar>& f, const netloft_tile& t, double* values) {
    bars::angle_of(f.lanes(t), t, values);
  }
};

}  // namespace netloft::rope
