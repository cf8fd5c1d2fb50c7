// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/axial.hpp"

#include <numbers>

namespace netloft::rope {

/// Straight two-node bar of a rope; the spring of the paper's section 2.3 with a slack branch.
///   w = x₁ − x₀; tension and tangent by axial (1)–(5)
///   r₀ = −T t,  r₁ = +T t          residual ∂E/∂x                    (1)
///   W = (π/4) D² l₀ (ρ − ρ_w) g    weight in water, half per node    (2)
/// D [m] diameter, ρ [kg/m³] density of the rope, ρ_w of the water, g [m/s²].
struct Bar {
  static constexpr auto stencil = NETLOFT_BAR;

  struct Parameters {
    double EA = 0, EA_compression = 0, diameter = 0, density = 0;
  };
  struct Data {
    double rest_length = 0;  // l₀ [m]
  };
  struct Lanes {
    double l0[kLanes], EA[kLanes], EA_compression[kLanes];
    double volume[kLanes], density[kLanes];
  };

  static void check(const Parameters&, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);
  static axial::Bar stretch(const Parameters& p, const Data& d, const State<2>& s);

  struct Elastic {
    static Status tile(const Family<Bar>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      return axial::energy(x[1] - x[0], d.rest_length, {p.EA, p.EA_compression});
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
};

}  // namespace netloft::rope
