// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/outline.hpp"

#include <vector>

namespace netloft::gears {

/// The position of a panel's outline on the sheet. A plan is drawn to the scale of the stretched length going
/// aft, and of half the stretched width across (ISO 3169), as netting of a hanging ratio of 0.5 would lie.
struct PlacedPanel {
  const Panel* panel = nullptr;
  Outline outline;
  double x = 0, y = 0;  // of the outline's origin [m on the net], x to starboard, y aft
  bool is_mirrored = false;

  /// [m on the net]
  PanelPoint on_sheet(PanelPoint p) const;
};

/// Places panels one behind the other as they are sewn, pairs next to the part of the edge that they are sewn
/// to, and each such column beside the others. Middle panels and pairs are placed twice, the second time
/// mirrored.
std::vector<PlacedPanel> lay_out(const NetPlan& plan);

}  // namespace netloft::gears
