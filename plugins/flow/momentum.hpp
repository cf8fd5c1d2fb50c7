// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>
#include <cmath>

namespace netloft::flows {

/// Water that a bag of netting slows, by the balance of momentum of an actuator disc that spans its mouth.
/// The elements are the bars along the rim of the mouth, in the order of a closed curve that runs
/// counter-clockwise if the water flows towards the viewer. All bars share the induction factor a:
///   w = U − s a U + s a (κ n − c² U)/(1 + c)     velocity of the water at the netting               (1)
///   κ = U·n,  c = |κ|/‖U‖ = cos θ
///   Σ C_T(a) ½ ρ V² (V ΔA) − Σ U·F = 0           thrust of the disc = drag of the net, times V       (2)
///   C_T = 4a (1 − a)  if a ≤ 0.4,  else 8/9 − 4a/9 + 14a²/9                                        (3)
///   V ΔA = ½ (η₀ + η₁)(z₁ − z₀),  η = U_x y − U_y x   share of a bar in the area of the mouth, times V  (4)
/// U [m/s] is the undisturbed velocity, V that at the bar, s the reach of the bag (1 behind the mouth, 0 in
/// free water), n the normal of the netting (0 on ropes), F [N] the drag of the net at a corner, which the
/// host computes with w. In (1) the water loses the fraction a along the current, and is turned aside across
/// it such that it passes the netting with κ (1 − a c): it leaves a long bag as fast as it enters. In a
/// uniform current, (2) divided by V is the balance of thrust and drag along the current; with the factor V,
/// it is regular in still water. By Green's theorem, the sum of V³ ΔA over the rim is the integral of V³ over
/// the mouth, also if the current changes with depth. In half a gear, the rim ends in the plane of symmetry y
/// = 0, which adds nothing to the area; both sides of (2) are then halves. The wings and ropes ahead of the
/// mouth are in undisturbed water, but (2) includes their drag, too. Sources: for (1), (2), and (3) up to a =
/// 0.4, H. Glauert, Airplane propellers, in: W. F. Durand (ed.), Aerodynamic Theory IV, 1935; for (3) beyond
/// a = 0.4, the empirical branch of M. L. Buhl, A new empirical relationship between thrust coefficient and
/// induction factor for the turbulent windmill state, NREL/TP-500-36834, 2005, without tip losses. Both have
/// the same value and slope at a = 0.4. For the second part of (1), the speed 1 − a c of the water inside
/// cones of the angle c = sin of half the cone, by the pressure of their drag (tests/verification/README.md).
/// Range: steady towing.
struct Momentum {
  static constexpr auto stencil = NETLOFT_BAR;
  static constexpr int globals = 1;  // shared unknown: a
  struct Parameters {
    double start = 0;  // initial guess of a
  };
  struct Data {};
  static constexpr double kStill = 1e-12;  // keeps c regular in still water [m/s]

  static double start(const Parameters& p, const Family<Momentum>::None&) { return p.start; }

  template <class T>
  static Vec3<T> water(const Parameters&, const Vec3<T>& current, const std::array<T, 1>& a, double reach,
                       const Vec3<T>& normal) {
    using std::abs;
    const T lost = reach * a[0], across = dot(current, normal),
            c = abs(across) * (1.0 / (norm(current) + kStill));
    return (1.0 - lost) * current +
           (lost * (1.0 / (1.0 + c))) * (across * normal - (c * c) * current);  // (1)
  }
  template <class T>
  static Vec3<T> weight(const Parameters&, const Vec3<T>& current, double, int) {
    return current;  // U of (2)
  }
  template <class T>
  static T thrust(const T& a) {  // (3)
    if (a < T(0.4)) return 4.0 * a * (1.0 - a);
    return 8.0 / 9 + a * (-4.0 / 9 + (14.0 / 9) * a);
  }
  /// V ΔA of (4) for a bar in the current U [m3/s].
  template <class T>
  static T flux(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& U) {
    const auto across = [&](const Vec3<T>& x) { return U.x * x.y - U.y * x.x; };
    return 0.5 * (across(from) + across(to)) * (to.z - from.z);
  }
  /// ΔA of (4) [m2].
  static double area(const State<3>& s) {
    const Vec3<double> U = 0.5 * (s.current[0] + s.current[1]);
    const double speed = std::hypot(U.x, U.y);
    return speed > 0 ? flux(s.x[0], s.x[1], U) / speed : 0;
  }

  struct Thrust {
    template <class T>
    static Points<T, 3> force(const Parameters&, const Data&, const MovingNodes<T, 3>& m) {
      const Vec3<T> U = 0.5 * (m.current[0] + m.current[1]);
      const T q = (0.5 * m.water.density) * (U.x * U.x + U.y * U.y);
      Points<T, 3> out{};
      out[2].x = -(thrust(m.x[2].x) * q * flux(m.x[0], m.x[1], U));  // minus the residual (2)
      return out;
    }
  };
};

}  // namespace netloft::flows
