// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/law.hpp>

/// Drag per metre of a twine, by the square of the flow U across it:
///   U = W − (W·t) t,   F = ½ ρ C D |U| U                                 (1)
/// W [m/s] velocity of the water relative to the twine, t unit vector along it, D [m] diameter, C [1].
/// |U| is smoothed within 1e-12 m/s of zero, where it has no derivative.
struct MyLaw {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  struct Parameters {
    double coefficient = 0;
  };
  template <class T>
  static netloft::Vec3<T> force(const Parameters& p, const netloft::Flow<T>& f) {
    using std::sqrt;
    const netloft::Vec3<T> U = f.flow - dot(f.flow, f.direction) * f.direction;
    const T speed = sqrt(dot(U, U) + T(1e-24));
    return (0.5 * f.density * p.coefficient * f.diameter) * (speed * U);  // (1)
  }
};

NETLOFT_PLUGIN("my_law", "0.1", "Drag of twines") {
  auto& law = plugin.law<MyLaw>("my_law", "Drag across a twine, by the square of the speed");
  law.real("coefficient", &MyLaw::Parameters::coefficient, "1", "drag coefficient on the diameter",
           {.lo = 0, .hi = 10, .fallback = 1.2});
}
