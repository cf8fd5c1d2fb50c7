// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>
#include <netloft/rotation.hpp>

#include <array>
#include <deque>
#include <string>

namespace netloft::solids {

/// A symmetric tensor, given by principal values and axes; it is positive semi-definite if no value is
/// negative.
struct Tensor {
  Vec3<double> values;
  std::array<Vec3<double>, 3> axes;

  /// `turned`: the rotation vector from the axes of the body to the principal axes [rad]. For side = −1, the
  /// rotation is mirrored at the xz plane.
  Tensor(const Vec3<double>& principal, const Vec3<double>& turned, double side)
      : values(principal), axes(turned_axes(Vec3<double>{side * turned.x, turned.y, side * turned.z})) {}

  template <class T>
  Vec3<T> times(const Vec3<T>& v) const {
    Vec3<T> sum;
    for (int i = 0; i < 3; ++i) {
      const Vec3<double>& e = axes[static_cast<std::size_t>(i)];
      const T part = values[i] * (e.x * v.x + e.y * v.y + e.z * v.z);
      sum += Vec3<T>{part * e.x, part * e.y, part * e.z};
    }
    return sum;
  }
};

/// Properties of a rigid body: mass and buoyancy with their centres, inertia, and added mass of the water.
struct Solid {
  double mass = 0, volume = 0;                         // [kg], [m3]
  double centre_x = 0, centre_y = 0, centre_z = 0;     // centre of mass, in the body's axes [m]
  double float_x = 0, float_y = 0, float_z = 0;        // centre of volume [m]
  double inertia_x = 0, inertia_y = 0, inertia_z = 0;  // moments of inertia about the centre of mass [kg m2]
  double added_x = 0, added_y = 0, added_z = 0;        // added mass along the body's axes [kg]
  double turning_x = 0, turning_y = 0, turning_z = 0;  // added inertia about these axes [kg m2]
  // Rotation vectors from the body's axes to the principal axes of inertia, and to those of added mass and
  // added inertia [rad].
  double inertia_turned_x = 0, inertia_turned_y = 0, inertia_turned_z = 0;
  double added_turned_x = 0, added_turned_y = 0, added_turned_z = 0;
  double added_at_x = 0, added_at_y = 0, added_at_z = 0;  // point about which added mass has no moment [m]
};

struct Sided {
  double side = 1;  // −1: the body is mirrored, y reversed
};

inline Vec3<double> centre_of_mass(const Solid& p, const Sided& d) {
  return {p.centre_x, d.side * p.centre_y, p.centre_z};
}
inline Vec3<double> centre_of_volume(const Solid& p, const Sided& d) {
  return {p.float_x, d.side * p.float_y, p.float_z};
}

/// Weight at the centre of mass c, buoyancy at the centre of volume b:  E = m g z(c) − ρ V g z(b)    (1)
struct Weight {
  template <class T>
  static T energy(const Solid& p, const Sided& d, const Water& w, const Pose<T>& pose) {
    return w.gravity * (p.mass * pose.point(centre_of_mass(p, d)).z -
                        w.density * p.volume * pose.point(centre_of_volume(p, d)).z);  // (1)
  }
};

/// Inertia of the body and of the water that moves with it. In the axes of the body, u is the velocity of the
/// point a at which added mass has no moment, and Ω is the angular velocity; R rotates to the axes of the
/// world, m is the mass and a_c the acceleration of its centre. J, A and B are the symmetric tensors of
/// inertia, added mass and added inertia:
///   F = −m a_c at the centre of mass,  M = −R (J Ω̇ + Ω×J Ω)                                     (2)
///   F = −R (A u̇ + Ω×A u) at a,  M = −R (B Ω̇ + Ω×B Ω + u×A u)                                    (3)
/// (H. Lamb, Hydrodynamics, 1932, §§ 121-124: G. Kirchhoff's equations). u is the velocity over the ground,
/// not relative to the water, because coefficients of lift and moment already include the effect of a steady
/// flow.
struct Inertia {
  template <class T>
  static Wrench<T> force(const Solid& p, const Sided& d, const Body<T>& b) {
    const Vec3<T> r = b.to_world(centre_of_mass(p, d));
    Wrench<T> push;
    push.push(T(-p.mass) * (b.a + cross(b.alpha, r) + cross(b.omega, cross(b.omega, r))), r);
    const Vec3<T> spin = b.to_body(b.omega), spin_rate = b.to_body(b.alpha);
    const Vec3<T> at{T(p.added_at_x), T(d.side * p.added_at_y), T(p.added_at_z)};
    const Vec3<T> v = b.to_body(b.v), u = v + cross(spin, at);
    const Vec3<T> rate = b.to_body(b.a) - cross(spin, v) + cross(spin_rate, at);
    const Vec3<double> turned{p.added_turned_x, p.added_turned_y, p.added_turned_z};
    const Tensor added({p.added_x, p.added_y, p.added_z}, turned, d.side);
    const Tensor turning({p.turning_x, p.turning_y, p.turning_z}, turned, d.side);
    const Tensor inertia({p.inertia_x, p.inertia_y, p.inertia_z},
                         {p.inertia_turned_x, p.inertia_turned_y, p.inertia_turned_z}, d.side);
    const auto J = [&](const Vec3<T>& w) { return inertia.times(w) + turning.times(w); };
    const Vec3<T> momentum = added.times(u);
    push.push(-b.to_world(added.times(rate) + cross(spin, momentum)), b.to_world(at));     // (3)
    push.moment += -b.to_world(J(spin_rate) + cross(spin, J(spin)) + cross(u, momentum));  // (2), (3)
    return push;
  }
};

/// The declaration of one parameter of a Solid, for the table below.
struct SolidRow {
  const char *name, *unit, *doc;
  double Solid::*member;
  Real range;
};
inline constexpr Real kPlace{.lo = -1e3, .hi = 1e3, .fallback = 0},
    kAmount{.lo = 0, .hi = 1e9, .fallback = 0}, kAngle{.lo = -6.3, .hi = 6.3, .fallback = 0};

inline constexpr SolidRow kSolidRows[] = {
    {"centre_x", "m", "centre of mass, aft of the origin", &Solid::centre_x, kPlace},
    {"centre_y", "m", "centre of mass, outward of the origin", &Solid::centre_y, kPlace},
    {"centre_z", "m", "centre of mass, above the origin", &Solid::centre_z, kPlace},
    {"float_x", "m", "centre of volume, aft of the origin", &Solid::float_x, kPlace},
    {"float_y", "m", "centre of volume, outward of the origin", &Solid::float_y, kPlace},
    {"float_z", "m", "centre of volume, above the origin", &Solid::float_z, kPlace},
    {"inertia_x", "kg m2", "moment of inertia about an axis through the centre of mass along x",
     &Solid::inertia_x, kAmount},
    {"inertia_y", "kg m2", "moment of inertia about an axis through the centre of mass along y",
     &Solid::inertia_y, kAmount},
    {"inertia_z", "kg m2", "moment of inertia about an axis through the centre of mass along z",
     &Solid::inertia_z, kAmount},
    {"added_x", "kg", "added mass of motion along x", &Solid::added_x, kAmount},
    {"added_y", "kg", "added mass of motion along y", &Solid::added_y, kAmount},
    {"added_z", "kg", "added mass of motion along z", &Solid::added_z, kAmount},
    {"turning_x", "kg m2", "added inertia of turning about x", &Solid::turning_x, kAmount},
    {"turning_y", "kg m2", "added inertia of turning about y", &Solid::turning_y, kAmount},
    {"turning_z", "kg m2", "added inertia of turning about z", &Solid::turning_z, kAmount},
    {"inertia_turned_x", "rad",
     "x of the rotation vector that turns the body's axes into those of its moments of inertia",
     &Solid::inertia_turned_x, kAngle},
    {"inertia_turned_y", "rad",
     "y of the rotation vector that turns the body's axes into those of its moments of inertia",
     &Solid::inertia_turned_y, kAngle},
    {"inertia_turned_z", "rad",
     "z of the rotation vector that turns the body's axes into those of its moments of inertia",
     &Solid::inertia_turned_z, kAngle},
    {"added_turned_x", "rad",
     "x of the rotation vector that turns the body's axes into those of its added mass and inertia",
     &Solid::added_turned_x, kAngle},
    {"added_turned_y", "rad",
     "y of the rotation vector that turns the body's axes into those of its added mass and inertia",
     &Solid::added_turned_y, kAngle},
    {"added_turned_z", "rad",
     "z of the rotation vector that turns the body's axes into those of its added mass and inertia",
     &Solid::added_turned_z, kAngle},
    {"added_at_x", "m", "point at which a force on the added mass causes no rotation, aft of the origin",
     &Solid::added_at_x, kPlace},
    {"added_at_y", "m", "point at which a force on the added mass causes no rotation, outward of the origin",
     &Solid::added_at_y, kPlace},
    {"added_at_z", "m", "point at which a force on the added mass causes no rotation, above the origin",
     &Solid::added_at_z, kPlace},
};

/// Declares the parameters of a Solid, with names that begin with `prefix` (such as "body."), the datum
/// `side`, and the terms Weight and Inertia.
template <class E>
void declare_solid(ElementTable<E>& e, const std::string& prefix, Real mass) {
  using P = typename E::Parameters;
  static std::deque<std::string> names;  // kept until the program ends
  const auto name = [&](const char* own) { return names.emplace_back(prefix + own).c_str(); };
  e.real(name("mass"), static_cast<double P::*>(&Solid::mass), "kg", "mass in air", mass);
  e.real(name("volume"), static_cast<double P::*>(&Solid::volume), "m3",
         "volume of the water that the body displaces", {.lo = 0, .hi = 1e6, .fallback = 0});
  for (const SolidRow& row : kSolidRows)
    e.real(name(row.name), static_cast<double P::*>(row.member), row.unit, row.doc, row.range);
  e.data("side", static_cast<double E::Data::*>(&Sided::side), "1", "1, or -1 if the body is mirrored");
  const char* needs = names.emplace_back(prefix + "mass " + prefix + "volume").c_str();
  e.template term<Weight, needs_gravity | is_weight>("weight", "weight less buoyancy", needs);
  e.template term<Inertia, reads_velocity | reads_acceleration | needs_motion>(
      "inertia", "inertia of the body and of the water that moves with it");
}

}  // namespace netloft::solids
