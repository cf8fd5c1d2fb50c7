// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

namespace netloft {

/// Drag coefficient of a smooth sphere, on its frontal area, as a function of Re = |W| D/ν through the drag
/// crisis:
///   C_d = 24/Re + 2.6 a/(1 + a^1.52) + 0.411 b^−7.94/(1 + b^−8) + 0.25 c/(1 + c)            (1)
///   a = Re/5, b = Re/2.63e5, c = Re/1e6
/// for Re < 1e6, and constant above. Source: F. A. Morrison, An Introduction to Fluid Mechanics, Cambridge
/// University Press 2013, and "Data correlation for drag coefficient for sphere", Michigan Technological
/// University 2016.
template <class T>
T sphere_drag(const T& reynolds) {
  using std::pow;
  const T Re = reynolds < T(1e6) ? reynolds : T(1e6);
  const T a = 0.2 * Re, b = (1 / 2.63e5) * Re, b4 = b * b * (b * b), c = 1e-6 * Re;
  const T a_power = std::pow(0.2, 1.52) * pow(Re, 1.52), b_power = std::pow(1 / 2.63e5, 0.06) * pow(Re, 0.06);
  return 24.0 / Re + 2.6 * a / (1.0 + a_power) + 0.411 * b_power / (b4 * b4 + 1.0) +
         0.25 * c / (1.0 + c);  // b^−7.94/(1 + b^−8)
}

/// Returns Re C_d, which remains finite at rest. Below Re = 1e-3, it is 24 (Stokes' law) with a relative
/// error of at most 1e-7.
template <class T>
T sphere_phi(const T& Re) {
  return Re < T(1e-3) ? T(24) : Re * sphere_drag(Re);
}

}  // namespace netloft
