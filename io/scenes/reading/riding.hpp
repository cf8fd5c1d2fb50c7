// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/node_elements.hpp"

namespace netloft::scenes {

/// The functions below make the elements of riders, parts without nodes whose elements are on the nodes or
/// elements of other parts: floats along a headline, pressure on a cod-end, contact under a footrope.

/// The length of rope or twine of one part that a node of the scene represents [m]: half of each bar at the
/// node, a third of the twines of each triangle at the node; zero at nodes outside the part.
class CarriedLength {
 public:
  /// `part` must outlive this object.
  CarriedLength(const Part& part, const ElementType& type);
  /// `node` contains the elements of the part at the node.
  double at(std::span<const NodeElements::At> node) const;

 private:
  const std::vector<double>*rest_, *parallel_, *u_, *v_, *bar_;  // data of the elements; nullptr: absent
  int nodes_;                                                    // nodes of an element
};

/// Puts one element on each of `nodes`. `carried` contains, for each of these nodes, the length of rope or
/// twine that it represents. Data of the elements: `pieces`, the share of `number` that belongs to the node,
/// in proportion to this length (equal shares if all lengths are zero); `length`, this length [m].
void ride_on_nodes(const std::vector<std::uint32_t>& nodes, const std::vector<double>& carried, double number,
                   Part& rider);

/// Puts one element with `pieces` pieces on each of `nodes`, no matter which length the node represents; the
/// datum `length` is zero.
void ride_on_every_node(const std::vector<std::uint32_t>& nodes, double pieces, Part& rider);

/// Copies those bars of the rope with index `rope` that have exactly one end among `nodes`, with their data.
/// In a copy, this end is the first node.
void ride_on_bars_at(const Scene& scene, std::size_t rope, const NodeElements& elements,
                     const std::vector<std::uint32_t>& nodes, Part& rider);

/// Adds an element with three nodes for every pair of a bar of the rope `first` and a bar of the rope
/// `second` that share a node: the other end of the first bar, the shared node, and the other end of the
/// second bar. Each datum of bars has two values, one per bar.
void ride_on_meeting_bars(const Scene& scene, std::size_t first, std::size_t second,
                          const NodeElements& elements, Part& rider);

/// Copies the elements of another part with their data.
void ride_on_elements(const Part& part, Part& rider);

}  // namespace netloft::scenes
