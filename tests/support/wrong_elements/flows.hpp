// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/wrong_elements/spring.hpp"

namespace netloft::wrong {

/// A correct flow: the water in its reach loses the fraction a of its velocity, and the thrust of a thin
/// wake, 4 a ½ ρ V² A, equals the drag in the reach. Each wrong flow has one flaw.
struct RightFlow {
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach) {
    return (1.0 - reach * a) * current;
  }
  template <class T>
  static Vec3<T> weight(const Vec3<T>& current, double reach) {
    return reach * current;
  }
  /// Minus the residual of a bar, with the flux V ΔA through its share of the mouth.
  template <class T>
  static T thrust(const T& a, double density, const Vec3<T>& current, const T& flux) {
    return -(2 * density) * a * dot(current, current) * flux;
  }
  template <class T>
  static T flux(const Vec3<T>& current, const Vec3<T>& from, const Vec3<T>& to) {
    const auto across = [&](const Vec3<T>& x) { return current.x * x.y - current.y * x.x; };
    return 0.5 * (across(from) + across(to)) * (to.z - from.z);
  }
};

struct LosesHalfTheMomentum : RightFlow {
  template <class T>
  static T thrust(const T& a, double density, const Vec3<T>& current, const T& flux) {
    return 0.5 * RightFlow::thrust(a, density, current, flux);
  }
};

struct FacesEast : RightFlow {  // the area of a mouth across x, whatever the direction of the current
  template <class T>
  static T flux(const Vec3<T>& current, const Vec3<T>& from, const Vec3<T>& to) {
    return 0.5 * current.x * (from.y + to.y) * (to.z - from.z);
  }
};

struct CountsBars : RightFlow {  // each bar adds a force, however short it is
  template <class T>
  static T thrust(const T& a, double density, const Vec3<T>& current, const T& flux) {
    return RightFlow::thrust(a, density, current, flux) - (100 * a) * a;
  }
};

struct RisesInStillWater : RightFlow {
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach) {
    return (1.0 - reach * a) * current + Vec3<T>{T(0), T(0), 0.1 * reach * a};
  }
};

struct SlowsEverywhere : RightFlow {
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double) {
    return (1.0 - a) * current;
  }
};

struct SlowsInSteps : RightFlow {  // the velocity follows from the rounded unknown, which has no derivative
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach) {
    T rounded = a;
    if constexpr (requires { rounded.value; }) rounded.value = std::round(1e3 * rounded.value) / 1e3;
    return (1.0 - reach * rounded) * current;
  }
};

struct SlowsTheNorth : RightFlow {
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach) {
    return {current.x, (1.0 - reach * a) * current.y, current.z};
  }
};

struct TakesSides : RightFlow {  // the velocity depends on the sign of the normal
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach, const Vec3<T>& normal) {
    return (1.0 - reach * a) * current + (reach * a) * normal;
  }
};

/// The element of a flow on two nodes.
template <class Flow>
struct FlowOn {
  static constexpr auto stencil = NETLOFT_BAR;
  static constexpr int globals = 1;
  using Parameters = wrong::Parameters;
  using Data = wrong::Data;
  template <class T>
  static Vec3<T> water(const Parameters&, const Vec3<T>& current, const std::array<T, 1>& a, double reach,
                       const Vec3<T>& normal) {
    if constexpr (requires { Flow::water(current, a[0], reach, normal); })
      return Flow::water(current, a[0], reach, normal);
    else
      return Flow::water(current, a[0], reach);
  }
  template <class T>
  static Vec3<T> weight(const Parameters&, const Vec3<T>& current, double reach, int) {
    return Flow::weight(current, reach);
  }
  static double start(const Parameters&, const typename Family<FlowOn>::Whole&) { return 0; }
  struct Thrust {
    template <class T>
    static Points<T, 3> force(const Parameters&, const Data&, const MovingNodes<T, 3>& m) {
      const Vec3<T> current = 0.5 * (m.current[0] + m.current[1]);
      Points<T, 3> out{};
      out[2].x = Flow::thrust(m.x[2].x, m.water.density, current, Flow::flux(current, m.x[0], m.x[1]));
      return out;
    }
  };
};

}  // namespace netloft::wrong
