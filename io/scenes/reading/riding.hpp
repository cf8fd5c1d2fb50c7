// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::scenes {

/// The functions below make the elements of riders, parts that stand on other parts: floats along a headline,
/// pressure on a cod-end, the seabed under a footrope. Riders have no nodes of their own.

/// The length of rope or twine of one part that each node of the scene carries [m]: half of each of its bars,
/// a third of the twines of each of its triangles; zero at nodes outside the part.
std::vector<double> carried_length(const Scene& scene, const Part& part, const ElementType& type);

/// Puts one element on each of `nodes`. Data: `pieces`, the fraction of `number` that belongs to the node, in
/// proportion to the length that it carries (equal fractions if no node carries any); `length`, the length
/// that it carries [m].
void ride_on_nodes(const std::vector<std::uint32_t>& nodes, const std::vector<double>& carried, double number,
                   Part& rider);

/// Puts one element with `pieces` pieces on each of `nodes`, independent of the length that the node carries:
/// the datum `length` is zero.
void ride_on_every_node(const std::vector<std::uint32_t>& nodes, double pieces, Part& rider);

/// Copies the bars of `rope` that have exactly one end among `nodes`, with that end first, and their data.
void ride_on_bars_at(const Part& rope, const std::vector<std::uint32_t>& nodes, Part& rider);

/// Adds an element for every bar of `first` and bar of `second` that share a node: its nodes are the free end
/// of the first bar, the shared node, and the free end of the second. Each datum of bars has two values, one
/// per bar.
void ride_on_meeting_bars(const Part& first, const Part& second, Part& rider);

/// Copies the elements of another part with their data.
void ride_on_elements(const Part& part, Part& rider);

}  // namespace netloft::scenes
