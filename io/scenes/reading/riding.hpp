// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::scenes {

/// Parts that stand on what is there already: floats along a headline, pressure on a cod-end, the seabed
/// under a footrope. They have no nodes of their own.

/// Metres of rope or twine that every node of the scene carries of one part: half of each bar it ends, a
/// third of the twines of each triangle. Zero elsewhere.
std::vector<double> carried_length(const Scene& scene, const Part& part, const ElementType& type);

/// One element on each of `nodes`. Data: `pieces`, the fraction of `number` that belongs to the node, in
/// proportion to the length that it carries (equal fractions if no node carries any); `length` [m] that it
/// carries.
void ride_on_nodes(const std::vector<std::uint32_t>& nodes, const std::vector<double>& carried, double number,
                   Part& rider);

/// One element on each of `nodes`, each of `pieces`, whatever the node carries: the datum `length` is zero.
void ride_on_every_node(const std::vector<std::uint32_t>& nodes, double pieces, Part& rider);

/// The bars of `rope` that have one of their ends among `nodes`, that end first, with their data.
void ride_on_bars_at(const Part& rope, const std::vector<std::uint32_t>& nodes, Part& rider);

/// A pair for every bar of `first` and bar of `second` that meet in a node, its nodes in the order of the way
/// from one to the other; data of bars, one of each.
void ride_on_meeting_bars(const Part& first, const Part& second, Part& rider);

/// The elements of another part, with their data.
void ride_on_elements(const Part& part, Part& rider);

}  // namespace netloft::scenes
