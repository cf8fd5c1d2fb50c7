// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/interpolation.hpp>

#include "plugins/seabed/plane.hpp"

#include <numbers>

namespace netloft::seabed {

/// Contact and friction between a node and the bed of the scene, of any shape z_b(x, y). L metres of rope or
/// twine belong to the node; R is the radius of the rope, or of bobbins or discs that lift a footrope off the
/// bed.
///   g = z − z_b(x, y) − R,  ∇g = (−∂z_b/∂x, −∂z_b/∂y, 1)       gap, measured vertically            (1)
///   E = k m L f(−g),  r = k L (f ∇m − m f' ∇g)                f of plane.hpp (2), residual r
///   K = k L (m (f'' ∇g ∇gᵀ + f' ∇∇z_b) − f' (∇g ∇mᵀ + ∇m ∇gᵀ) + f ∇∇m)                              (2)
///   N = k m L f' ‖∇g‖,  n = ∇g/‖∇g‖                            normal force                         (3)
///   w = (I − n nᵀ)(v − v_b),  r = q μ N w h(‖w‖)               on a moving bed, h of plane.hpp (9)     (4)
///   r = η/(2π f₀) k m L s(−g/ε) (∇g·v) ∇g,  s(y) = y² (3 − 2y), 0 below 0, 1 beyond 1            (5)
/// m and q are local factors on stiffness and friction at (x, y), 1 by default; v and v_b are the velocities
/// of the node and of the ground; k, κ, ε and μ are those of plane.hpp. (5) is the damping of the bed in
/// compression, with the loss factor η at the frequency f₀, as in Kelvin and Voigt's solid; it is limited by
/// the force (2), because a bed does not pull. On ground at rest, a node sticks up to the force q μ N and
/// then slides, by plane.hpp (4) to (7) with n and N of (3) and the shear stiffness m κ.
struct OnBed {
  static constexpr auto stencil = NETLOFT_NODE;
  struct Parameters {
    double stiffness = 0, softness = 0, friction = 0, radius = 0;
    double shear_stiffness = 0;                  // shear stiffness κ
    double loss_factor = 0, loss_frequency = 1;  // loss factor η, its frequency f₀ [Hz]
    netloft_table bottom{};                      // columns: x, y, factors m and q
  };
  using Data = Plane::Data;
  /// Local factors m and q over x and y.
  struct Whole {
    Surface stiffness, friction;
  };
  static void gather(const Parameters& p, const Data&, Whole& whole);
  /// Returns a factor at a place; 1 if no factors are given.
  template <class T>
  static T factor(const Surface& factors, const Vec3<T>& at) {
    return factors.empty() ? T(1) : factors.at(at.x, at.y);
  }
  static void check(const Parameters&, const Data& d) { Plane::check({}, d); }

  /// The length L of (2) [m]. A node without rope or twine counts as one metre per piece (such as a weight).
  static double metres_of(const Data& d) { return d.length > 0 ? d.length : d.pieces; }
  static double stiffness_of(const Parameters& p, const Data& d) { return p.stiffness * metres_of(d); }
  /// The gap g of (1), in a scene with a bed.
  static double gap(const Parameters& p, const State<1>& s) { return s.x[0].z - s.bed[0].height - p.radius; }
  /// The normal force N of (3), in a scene with a bed.
  static double normal_force(const Parameters& p, const Data& d, const Whole& whole, const State<1>& s) {
    const Bed& b = s.bed[0];
    const double slope = std::sqrt(1 + b.slope_x * b.slope_x + b.slope_y * b.slope_y);
    return factor(whole.stiffness, s.x[0]) * stiffness_of(p, d) * slope *
           Plane::press(-gap(p, s), p.softness).f1;
  }

  struct Contact {
    static Status evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<1>& s,
                           Local<1>& out);
  };
  struct Friction {
    static Status tile(const Family<OnBed>& family, netloft_tile& t);
    /// Friction of a moving bed, (4).
    template <class T>
    static Points<T, 1> force(const Parameters& p, const Data& d, const Whole& whole,
                              const MovingNodes<T, 1>& m);
  };

  /// Friction on a bed at rest: displacement d of plane.hpp (4), shear spring m κ L, limit q μ N.
  template <class T>
  struct Grip {
    Vec3<T> d{};
    T spring{}, limit{};
  };
  template <class T>
  static Grip<T> grip(const Parameters& p, const Data& d, const Whole& whole, const MovingNodes<T, 1>& m,
                      const Vec3<double>& anchor);

  struct Loss {
    template <class T>
    static Points<T, 1> force(const Parameters& p, const Data& d, const Whole& whole,
                              const MovingNodes<T, 1>& m);
  };

 private:
  /// Vertical depth of the lower side of the node below the bed, −g of (1).
  template <class T>
  static T depth_of(const Parameters& p, const MovingNodes<T, 1>& m) {
    return m.bed[0].below(m.x[0]) + T(p.radius) - m.x[0].z;
  }
  /// The derivative f' of (2), to which the normal force is proportional.
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
OnBed::Grip<T> OnBed::grip(const Parameters& p, const Data& d, const Whole& whole, const MovingNodes<T, 1>& m,
                           const Vec3<double>& anchor) {
  if (!m.bed[0].is_there) return {};
  const T depth = depth_of(p, m);
  if (!(depth > T(0))) return {};
  const Vec3<T> up = gap_slope(m), n = (1.0 / norm(up)) * up;
  const Vec3<T> off = m.x[0] - Vec3<T>{T(anchor.x), T(anchor.y), T(anchor.z)};
  const T bottom = factor(whole.stiffness, m.x[0]);
  return {off - dot(off, n) * n, p.shear_stiffness * metres_of(d) * bottom,
          p.friction * stiffness_of(p, d) * bottom * factor(whole.friction, m.x[0]) * pressed_by(p, depth) *
              norm(up)};
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
