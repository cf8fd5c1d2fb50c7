// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace netloft::results {

/// An end of a dimension line: a node, its mirror image, or the bed below the line's first end.
struct DimensionEnd {
  enum class Where : std::uint8_t { node, mirrored, bed } where = Where::node;
  std::uint32_t node = 0;
};

/// A length that is drawn beside the gear, between two points that move with the gear.
struct Dimension {
  std::string name;
  DimensionEnd from, to;
};

/// The height of the headline and the spreads of the wings, between the points that define these figures of
/// the gear (io/results/figures/gear_figures.hpp). Empty without a headline.
std::vector<Dimension> dimensions_of(const StoredShape& stored);

/// The position of a dimension's end [m], from the node positions of a state (3 per node). `other` is the
/// first end of the line.
std::array<double, 3> place_of(const DimensionEnd& end, const StoredShape& stored,
                               const std::vector<double>& points, const std::array<double, 3>& other);

}  // namespace netloft::results
