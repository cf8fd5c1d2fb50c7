// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

namespace netloft::gears {

inline constexpr double kMostNodes = 5e6;  // largest number of nodes of a gear

/// The factor by which the triangle sides of a panel are shorter than elsewhere.
double finer(const Fineness& fineness, const GearPanel& panel);

/// The element size h [m] that gives about N nodes. A [m²] is the area of the half-open netting, divided into
/// equilateral triangles; L [m] is the length of the ropes; 1.2 is an empirical factor for nodes that the
/// mesher adds:
///   N = 1.2 · 2 A/(√3 h²) + L/h                                                                        (1)
/// (1) is only a first guess, because lines that are divided more finely than h have more nodes.
double size_for(const Gear& gear, const Fineness& fineness);

/// The shortest bar of all panels [m]. If every knot is a node, it is the size of all other elements.
double shortest_bar(const Gear& gear);

/// Throw std::invalid_argument, with a sentence for the user, for a mesh of more than kMostNodes nodes.
void check_knots(const Gear& gear);
void check_size(const Gear& gear, const Fineness& fineness);

}  // namespace netloft::gears
