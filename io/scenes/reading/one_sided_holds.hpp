// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/holder.hpp"

namespace netloft::scenes {

/// Holds of a whole gear, each of which wants its mirror image: a gear that is held on one side is towed
/// askew.
class OneSidedHolds {
 public:
  void add(const HoldEntry& entry, const formats::Place& place) {
    for (const std::string& on : entry.on) holds_.push_back({on, entry.axes, place});
  }
  /// Warns of those whose mirror image is there and is not held alike.
  void report(Draft& draft, formats::Diagnostics& diagnostics) const;

 private:
  struct Held {
    std::string on;
    std::uint8_t axes;
    formats::Place place;
  };
  std::vector<Held> holds_;
};

/// The name of the mirror image of a part, an edge or a point: "port-bridle.start" of
/// "starboard-bridle.start". The same name where nothing in it speaks of a side.
std::string mirror_image(const std::string& name);

}  // namespace netloft::scenes
