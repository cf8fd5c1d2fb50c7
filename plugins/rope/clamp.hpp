// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/rope/turn.hpp"

#include <array>

namespace netloft::rope {

/// A clamp between two ropes that meet at a node. It maintains the angle between their bars at this node.
///   δ = φ − β           deviation of the turning angle φ (turn.hpp) from the angle β at rest     (1)
///   E = −2κ ln cos(δ/2),  κ = 4 EI/(L₁ + L₂)                                                     (2)
///   E = (2 EI/(L₁L₂)) (L₁ + L₂ − √Q),  Q = L₁² + L₂² + 2 L₁L₂ cos δ                              (3)
///   dE/dc = −E_φ/s,  d²E/dc² = E_φφ/s² − E_φ c/s³,  c = cos φ,  s = sin φ                         (4)
/// EI [N m²] is the bending stiffness, L₁ and L₂ [m] are the unstretched bars, subscripts φ are derivatives.
/// The parameter `curvature` chooses (2) or (3), which are (1) and (3) of rope_bending.hpp if β = 0. While
/// the bars are in line, the plane in which a clamp with β > 0 bends them is unknown, and the clamp exerts no
/// force. Bars folded back on each other are outside the domain.
struct Clamp {
  static constexpr auto stencil = NETLOFT_BAR_PAIR;
  enum Curvature : std::int64_t { of_bars, of_nodes };

  struct Parameters {
    double EI = 0, angle = 0;  // angle at rest β [rad]
    std::int64_t curvature = of_bars;
  };
  struct Data {
    std::array<double, 2> rest_length{};  // unstretched lengths L₁, L₂ [m]
  };

  struct Elastic {
    static Status evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 3>& x) {
      const Vec3<T> w1 = x[1] - x[0], w2 = x[2] - x[1];
      const T delta = acos(dot(w1, w2) / (norm(w1) * norm(w2))) - p.angle;
      const double a = d.rest_length[0], b = d.rest_length[1];
      if (p.curvature == of_bars) return (-8 * p.EI / (a + b)) * log(cos(0.5 * delta));
      return (2 * p.EI / (a * b)) * (a + b - sqrt(a * a + b * b + (2 * a * b) * cos(delta)));
    }
  };
};

}  // namespace netloft::rope
