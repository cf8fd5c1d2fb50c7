// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/gear_links.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netloft::scenes::femnet {

GearLinks::GearLinks(const GearFile& gear, formats::Diagnostics& diagnostics) : gear_(gear) {
  for (const auto& panel : gear.panels) {
    panel_starts_.push_back(drawn_.size());
    for (const auto& corner : panel.corners) drawn_.push_back(corner.at);
  }
  for (const auto& cable : gear.cables) {
    cable_starts_.push_back(drawn_.size());
    for (const auto& end : cable.ends) drawn_.push_back(end.at);
  }
  leader_.resize(drawn_.size());
  std::iota(leader_.begin(), leader_.end(), std::size_t{0});
  for (const auto& link : gear.links) {
    const LinkPoint* first = nullptr;
    for (const auto& at : link) {
      if (!exists(at, diagnostics)) continue;
      if (first) connect(index(*first), index(at));
      first = &at;
    }
  }
  if (gear.link_distance > 0) connect_near();
}

bool GearLinks::exists(const LinkPoint& at, formats::Diagnostics& diagnostics) const {
  const std::size_t objects = at.is_panel ? gear_.panels.size() : gear_.cables.size();
  const char* what = at.is_panel ? "panel " : "cable ";
  if (at.object < 0 || static_cast<std::size_t>(at.object) >= objects) {
    diagnostics.error(
        at.place,
        "the link names " + std::string(what) + std::to_string(at.object + 1LL) + ", which does not exist",
        objects ? "they are numbered 1 to " + std::to_string(objects) : "there are none");
    return false;
  }
  const std::size_t corners =
      at.is_panel ? gear_.panels[static_cast<std::size_t>(at.object)].corners.size() : 2;
  if (at.corner >= 0 && static_cast<std::size_t>(at.corner) < corners) return true;
  diagnostics.error(at.place, "the link names corner " + std::to_string(at.corner + 1LL) + " of " + what +
                                  std::to_string(at.object + 1) + ", which has " + std::to_string(corners));
  return false;
}

std::size_t GearLinks::leader(std::size_t i) {
  while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
  return i;
}

void GearLinks::connect(std::size_t a, std::size_t b) {
  const auto [low, high] = std::minmax({leader(a), leader(b)});
  leader_[high] = low;
}

/// Connects points that are closer than the link distance. Points are sorted by x, so that only near ones
/// have to be compared.
void GearLinks::connect_near() {
  const double reach = gear_.link_distance;
  std::vector<std::size_t> order(drawn_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return drawn_[a][0] < drawn_[b][0]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Triple &a = drawn_[order[i]], &b = drawn_[order[k]];
      if (b[0] - a[0] >= reach) break;
      if (std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) < reach) connect(order[i], order[k]);
    }
}

}  // namespace netloft::scenes::femnet
