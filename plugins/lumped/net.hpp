// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/bars_in_water.hpp"
#include "plugins/common/surface.hpp"

namespace netloft::lumped {

/// A bar of a lumped-mass net between two nodes, each of which stands for a group of knots of diamond
/// netting. The bar represents `parallel` twines side by side with the same stretch; its forces are (1)–(5)
/// of plugins/common/bars.hpp with N = `parallel`. If one bar is one twine (N = 1), the model is the real
/// net, knot by knot, except that knots do not resist opening. Knots have no drag of their own. Source: the
/// usual lumped-mass model with groups of meshes: Theret, Etude de l'équilibre de surfaces réticulées placées
/// dans un courant uniforme (thesis, Nantes 1993); Takagi et al., Fisheries Science 70 (2004).
struct Net {
  static constexpr auto stencil = NETLOFT_BAR;

  struct Parameters {
    double EA = 0, EA_compression = 0, diameter = 0, density = 0;
    double damping = 0, added_mass = 0, surface = 0, loss_factor = 0, loss_frequency = 10;
  };
  struct Data {
    double rest_length = 0;  // unstretched length l₀ [m]
    double parallel = 1;     // number N of parallel twines
  };
  using Lanes = bars::Lanes;

  static void check(const Parameters&, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);
  static axial::Bar stretch(const Parameters& p, const Data& d, const State<2>& s);
  static std::array<Member, 1> members(const Parameters& p, const Data& d, double) {
    return {bars::member(p, d.rest_length, d.parallel)};
  }

  struct Elastic {
    static Status tile(const Family<Net>& f, netloft_tile& t) { return bars::add_elastic(f.lanes(t), t); }
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      return d.parallel * axial::energy(x[1] - x[0], d.rest_length, {p.EA, p.EA_compression});
    }
  };

  struct Weight {
    static Status tile(const Family<Net>& f, netloft_tile& t) { return bars::add_weight(f.lanes(t), t); }
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water& w, const Points<T, 2>& x) {
      return bars::weight_energy(p, d.rest_length, d.parallel, w, x);
    }
  };

  struct Drag {
    static Status tile(const Family<Net>& f, netloft_tile& t) {
      return bars::add_drag(f.lanes(t), f.law(0), t);
    }
  };
  struct DryDrag {
    static Status tile(const Family<Net>& f, netloft_tile& t) {
      const Lanes& p = f.lanes(t);
      return surface::take_dry_drag<2>(p, t, [&](netloft_tile& in) { bars::add_drag(p, f.law(0), in); });
    }
  };
  struct DryBuoyancy {
    static Status tile(const Family<Net>& f, netloft_tile& t) {
      return surface::take_dry_buoyancy(f.lanes(t), t);
    }
  };
  struct Damping {
    static Status tile(const Family<Net>& f, netloft_tile& t) { return bars::add_damping(f.lanes(t), t); }
  };
  struct Loss {
    static Status tile(const Family<Net>& f, netloft_tile& t) {
      return bars::add_loss(f.lanes(t), nullptr, t);
    }
  };
  struct Inertia {
    static Status tile(const Family<Net>& f, netloft_tile& t) { return bars::add_inertia(f.lanes(t), t); }
  };

  struct Waves {
    static Status tile(const Family<Net>& f, netloft_tile& t) { return bars::add_waves(f.lanes(t), t); }
  };

  static void drag_of(const Family<Net>& f, const netloft_tile& t, double* values) {
    bars::drag_of(f.lanes(t), f.law(0), t, values);
  }
  static void mass_of(const Family<Net>& f, const netloft_tile& t, double* values) {
    bars::mass_of(f.lanes(t), t, values);
  }
};

}  // namespace netloft::lumped
