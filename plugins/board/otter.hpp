// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/interpolation.hpp>

#include "plugins/board/plate.hpp"
#include "plugins/common/solid.hpp"

namespace netloft::boards {

/// A board, kite or depressor: a rigid body with lift. Its axes are x aft along the chord, y outward, normal
/// to the suction side, z up along the span; its origin is the middle of the projected area S. w is the unit
/// vector of the flow in these axes, u [m/s] its speed, ρ [kg/m³] the density of water, q = ½ρ S u² [N].
///   α = atan2(w_y, w_x)   attack,   β = asin w_z   sideslip: flow along the span                        (1)
///   F = q (f_D C_D w + f_L (C_L e_L + C_Z e_Z)),   e_L = (−w_y, w_x, 0)/cos β,   e_Z = z − w_z w, unit   (2)
///   acts at (chord (ξ − ½), 0, span η)                                                                   (3)
/// f_D and f_L are factors for calibration. One table gives C_L, C_D and C_Z over α and β, another gives ξ
/// (from the nose) and η (above the middle) over α. If the first table is over α alone, only the flow across
/// the span causes the force, as for a yawed wing of infinite span: C_L(α), C_D(α) are multiplied by cos²β
/// (R. T. Jones, NACA TN 1402, 1947), and C_Z = 0. Without a table the board is a flat plate (plate.hpp) with
/// an additional drag coefficient C_0,
///   F = q (f_D F_∥ + f_L F_⊥),  F_∥, F_⊥ the parts of C_N sgn(w_y) y + C_0 w along and across w         (4)
/// A bed under the board increases the force of the plate, by plate.hpp (7), but not a force from a table.
/// Beyond the edge of a table, the coefficients change to those of the plate within 20°, and the output
/// `outside` is 1. A quarter of the force is evaluated at each of the four Gauss points (±chord, ±span)/2√3,
/// so that it depends on rotation and on a current that varies over the height of the board.
///
/// If the lower edge sinks into moving ground, ploughing pushes it outward. The force at each of four points
/// along the edge depends on the depth δ of the point and on the direction ĝ in which the ground passes it:
///   F = ¼ chord s p f (ĝ·y) y,   f = (δ/0.1 m)^n, continued by its tangent beyond 0.1 m                 (5)
/// n is 1 in clay and 2 in sand; s is the local factor of the ground, 1 by default; p [N/m] is for
/// calibration and zero by default. The continuation by a tangent keeps the force moderate if an initial
/// guess has boards metres deep in the ground. Ploughing does not support the board: the contact of the board
/// with the bed belongs to elements seabed/bed, at points of its shoe.
///
/// Source of (1)-(3): FAO, Otter board design and performance (1974). The force on a body in a uniform flow
/// depends on two angles of the flow in the axes of the body. α and β, unlike the angles of a test rig
/// (attack, heel and trim), have no singularity in the working range.
struct Otter {
  static constexpr auto stencil = NETLOFT_BODY;
  struct Parameters : solids::Solid {
    double area = 0, chord = 0, span = 0;
    double lift = 1, drag = 1;        // factors f_L, f_D
    double parasite = 0;              // coefficient C_0
    double ploughing = 0, power = 1;  // p [N/m] and exponent n of (5)
    netloft_table polar{}, polar_slip{}, pressure{}, bottom{};
  };
  using Data = solids::Sided;

  struct Whole {
    Surface lift, drag, side, ploughing;
    Curve chord, span;  // fractions ξ and η of (3)
    bool is_of_attack_alone = false;
  };
  static void check(const Parameters& p, const Data&);
  static void gather(const Parameters& p, const Data&, Whole& whole);

  struct Force {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data& d, const Whole& whole, const Body<T>& b);
  };

  struct Ploughing {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data&, const Whole& whole, const Body<T>& b);
  };

  /// The flow past the origin: its direction in the axes of the board (y outward), its speed, and its angles
  /// by (1).
  struct Flow {
    Vec3<double> w;  // unit vector
    double speed = 0, attack = 0, sideslip = 0;
  };
  static Flow flow_past(const Data& d, const Body<double>& b);
  static bool is_outside(const Whole& whole, const Flow& flow);
};

namespace detail {

/// Force coefficients along w, e_L and e_Z of (2), combined into one vector in the axes of the board (y
/// outward), and the point at which the force acts.
template <class T>
struct Coefficients {
  Vec3<T> force;
  T at_chord, at_span;  // point of action by (3) [m]
};

/// Returns the number i of plate.hpp (7), which increases the aspect ratio if the lower edge is near the bed.
template <class T>
T image_in_bed(const Otter::Parameters& p, const Body<T>& b) {
  if (!b.bed.is_there) return T(0);
  const T upright = b.axes[2].z < T(0) ? -b.axes[2].z : b.axes[2].z;
  const T clearance = b.x.z - b.bed.below(b.x) - 0.5 * p.span * upright;
  return 1.0 - cubic_step(clearance / T(p.span));
}

template <class T>
Coefficients<T> of_plate(const Otter::Parameters& p, const Vec3<T>& w, const T& image) {
  const PlateForce<T> plate = plate_force(w, p.chord, p.span, image);
  Vec3<T> force = p.parasite * w;
  force.y += w.y < T(0) ? -plate.normal : plate.normal;
  return {force, plate.ahead_chord, plate.ahead_span};
}

template <class T>
Coefficients<T> of_table(const Otter::Parameters& p, const Otter::Whole& t, const Vec3<T>& w, const T& alpha,
                         const T& beta) {
  using std::sqrt;
  const T across = sqrt(w.x * w.x + w.y * w.y);  // cos β
  const T share = t.is_of_attack_alone ? across * across : T(1);
  const T none(0), cl = share * t.lift.at(alpha, beta), cd = share * t.drag.at(alpha, beta),
                   cz = t.is_of_attack_alone ? none : t.side.at(alpha, beta);
  Coefficients<T> c;
  c.force = cd * w + (cl / across) * Vec3<T>{-w.y, w.x, none};
  c.force += (cz / across) * Vec3<T>{-w.z * w.x, -w.z * w.y, across * across};
  if (t.chord.empty()) {
    const PlateForce<T> plate = plate_force(w, p.chord, p.span);
    c.at_chord = plate.ahead_chord;
    c.at_span = plate.ahead_span;
  } else {
    c.at_chord = p.chord * (t.chord.at(alpha) - 0.5);
    c.at_span = p.span * t.span.at(alpha);
  }
  return c;
}

/// Weight of the plate's coefficients against those of the table: 0 for a flow within the table, rising
/// smoothly to 1 at 20° beyond the edge of the table.
template <class T>
T weight_of_plate(const Otter::Whole& t, const T& alpha, const T& beta) {
  constexpr double kPassage = 0.3490658503988659;  // 20° [rad]
  const auto beyond = [&](double lo, double hi, const T& x) {
    return x < T(lo) ? (lo - x) / kPassage : x > T(hi) ? (x - hi) / kPassage : T(0);
  };
  const T by_attack = cubic_step(beyond(t.lift.first_of_x(), t.lift.last_of_x(), alpha));
  if (t.is_of_attack_alone) return by_attack;
  const T by_slip = cubic_step(beyond(t.lift.first_of_y(), t.lift.last_of_y(), beta));
  return by_attack + by_slip - by_attack * by_slip;
}

template <class T>
Coefficients<T> coefficients_of(const Otter::Parameters& p, const Otter::Whole& t, const Vec3<T>& w,
                                const T& image) {
  using std::asin, std::atan2;
  const Coefficients<T> plate = of_plate(p, w, image);
  if (t.lift.empty() || !(w.x * w.x + w.y * w.y > T(1e-20))) return plate;
  const T alpha = atan2(w.y, w.x), beta = asin(w.z);
  const Coefficients<T> table = of_table(p, t, w, alpha, beta);
  const T share = weight_of_plate(t, alpha, beta);
  return {table.force + share * (plate.force - table.force),
          table.at_chord + share * (plate.at_chord - table.at_chord),
          table.at_span + share * (plate.at_span - table.at_span)};
}

}  // namespace detail

template <class T>
Wrench<T> Otter::Force::force(const Parameters& p, const Data& d, const Whole& whole, const Body<T>& b) {
  constexpr double kGauss = 0.28867513459481287;  // 1/2√3
  Wrench<T> push;
  const T image = detail::image_in_bed(p, b);
  for (const double i : {-kGauss, kGauss})
    for (const double k : {-kGauss, kGauss}) {
      const Vec3<double> r{i * p.chord, 0, k * p.span};
      Vec3<T> W = b.to_body(b.current_at(r) - b.velocity(r));
      W.y = d.side * W.y;
      const T u = norm(W);
      if (!(u > T(0))) continue;
      const Vec3<T> w = (1.0 / u) * W;
      const auto c = detail::coefficients_of(p, whole, w, image);
      const Vec3<T> along = dot(c.force, w) * w;
      Vec3<T> f = (0.125 * b.water.density * p.area * u * u) *
                  (p.drag * along + p.lift * (c.force - along));  // a quarter of the force by (2) or (4)
      f.y = d.side * f.y;
      push.push(b.to_world(f), b.to_world(Vec3<T>{r.x + c.at_chord, T(0), r.z + c.at_span}));
    }
  return push;
}

namespace detail {

/// The factor f of ploughing by (5). `depth` is δ/0.1 m, the depth of the edge in the ground; it must be
/// positive.
template <class T>
T resistance(const T& depth, double power) {
  using std::pow;
  return depth < T(1) ? pow(depth, power) : 1.0 + power * (depth - T(1));
}

}  // namespace detail

template <class T>
Wrench<T> Otter::Ploughing::force(const Parameters& p, const Data&, const Whole& whole, const Body<T>& b) {
  constexpr double kDeep = 0.1;  // [m]
  Wrench<T> push;
  if (!b.bed.is_there || !(norm(b.ground) > 0)) return push;
  for (const double i : {-0.375, -0.125, 0.125, 0.375}) {
    const Vec3<double> r{i * p.chord, 0, -0.5 * p.span};
    const Vec3<T> at = b.point(r);
    const T depth = b.bed.below(at) - at.z;
    if (!(depth > T(0))) continue;
    const Vec3<T> g = Vec3<T>{T(b.ground.x), T(b.ground.y), T(b.ground.z)} - b.velocity(r);
    const T speed = norm(g);
    if (!(speed > T(0))) continue;
    const T bottom = whole.ploughing.empty() ? T(1) : whole.ploughing.at(at.x, at.y);
    const T size = 0.25 * p.chord * p.ploughing * bottom * detail::resistance<T>(depth / T(kDeep), p.power) *
                   dot(g, b.axes[1]) / speed;
    push.push(size * b.axes[1], b.to_world(r));
  }
  return push;
}

}  // namespace netloft::boards
