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

/// A length that is written beside the gear, between two places that move with it.
struct Dimension {
  std::string name;
  DimensionEnd from, to;
};

/// Height of the headline and the spreads of the wings, between the places that the figures of the gear are
/// measured between (io/results/figures/gear_figures.hpp). None without a headline.
std::vector<Dimension> dimensions_of(const StoredShape& stored);

/// The place of an end [m] by the positions of a state, 3 per node; `other` is the first end of the line.
std::array<double, 3> place_of(const DimensionEnd& end, const StoredShape& stored,
                               const std::vector<double>& points, const std::array<double, 3>& other);

}  // namespace netloft::results
