// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/element.hpp>

/// Water that a thin net slows. The elements are the bars along the rim of the mouth; they share the fraction
/// a of the speed that the water loses at the net. Far behind, it has lost 2 a (momentum of a thin wake):
///   w = U (1 − s a)                                 velocity in reach s of the net               (1)
///   Σ 4 a ½ ρ V² (V ΔA) − Σ U·F = 0                  thrust of the mouth = drag F, times V         (2)
///   V ΔA = ½ (η₀ + η₁)(z₁ − z₀),  η = U_x y − U_y x   share of a bar in the area, times V            (3)
/// U [m/s] undisturbed velocity, V that at the bar.
struct MyFlow {
  static constexpr auto stencil = NETLOFT_BAR;
  static constexpr int globals = 1;  // one unknown: a
  struct Parameters {
    double start = 0;
  };
  struct Data {};
  static double first(const Parameters& p, const netloft::Family<MyFlow>::None&) { return p.start; }

  template <class T>
  static netloft::Vec3<T> water(const Parameters&, const netloft::Vec3<T>& U, const std::array<T, 1>& a,
                                double reach, const netloft::Vec3<T>& /*normal*/) {
    return (1.0 - reach * a[0]) * U;  // (1)
  }
  template <class T>
  static netloft::Vec3<T> weight(const Parameters&, const netloft::Vec3<T>& U, double /*reach*/, int) {
    return U;  // the weight of F in (2); the host adds F itself
  }
  struct Thrust {  // the rest of (2)
    template <class T>
    static netloft::Points<T, 3> force(const Parameters&, const Data&, const netloft::MovingNodes<T, 3>& m) {
      const netloft::Vec3<T> U = 0.5 * (m.current[0] + m.current[1]);
      const auto eta = [&](const netloft::Vec3<T>& x) { return U.x * x.y - U.y * x.x; };
      const T flux = 0.5 * (eta(m.x[0]) + eta(m.x[1])) * (m.x[1].z - m.x[0].z);  // (3)
      netloft::Points<T, 3> out{};
      out[2].x = -(2.0 * m.water.density) * m.x[2].x * (U.x * U.x + U.y * U.y) * flux;  // minus the residual
      return out;
    }
  };
};

NETLOFT_PLUGIN("my_flow", "0.1", "Water that a thin net slows") {
  auto& f = plugin.element<MyFlow>("my_flow", "Water that a thin net slows");
  f.real("start", &MyFlow::Parameters::start, "1", "initial guess of the fraction",
         {.lo = 0, .hi = 1, .fallback = 0});
  f.global("slowed", "1", "fraction of the speed that the water loses", nullptr, MyFlow::first);
  f.term<MyFlow::Thrust, netloft::from_outside | netloft::needs_flow | netloft::reads_current>(
      "thrust", "thrust of the mouth");
  f.output("slowed", "1", "fraction of the speed that the water loses",
           [](auto&, auto&, auto& s) { return s.x[2].x; });
}
