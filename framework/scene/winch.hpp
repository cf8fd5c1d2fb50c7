// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace netloft {

/// The control of a winch from a given time on.
struct WinchStage {
  enum class Follows { tension, speed, length };
  Follows follows = Follows::tension;
  double from = 0;  // [s]
  /// Rows of a time t [s] and a value of the quantity that the winch follows: the tension at the block [N],
  /// the speed at which rope is paid out [m/s], or the length of rope paid out since the start [m]. Values
  /// are linear between rows. After the last row, the last tension or length holds, and the speed is zero.
  std::vector<std::array<double, 2>> rows = {};
  // For a winch that follows a tension:
  double max_speed = 0;  // largest speed of paying out or hauling in [m/s]
  double band = 0;       // deviation beyond the dead band at which the winch reaches max_speed [N]
  double dead_band = 0;  // largest deviation at which the winch is at rest [N]
};

/// A rope on a winch in a moving scene (framework/motion/winches.hpp).
struct Winch {
  std::string part;         // name of the rope's part
  std::string parameter;    // parameter of the rope for the factor on its length, a table over time
  std::uint32_t block = 0;  // node of the scene, held along all axes
  double length = 0;        // length of the rope at a factor of one [m]
  std::vector<WinchStage> stages = {};  // stages in order of time; the first begins at the start
};

}  // namespace netloft
