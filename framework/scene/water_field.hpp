// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace netloft {

/// The motion of the water at a place and a time, in addition to the current.
struct WaterMotion {
  std::array<double, 3> velocity = {};      // [m/s]
  std::array<double, 3> acceleration = {};  // acceleration of the water particle [m/s2]
  std::array<double, 3> velocity_dz = {};   // derivative of the velocity with respect to z [1/s]
  double surface = 0;                       // height of the surface there [m]
};

/// Water motion that a moving scene adds to its current, such as waves. Elements use its velocity,
/// acceleration and surface at their nodes only.
class WaterField {
 public:
  virtual ~WaterField() = default;
  virtual WaterMotion at(const std::array<double, 3>& place, double time) const = 0;
};

}  // namespace netloft
