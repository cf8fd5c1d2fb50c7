// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cloths.hpp"
#include "io/gears/meshing/triangulation.hpp"

namespace netloft::gears {

/// The knots of a panel that lie within a border, in the spread plane (spread() in cloths.hpp): all points
/// with whole numbers of both twine coordinates, row by row. Those that are nearer to the border than a third
/// of a bar are left out; the nodes of the border replace them. `sign`: of x in the outline, -1 for the port
/// half of a middle panel.
std::vector<PlanePoint> knots_within(const Panel& panel, double sign, const std::vector<PlanePoint>& border);

/// The number of knots along a straight line of a panel, from one point to another: of the twines that it
/// crosses, those of the direction of which it crosses most.
double knots_along(const Panel& panel, double sign, const PanelPoint& from, const PanelPoint& to);

}  // namespace netloft::gears
