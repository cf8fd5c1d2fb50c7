// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/solid.hpp"

namespace netloft::bodies {

/// A rigid body with weight, buoyancy, drag and added mass, such as a clump, a frame or a shaped weight.
/// Weight and inertia are those of plugins/common/solid.hpp. W [m/s] is the velocity of the water past the
/// origin, e_i are the axes of the body, ρ is the density of the water:
///   F = ½ ρ |W| Σ_i A_i (W·e_i) e_i     at the centre of volume                                   (1)
///   M = −½ ρ Σ_i B_i |Ω_i| Ω_i e_i      Ω_i [rad/s] angular velocity about e_i                    (2)
/// A_i [m²] are the areas normal to the axes times their drag coefficients; B_i [m⁵] are the corresponding
/// coefficients for rotation.
struct BodySolid {
  static constexpr auto stencil = NETLOFT_BODY;
  struct Parameters : solids::Solid {
    double drag_x = 0, drag_y = 0, drag_z = 0;           // areas A_i [m²]
    double damping_x = 0, damping_y = 0, damping_z = 0;  // coefficients B_i [m⁵]
  };
  using Data = solids::Sided;

  struct Drag {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data& d, const Body<T>& b);
  };
};

template <class T>
Wrench<T> BodySolid::Drag::force(const Parameters& p, const Data& d, const Body<T>& b) {
  const Vec3<double> at = solids::centre_of_volume(p, d);
  const Vec3<T> W = b.to_body(b.current_at(at) - b.velocity(at)), spin = b.to_body(b.omega);
  const double half = 0.5 * b.water.density;
  const T speed = norm(W);
  Wrench<T> push;
  push.push(b.to_world(half * speed * Vec3<T>{p.drag_x * W.x, p.drag_y * W.y, p.drag_z * W.z}),
            b.to_world(at));  // (1)
  const auto resisted = [&](double B, const T& rate) { return (-half * B) * abs(rate) * rate; };
  push.moment += b.to_world(Vec3<T>{resisted(p.damping_x, spin.x), resisted(p.damping_y, spin.y),
                                    resisted(p.damping_z, spin.z)});  // (2)
  return push;
}

}  // namespace netloft::bodies
