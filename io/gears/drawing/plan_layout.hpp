// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/outline.hpp"

#include <vector>

namespace netloft::gears {

/// The position of the outline of a panel on the sheet. A plan is drawn with the stretched length along the
/// gear and half of the stretched width across (ISO 3169), which is the width at a hanging ratio of 0.5.
struct PlacedPanel {
  const Panel* panel = nullptr;
  Outline outline;
  double x = 0, y = 0;  // position of the outline's origin [m on the net]; x to starboard, y aft
  bool is_mirrored = false;

  /// The position of a point of the outline on the sheet [m on the net].
  PanelPoint on_sheet(PanelPoint p) const;
};

/// Places the panels of a plan on the sheet. Panels that are sewn in a row follow one another in a column;
/// columns are side by side. A panel of a pair is beside the part of the edge to which it is sewn. Middle
/// panels and pairs are placed twice, the second time mirrored.
std::vector<PlacedPanel> lay_out(const NetPlan& plan);

}  // namespace netloft::gears
