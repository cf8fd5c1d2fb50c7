// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/holder.hpp"

namespace netloft::scenes {

/// The holds of a whole gear. Each hold should have a mirror image, because a gear that is held on one side
/// only is towed askew.
class OneSidedHolds {
 public:
  void add(const HoldEntry& entry, const formats::Place& place) {
    for (const std::string& on : entry.on) holds_.push_back({on, entry.axes, place});
  }
  /// Warns of holds whose mirror image exists but is not held along the same axes.
  void report(Draft& draft, formats::Diagnostics& diagnostics) const;

 private:
  struct Held {
    std::string on;
    std::uint8_t axes;
    formats::Place place;
  };
  std::vector<Held> holds_;
};

/// The name of the mirror image of a part, an edge or a point: "port-bridle.start" for
/// "starboard-bridle.start". Returns a name without a side ("port-", "starboard-") unchanged.
std::string mirror_image(const std::string& name);

}  // namespace netloft::scenes
