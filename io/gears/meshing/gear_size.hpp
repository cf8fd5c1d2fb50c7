// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

namespace netloft::gears {

inline constexpr double kMostNodes = 5e6;  // of a gear

/// The factor by which edges of a panel are shorter than elsewhere.
double finer(const Fineness& fineness, const GearPanel& panel);

/// The size h for a number N of nodes, from the area A of netting in equal triangles, a factor for the nodes
/// that the mesher adds, and the length L of ropes:
///   N = 1.2 · 2 A/(√3 h²) + L/h                                                                        (1)
/// The first guess, which lines that are finer than h then correct.
double size_for(const Gear& gear, const Fineness& fineness);

/// The shortest bar, for whatever is divided by length, where every knot is a node.
double shortest_bar(const Gear& gear);

/// Throw std::invalid_argument, with a sentence for the user, where there would be millions of nodes.
void check_knots(const Gear& gear);
void check_size(const Gear& gear, const Fineness& fineness);

}  // namespace netloft::gears
