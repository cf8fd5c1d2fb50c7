// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <limits>

namespace netloft::seabed {

/// A plane seabed under a node to which L metres of rope or twine belong. Contact pushes the node out of the
/// bed, friction resists its motion along the bed.
///   n = (−s_x, −s_y, 1)/√(1 + s_x² + s_y²),  h = n·x + n_z D      height over the bed           (1)
///   δ = −h,  f(δ) = 0 | δ³/6ε | (δ − ε/2)²/2 + ε²/24  for  δ ≤ 0 | 0 < δ < ε | δ ≥ ε            (2)
///   E = k L f,  N = k L f',  r = −N n,  K = k L f'' n nᵀ          contact; f'' is continuous     (3)
///   d = (I − n nᵀ)(x − a)                                        displacement from the anchor a      (4)
///   r = κ L d                   while κ L |d| ≤ μ N              a spring holds the node         (5)
///   r = μ N d̂                   beyond that force                the node slides (Coulomb)       (6)
///   a ← x where N = 0,  a where the node sticks,  x − (μ N/κ L) d̂ where it slides                (7)
/// A bed that moves with the velocity g under a towed gear drags every node and leaves no anchor:
///   w = (I − n nᵀ)(v − g)                                        velocity over the bed           (8)
///   r = μ N w h(|w|),  h(s) = 1/s | (2 − s/c)/c  for  s ≥ c | s < c,  c = |g|/100                (9)
/// E is the energy, N the normal force, r the residual, K the tangent. D [m] is the depth of the bed below z
/// = 0 at x = y = 0, s_x, s_y [1] its slopes dz/dx, dz/dy; k, κ [N/m²] are its stiffness per metre of rope
/// against compression and shear; ε [m] is the depth over which the bed reaches k; μ [1] is the friction. In
/// an equilibrium v = 0, so that friction is μ N along the motion of the bed. A node that is slower than c
/// over the bed creeps instead of sticking. The element remembers the anchor a. The host replaces it by (7)
/// only after an accepted step, so that the anchor is fixed in the search for an equilibrium; the replacement
/// does not change the force. An element without a past (memory all zero) has no friction. A node without
/// rope counts as one metre per piece. Source: penalty contact and radial return, as in Wriggers,
/// Computational Contact Mechanics, Springer 2006, chapters 5 and 10; the depth of a wire of weight w per
/// metre is ε/2 + w/k if that is more than ε, else √(2 ε w/k).
struct Plane {
  static constexpr auto stencil = NETLOFT_NODE;
  static constexpr std::uint32_t kRemembers = 4;  // numbers to remember: a, and whether there was a past step

  struct Parameters {
    double depth = 0, slope_x = 0, slope_y = 0, stiffness = 0, softness = 0;
    double friction = 0, shear_stiffness = 0;
  };
  struct Data {
    double length = 0;  // length of rope or twine at the node [m]
    double pieces = 0;  // number of pieces, each of which counts as one metre if length is zero
  };
  struct Lanes {
    double n[3][kLanes], offset[kLanes];     // height h = n·x + offset of (1)
    double K[kLanes], softness[kLanes];      // stiffness k L, depth ε
    double friction[kLanes], shear[kLanes];  // friction μ, shear stiffness κ L
  };

  /// The function f of (2) and its derivatives f', f''.
  struct Depth {
    double f, f1, f2;
  };
  static Depth press(double depth, double softness);

  /// The function h of (9), and h'/s.
  struct Slip {
    double h, slope;
  };
  static Slip slip(double speed, double creep);
  /// The ratio c/|g| of (9): friction reaches its limit at this fraction of the velocity of the ground.
  static constexpr double kCreep = 0.01;
  /// Relative rounding error of positions after the few sums of (1) to (4).
  static constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  /// The height h of (1).
  static double gap(const Parameters& p, const State<1>& s);
  static double normal_force(const Parameters& p, const Data& d, const State<1>& s);

  static void check(const Parameters&, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);

  struct Contact {
    static Status tile(const Family<Plane>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 1>& x);
  };
  struct Friction {
    static Status tile(const Family<Plane>& family, netloft_tile& t);
  };
};

template <class T>
T Plane::Contact::oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 1>& x) {
  const double n_z = 1 / std::sqrt(1 + p.slope_x * p.slope_x + p.slope_y * p.slope_y);
  const T depth = n_z * (p.slope_x * x[0].x + p.slope_y * x[0].y - x[0].z - p.depth);
  const double K = p.stiffness * (d.length > 0 ? d.length : d.pieces), e = p.softness;
  if (depth <= T(0)) return T(0);
  if (depth < T(e)) return (K / (6 * e)) * depth * depth * depth;
  return K * (0.5 * (depth - 0.5 * e) * (depth - 0.5 * e) + e * e / 24);
}

}  // namespace netloft::seabed
