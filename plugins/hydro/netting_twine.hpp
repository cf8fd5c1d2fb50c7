// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/lane_number.hpp"
#include "plugins/common/sphere.hpp"
#include "plugins/hydro/reynolds.hpp"

#include <numbers>

namespace netloft::hydro {

/// Force of the water on a metre of twine of knotted netting. Drag across the twine, friction along the
/// twine, and drag of the knots depend on a separate Reynolds number each:
///   U = r W,  τ = U·t,  U_n = U − τ t,  s = ‖U_n‖,  u = ‖U‖,  û = U_n/s,  ê = U/u              (1)
///   F = k(s) U_n + a(e) τ t + m(u) U                                                          (2)
///   k = ½ ρ ν φ(s D/ν)                                   a cylinder across, reynolds.hpp       (3)
///   a = π ρ ν (0.55 Re^½ + 0.084 Re^⅔),  Re² = 1 + (e D/ν)²,  e² = s² + ε² τ²      friction    (4)
///   m = ½ ρ ν (K/κ) ψ(κ u D/ν)                           knots as spheres, ψ of sphere.hpp     (5)
/// with g = s dk/ds, h = e da/de, n = u dm/du:
///   ∂F/∂U = k (I − t tᵀ) + g û ûᵀ + a t tᵀ + h (τ/e²) t (U_n + ε² τ t)ᵀ + m I + n ê êᵀ           (6)
///   ∂F/∂t = −τ (k I + g û ûᵀ) − k t Uᵀ + a (t Uᵀ + τ I) − h (τ²/e²) t (U_n − ε² U)ᵀ              (7)
///   ∂F/∂W = r ∂F/∂U                                                                         (8)
/// W, r, t, D and ρ are those of crossflow.hpp, ν [m²/s] is the viscosity. K [1] frontal area of the knots
/// over that of the twines, κ [1] diameter of a knot over that of the twine; one knot belongs to two bars of
/// length l, so that K = π κ² D/(8 l). At small angles to the flow, twines have little drag, but knots have
/// as much as at any angle. At the Reynolds numbers of models in tanks, friction along twines is several
/// times that at sea. Sources: (3), (4) Choo and Casarella 1971, as in reynolds.hpp, with (4) valid for 30 <
/// Re < 10⁴; (5) Morrison 2013. Knots as spheres: Fredheim, Current forces on net structures, NTNU 2005.
/// Deviations: (4) as published uses s for e; at s = 0 it has no friction and no derivative. With ε = 0.1, a
/// is constant within 6° of the twine; with the 1 in Re², friction is linear in the velocity near rest. The
/// wake of other twines enters only through r.
struct NettingTwine {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  struct Parameters {
    double shielding = 0, knots = 0, knot_diameter = 0;
    std::int64_t cylinder = 0;
  };
  static constexpr double kAlong = 0.1;  // ε of (4)

  template <class T>
  static T friction(double density, double viscosity, const T& along) {  // a of (4), from e D/ν
    using std::pow, std::sqrt;
    const T Re = sqrt(along * along + 1.0);
    return (std::numbers::pi * density * viscosity) * (0.55 * sqrt(Re) + 0.084 * pow(Re, 2.0 / 3));
  }
  /// (2) for dual numbers: the reference implementation for tests.
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    using std::sqrt;
    const Vec3<T> U = p.shielding * f.flow;
    const T tau = dot(U, f.direction);
    const Vec3<T> U_n = U - tau * f.direction;
    const T s = norm(U_n), e = sqrt(s * s + (kAlong * kAlong) * tau * tau);
    const double per_speed = f.diameter / f.viscosity, half = 0.5 * f.density * f.viscosity;
    const T k = half * cylinder_phi(p.cylinder, s * per_speed);
    const T m = (half * p.knots / p.knot_diameter) * sphere_phi(norm(U) * (per_speed * p.knot_diameter));
    return k * U_n + (friction(f.density, f.viscosity, e * per_speed) * tau) * f.direction + m * U;
  }
  static void lanes(const Parameters& p, const netloft_law_tile& f);
};

}  // namespace netloft::hydro
