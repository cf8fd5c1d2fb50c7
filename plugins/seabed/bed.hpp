// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/interpolation.hpp>

#include "plugins/seabed/plane.hpp"

#include <numbers>

namespace netloft::seabed {

/// The bed of the scene, of any shape, under a node that carries L metres of rope or twine and is round with
/// the radius r: contact, and the friction of a bed that a gear is towed over.
///   g = z − z_b(x, y) − r,  ∇g = (−∂z_b/∂x, −∂z_b/∂y, 1)       gap, measured upright              (1)
///   E = k m L f(−g),  r = k L (f ∇m − m f' ∇g)                f of plane.hpp (2)
///   K = k L (m (f'' ∇g ∇gᵀ + f' ∇∇z_b) − f' (∇g ∇mᵀ + ∇m ∇gᵀ) + f ∇∇m)                              (2)
///   N = k m L f' ‖∇g‖,  n = ∇g/‖∇g‖                            normal force                         (3)
///   w = (I − n nᵀ)(v − v_b),  r = q μ N w h(‖w‖)               h of plane.hpp (9)                   (4)
///   r = η/(2π f₀) k m L s(−g/ε) (∇g·v) ∇g,  s(y) = y² (3 − 2y), 0 below 0, 1 beyond 1            (5)
/// (5) is what the bed loses as it is pressed in and gives way, by the loss factor η at the frequency f₀, as
/// Kelvin and Voigt's solid, but no more than (2) presses: a bed does not pull at what leaves it. m and q, 1
/// if nothing is said, are factors of what the bed is made of at x and y. v_b is the velocity at which the
/// ground passes; where it stands there is no friction, and a `seabed/plane` has the one that sticks. r lifts
/// a footrope on bobbins or discs off the bed.
struct OnBed {
  static constexpr auto stencil = NETLOFT_NODE;
  struct Parameters {
    double stiffness = 0, softness = 0, friction = 0, radius = 0;
    double loss_factor = 0, loss_frequency = 1;  // η, f₀ [Hz]
    netloft_table bottom{};                      // x, y, m, q
  };
  using Data = Plane::Data;
  /// What the bed is made of: m and q over x and y.
  struct Whole {
    Surface stiffness, friction;
  };
  static void gather(const Parameters& p, const Data&, Whole& whole);
  /// A factor at a place; 1 where nothing is said.
  template <class T>
  static T factor(const Surface& factors, const Vec3<T>& at) {
    return factors.empty() ? T(1) : factors.at(at.x, at.y);
  }
  static void check(const Parameters&, const Data& d) { Plane::check({}, d); }

  /// k L of (2).
  static double stiffness_of(const Parameters& p, const Data& d) {
    return p.stiffness * (d.length > 0 ? d.length : d.pieces);
  }
  /// N of (3), where the bed is known.
  static double normal_force(const Parameters& p, const Data& d, const Whole& whole, const State<1>& s) {
    const Bed& b = s.bed[0];
    const double slope = std::sqrt(1 + b.slope_x * b.slope_x + b.slope_y * b.slope_y);
    return factor(whole.stiffness, s.x[0]) * stiffness_of(p, d) * slope *
           Plane::press(b.height + p.radius - s.x[0].z, p.softness).f1;
  }

  struct Contact {
    static Status evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<1>& s,
                           Local<1>& out);
  };
  struct Friction {
    template <class T>
    static Points<T, 1> force(const Parameters& p, const Data& d, const Whole& whole,
                              const MovingNodes<T, 1>& m);
  };

  struct Loss {
    template <class T>
    static Points<T, 1> force(const Parameters& p, const Data& d, const Whole& whole,
                              const MovingNodes<T, 1>& m);
  };

 private:
  /// Depth of the node's lower side under the bed, upright, and ∇g there.
  template <class T>
  static T depth_of(const Parameters& p, const MovingNodes<T, 1>& m) {
    return m.bed[0].below(m.x[0]) + T(p.radius) - m.x[0].z;
  }
  /// f' of (2).
  template <class T>
  static T pressed_by(const Parameters& p, const T& depth) {
    return depth < T(p.softness) ? depth * depth / T(2 * p.softness) : depth - T(0.5 * p.softness);
  }
  template <class T>
  static Vec3<T> gap_slope(const MovingNodes<T, 1>& m) {
    const Bed& b = m.bed[0];
    const T dx = m.x[0].x - T(b.x), dy = m.x[0].y - T(b.y);
    return {-(b.slope_x + b.xx * dx + b.xy * dy), -(b.slope_y + b.xy * dx + b.yy * dy), T(1)};
  }
};

template <class T>
Points<T, 1> OnBed::Friction::force(const Parameters& p, const Data& d, const Whole& whole,
                                    const MovingNodes<T, 1>& m) {
  const double passing = norm(m.ground);
  const Bed& b = m.bed[0];
  if (!(passing > 0) || !b.is_there) return {Vec3<T>{}};
  const T depth = depth_of(p, m);
  if (!(depth > T(0))) return {Vec3<T>{}};
  const Vec3<T> up = gap_slope(m);
  const T pressed = pressed_by(p, depth);
  const Vec3<T> n = (1.0 / norm(up)) * up;
  const Vec3<T> over = m.v[0] - Vec3<T>{T(m.ground.x), T(m.ground.y), T(m.ground.z)};
  const Vec3<T> w = over - dot(over, n) * n;
  const T speed = norm(w);
  const double c = Plane::kCreep * passing;
  const T share = speed >= T(c) ? 1.0 / speed : (2.0 - speed / T(c)) / T(c);
  const T bottom = factor(whole.stiffness, m.x[0]) * factor(whole.friction, m.x[0]);
  return {(-p.friction * stiffness_of(p, d)) * bottom * pressed * norm(up) * share * w};  // (4)
}

template <class T>
Points<T, 1> OnBed::Loss::force(const Parameters& p, const Data& d, const Whole& whole,
                                const MovingNodes<T, 1>& m) {
  if (!m.bed[0].is_there) return {Vec3<T>{}};
  const T depth = depth_of(p, m);
  if (!(depth > T(0))) return {Vec3<T>{}};
  const T y = depth < T(p.softness) ? depth / T(p.softness) : T(1);
  const Vec3<T> up = gap_slope(m);
  const T K = stiffness_of(p, d) * factor(whole.stiffness, m.x[0]);
  const double time = p.loss_factor / (2 * std::numbers::pi * p.loss_frequency);
  const T resists = time * y * y * (3.0 - 2.0 * y) * dot(up, m.v[0]), presses = pressed_by(p, depth);
  return {-K * (resists < presses ? resists : presses) * up};  // (5)
}

}  // namespace netloft::seabed
