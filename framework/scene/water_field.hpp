// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

namespace netloft {

/// The water at a place and a time, beside the current.
struct WaterMotion {
  std::array<double, 3> velocity = {};      // [m/s]
  std::array<double, 3> acceleration = {};  // of the water that is there [m/s2]
  std::array<double, 3> velocity_dz = {};   // its velocity's derivative with z [1/s]
  double surface = 0;                       // height of the surface there [m]
};

/// Water that swings: what a scene in motion adds to its current. Elements see its velocity, its acceleration
/// and its surface at their nodes and know nothing else of it.
class WaterField {
 public:
  virtual ~WaterField() = default;
  virtual WaterMotion at(const std::array<double, 3>& place, double time) const = 0;
};

}  // namespace netloft
