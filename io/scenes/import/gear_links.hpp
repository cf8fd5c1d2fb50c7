// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_gear.hpp"

namespace netloft::scenes::femnet {

/// Groups corners of panels and ends of cables that are the same point of the gear, because a link joins
/// them, or because their distance in the drawing is less than the link distance.
class GearLinks {
 public:
  /// A link to a corner or end that does not exist is an error at the place of the link.
  GearLinks(const GearFile& gear, formats::Diagnostics& diagnostics);

  /// The number of the point of a corner or end. Linked corners and ends have the same number.
  std::size_t point(const LinkPoint& at) { return leader(index(at)); }

 private:
  std::size_t index(const LinkPoint& at) const {
    return (at.is_panel ? panel_starts_ : cable_starts_)[static_cast<std::size_t>(at.object)] +
           static_cast<std::size_t>(at.corner);
  }
  std::size_t leader(std::size_t i);
  void connect(std::size_t a, std::size_t b);
  bool exists(const LinkPoint& at, formats::Diagnostics& diagnostics) const;
  void connect_near();

  const GearFile& gear_;
  std::vector<std::size_t> panel_starts_, cable_starts_, leader_;
  std::vector<Triple> drawn_;
};

}  // namespace netloft::scenes::femnet
