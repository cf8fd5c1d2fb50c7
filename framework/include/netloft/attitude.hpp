// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/rotation.hpp>

#include <algorithm>

namespace netloft {

/// The rotation of a body, in three angles [rad]. The axes of the body are x aft, y outward and z up. Without
/// rotation, they are the axes of the scene, in which the gear is towed in the direction −x. The argument
/// `side` of the functions below is 1 if outward is starboard (+y), and -1 if it is port.
///   heading   turns the nose outward: the angle of attack of an upright board in water that flows along x
///   heel      turns the top outward
///   trim      turns the nose upward
/// The body is turned by the heel about the x axis, then by the trim about y, then by the heading about z:
///   R = R_z(−s heading) R_y(trim) R_x(−s heel),   s = side                                      (1)
/// If the trim is a right angle, heading and heel turn the body about the same axis, and only their sum or
/// difference can be determined.
struct Attitude {
  double heading = 0, heel = 0, trim = 0;
};

/// Returns the axes of a body with this rotation: the columns of the rotation matrix R in (1) above.
inline std::array<Vec3<double>, 3> axes_of(const Attitude& a, double side) {
  const Vec3<double> heel{-side * a.heel, 0, 0}, trim{0, a.trim, 0}, heading{0, 0, -side * a.heading};
  std::array<Vec3<double>, 3> axes{Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3<double>& axis : axes) axis = rotated(heading, rotated(trim, rotated(heel, axis)));
  return axes;
}

/// Returns the angles of (1) from the axes of a body.
inline Attitude attitude_of(const std::array<Vec3<double>, 3>& axes, double side) {
  const Vec3<double>& x = axes[0];
  return {side * std::atan2(-x.y, x.x), side * std::atan2(-axes[1].z, axes[2].z),
          std::asin(std::clamp(-x.z, -1.0, 1.0))};
}

}  // namespace netloft
