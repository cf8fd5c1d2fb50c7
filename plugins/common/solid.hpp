// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <deque>
#include <string>

namespace netloft::solids {

/// What a rigid body is made of: mass and buoyancy at their places, inertia, and the added mass of water.
struct Solid {
  double mass = 0, volume = 0;                         // [kg], [m3]
  double centre_x = 0, centre_y = 0, centre_z = 0;     // of mass, in the body's axes [m]
  double float_x = 0, float_y = 0, float_z = 0;        // of volume [m]
  double inertia_x = 0, inertia_y = 0, inertia_z = 0;  // about the centre of mass [kg m2]
  double added_x = 0, added_y = 0, added_z = 0;        // added mass along the body's axes [kg]
  double turning_x = 0, turning_y = 0, turning_z = 0;  // added inertia about them [kg m2]
};

/// Datum of elements on bodies.
struct Sided {
  double side = 1;  // -1: y is reversed
};

inline Vec3<double> centre_of_mass(const Solid& p, const Sided& d) {
  return {p.centre_x, d.side * p.centre_y, p.centre_z};
}
inline Vec3<double> centre_of_volume(const Solid& p, const Sided& d) {
  return {p.float_x, d.side * p.float_y, p.float_z};
}

/// E = m g z(c) − ρ V g z(b): weight at c, buoyancy at b.                                        (1)
struct Weight {
  template <class T>
  static T energy(const Solid& p, const Sided& d, const Water& w, const Pose<T>& pose) {
    return w.gravity * (p.mass * pose.point(centre_of_mass(p, d)).z -
                        w.density * p.volume * pose.point(centre_of_volume(p, d)).z);  // (1)
  }
};

/// Inertia of what the body is made of and of the water that moves with it. With u and Ω the velocity of the
/// origin and the spin in the body's axes, diagonal matrices J of inertia, A of added mass, B of added
/// inertia,
///   F = −m a_c at the centre of mass,  M = −R (J Ω̇ + Ω×J Ω)                                     (2)
///   F = −R (A u̇ + Ω×A u),  M = −R (B Ω̇ + Ω×B Ω + u×A u)                                         (3)
/// (H. Lamb, Hydrodynamics, 1932, §§ 121-124: G. Kirchhoff's equations). u is the motion in the scene, not
/// that past the water: what a steady flow does to the body stands in its coefficients of lift and moment.
struct Inertia {
  template <class T>
  static Wrench<T> force(const Solid& p, const Sided& d, const Body<T>& b) {
    const Vec3<T> r = b.to_world(centre_of_mass(p, d));
    Wrench<T> push;
    push.push(T(-p.mass) * (b.a + cross(b.alpha, r) + cross(b.omega, cross(b.omega, r))), r);
    const Vec3<T> u = b.to_body(b.v), spin = b.to_body(b.omega), spin_rate = b.to_body(b.alpha);
    const Vec3<T> rate = b.to_body(b.a) - cross(spin, u);
    const Vec3<T> momentum = scaled(u, p.added_x, p.added_y, p.added_z);
    push.force += -b.to_world(scaled(rate, p.added_x, p.added_y, p.added_z) + cross(spin, momentum));  // (3)
    const double x = p.inertia_x + p.turning_x, y = p.inertia_y + p.turning_y, z = p.inertia_z + p.turning_z;
    push.moment += -b.to_world(scaled(spin_rate, x, y, z) + cross(spin, scaled(spin, x, y, z)) +
                               cross(u, momentum));  // (2), (3)
    return push;
  }

 private:
  template <class T>
  static Vec3<T> scaled(const Vec3<T>& v, double x, double y, double z) {
    return {x * v.x, y * v.y, z * v.z};
  }
};

/// Declares the parameters of a Solid under a prefix such as "body.", the side, and the terms above.
template <class E>
void declare_solid(ElementTable<E>& e, const std::string& prefix, Real mass) {
  using P = typename E::Parameters;
  static std::deque<std::string> names;  // as long as the program
  const auto name = [&](const char* own) { return names.emplace_back(prefix + own).c_str(); };
  const Real place{.lo = -1e3, .hi = 1e3, .fallback = 0}, amount{.lo = 0, .hi = 1e9, .fallback = 0};
  e.real(name("mass"), static_cast<double P::*>(&Solid::mass), "kg", "mass in air", mass);
  e.real(name("volume"), static_cast<double P::*>(&Solid::volume), "m3", "volume of water it displaces",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  struct Row {
    const char *name, *unit, *doc;
    double Solid::*member;
    Real range;
  };
  const Row rows[] = {
      {"centre_x", "m", "centre of mass, aft of the origin", &Solid::centre_x, place},
      {"centre_y", "m", "centre of mass, outward of it", &Solid::centre_y, place},
      {"centre_z", "m", "centre of mass, above it", &Solid::centre_z, place},
      {"float_x", "m", "centre of volume, aft of the origin", &Solid::float_x, place},
      {"float_y", "m", "centre of volume, outward of it", &Solid::float_y, place},
      {"float_z", "m", "centre of volume, above it", &Solid::float_z, place},
      {"inertia_x", "kg m2", "moment of inertia about an axis through the centre of mass along x",
       &Solid::inertia_x, amount},
      {"inertia_y", "kg m2", "about one along y", &Solid::inertia_y, amount},
      {"inertia_z", "kg m2", "about one along z", &Solid::inertia_z, amount},
      {"added_x", "kg", "added mass of motion along x", &Solid::added_x, amount},
      {"added_y", "kg", "added mass of motion along y", &Solid::added_y, amount},
      {"added_z", "kg", "added mass of motion along z", &Solid::added_z, amount},
      {"turning_x", "kg m2", "added inertia of turning about x", &Solid::turning_x, amount},
      {"turning_y", "kg m2", "added inertia of turning about y", &Solid::turning_y, amount},
      {"turning_z", "kg m2", "added inertia of turning about z", &Solid::turning_z, amount},
  };
  for (const Row& row : rows)
    e.real(name(row.name), static_cast<double P::*>(row.member), row.unit, row.doc, row.range);
  e.data("side", static_cast<double E::Data::*>(&Sided::side), "1", "1, or -1 where it is mirrored");
  const char* needs = names.emplace_back(prefix + "mass " + prefix + "volume").c_str();
  e.template term<Weight, needs_gravity | is_weight>("weight", "weight less buoyancy", needs);
  e.template term<Inertia, reads_velocity | reads_acceleration | needs_motion>(
      "inertia", "of its mass and of the water that moves with it");
}

}  // namespace netloft::solids
