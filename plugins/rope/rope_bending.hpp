// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/rope/turn.hpp"

#include <array>

namespace netloft::rope {

/// Resistance of a rope to bending, between two neighbouring bars of unstretched lengths L₁, L₂ with the
/// turning angle φ between their directions (turn.hpp), c = cos φ:
///   E = −κ ln((1 + c)/2),  κ = 4 EI/(L₁ + L₂)                                              (1)
///   dE/dφ = EI/R,  R = (L₁ + L₂)/(4 tan(φ/2))                                              (2)
/// R is the radius of the circle that touches both bars at their middles if they are equally long. The
/// alternative is the circle through the three nodes, with the chord √Q:
///   E = (2 EI/(L₁L₂)) (L₁ + L₂ − √Q) = 8 EI h/(L₁ + L₂ + √Q),  h = (1 − c)/2               (3)
///   Q = L₁² + L₂² + 2 L₁L₂ c,  dE/dφ = 2 EI sin φ/√Q = EI/R                                (4)
/// EI [N m²] is the bending stiffness. For small φ, both moments dE/dφ are EI φ/L with L = (L₁ + L₂)/2; for
/// large φ, (4) is weaker, by cos(φ/2) for equal bars. As functions of c, neither energy is singular in a
/// straight rope. A rope folded back on itself (φ → π) and a bar of zero length have no curvature; they are
/// outside the domain. Bars of different ropes at a joint do not bend each other. Source: (1) the trawl-gear
/// paper, eq. (1); (4) the moment of FEMNET (D. Priour), but with unstretched lengths, so that the moment is
/// the derivative of an energy.
struct Bending {
  static constexpr auto stencil = NETLOFT_BAR_PAIR;
  enum Curvature : std::int64_t { of_bars, of_nodes };

  struct Parameters {
    double EI = 0;
    std::int64_t curvature = of_bars;
  };
  struct Data {
    std::array<double, 2> rest_length{};  // unstretched lengths L₁, L₂ [m]
  };

  static double kappa(const Parameters& p, const Data& d) {
    return 4 * p.EI / (d.rest_length[0] + d.rest_length[1]);
  }
  /// The turning angle φ between the two bars [rad].
  static double turning_angle(const State<3>& s);

  struct Elastic {
    static Status evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 3>& x) {
      const Vec3<T> w1 = x[1] - x[0], w2 = x[2] - x[1];
      const T c = dot(w1, w2) / (norm(w1) * norm(w2));
      if (p.curvature == of_bars) return -kappa(p, d) * log(0.5 * (1.0 + c));
      const double a = d.rest_length[0], b = d.rest_length[1];
      return (2 * p.EI / (a * b)) * (a + b - sqrt(a * a + b * b + (2 * a * b) * c));
    }
  };
};

}  // namespace netloft::rope
