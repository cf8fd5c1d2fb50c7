// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/wrong_elements/spring.hpp"

namespace netloft::wrong {

/// A correct flow: the water in its reach loses the fraction a of its velocity, such that EA a equals the
/// drag in the reach. Each wrong flow has one flaw.
struct RightFlow {
  template <class T>
  static Vec3<T> water(const Vec3<T>& current, const T& a, double reach) {
    return (1.0 - reach * a) * current;
  }
  template <class T>
  static Vec3<T> weight(const Vec3<T>& current, double reach) {
    return reach * current;
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
    static Status evaluate(const Parameters& p, const Data&, const State<3>& s, Local<3>& out) {
      out.force[2].x = p.EA * s.x[2].x;
      out.tangent[6][6] = s.cu * p.EA;
      return Status::ok;
    }
  };
};

}  // namespace netloft::wrong
