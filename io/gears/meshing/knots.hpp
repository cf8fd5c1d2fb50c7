// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/triangulation.hpp"

namespace netloft::gears {

/// The knots of a panel within a border, row by row, as positions in half-open netting (spread() in
/// cloths.hpp). Knots are the points whose coordinates along both twine directions are whole numbers. Knots
/// nearer to the border than a third of a bar are left out, because nodes of the border replace them. `sign`
/// is the sign of x in the outline, -1 for the port half of a middle panel.
std::vector<PlanePoint> knots_within(const Panel& panel, double sign, const std::vector<PlanePoint>& border);

/// The number of bars along a straight line between two points of a panel. It is counted along both twine
/// directions, and the larger count is returned.
double knots_along(const Panel& panel, double sign, const PanelPoint& from, const PanelPoint& to);

}  // namespace netloft::gears
