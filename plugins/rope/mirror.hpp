// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <cmath>

namespace netloft::rope {

/// Bending of a rope at a plane of symmetry: half of the bending energy between a bar and its mirror image.
/// The other half belongs to the side that is not modelled.
///   w = x₁ − x₀,  x₀ on the plane,  q = ± w·e/‖w‖ = cos(φ/2),  φ the turning angle at x₀       (1)
///   E = −(2 EI/L) ln q              half of (1) of rope_bending.hpp with L₁ = L₂ = L            (2)
///   E = (2 EI/L) (1 − q)            half of (3) there, the circle through three nodes           (3)
/// e is the axis normal to the plane, the sign + for a rope on its positive side, EI [N m²] the bending
/// stiffness, L [m] the unstretched bar. A bar in the plane is folded onto its image, and a bar beyond the
/// plane has passed through its image: both are outside the domain.
struct Mirror {
  static constexpr auto stencil = NETLOFT_BAR;
  static constexpr double kFolded = 1e-9;  // value of q below which the bar is folded onto its image
  enum Curvature : std::int64_t { of_bars, of_nodes };

  struct Parameters {
    double EI = 0;
    std::int64_t axis = 0, curvature = of_bars, side = 0;  // side: 0 positive, 1 negative
  };
  struct Data {
    double rest_length = 0;  // unstretched length L [m]
  };
  static void check(const Parameters&, const Data& d) {
    if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no curvature");
  }

  struct Elastic {
    template <class T>
    static T energy(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      const Vec3<T> w = x[1] - x[0];
      const T q = (p.side == 0 ? 1.0 : -1.0) * w[static_cast<int>(p.axis)] / norm(w);
      if (!(q > T(kFolded)))
        throw OutsideDomain("a rope lies in its plane of symmetry, folded onto its image");
      const double k = 2 * p.EI / d.rest_length;
      return p.curvature == of_bars ? (-k) * log(q) : k * (1.0 - q);
    }
  };
};

}  // namespace netloft::rope
