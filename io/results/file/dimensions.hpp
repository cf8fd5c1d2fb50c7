// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace netloft::results {

/// An end of a dimension line: a node, the mirror image of a node, or the point of the bed below the other
/// end of the line.
struct DimensionEnd {
  enum class Where : std::uint8_t { node, mirrored, bed } where = Where::node;
  std::uint32_t node = 0;
};

/// A dimension line: a length drawn beside the gear between two points that move with it.
struct Dimension {
  std::string name;
  DimensionEnd from, to;
};

/// The dimension lines of a gear: height of the headline, and spreads of wings, bodies and towing points,
/// between the points that define these figures (io/results/figures/gear_figures.hpp). A line is left out if
/// the gear lacks one of its two end points.
std::vector<Dimension> dimensions_of(const StoredShape& stored);

/// The position of an end of a dimension line [m]. `points` are the node positions of a state, 3 per node;
/// `other` is the position of the first end of the line.
std::array<double, 3> place_of(const DimensionEnd& end, const StoredShape& stored,
                               const std::vector<double>& points, const std::array<double, 3>& other);

}  // namespace netloft::results
