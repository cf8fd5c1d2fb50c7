// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace netloft {

/// How a winch runs from a time on.
struct WinchStage {
  enum class Follows { tension, speed, length };
  Follows follows = Follows::tension;
  double from = 0;  // [s]
  /// t [s], and the tension wanted at the block [N], as at the last row beyond it; or the speed at which rope
  /// is paid out [m/s], none beyond the last row; or how much more rope is out than at the start [m], as at
  /// the last row beyond it. Straight between rows.
  std::vector<std::array<double, 2>> rows = {};
  // Of one that follows a tension:
  double max_speed = 0;  // of rope that is paid out or hauled [m/s]
  double band = 0;       // beyond the dead band, deviation at which it runs as fast as it can [N]
  double dead_band = 0;  // deviation at which it still stands [N]
};

/// A rope that runs over a winch while the scene moves (problem/winches.hpp).
struct Winch {
  std::string part;                     // the rope
  std::string parameter;                // of it, a table in time of what its lengths are multiplied by
  std::uint32_t block = 0;              // node of the scene, held along all axes
  double length = 0;                    // of the rope where that factor is one [m]
  std::vector<WinchStage> stages = {};  // one after the other; the first from the start on
};

}  // namespace netloft
