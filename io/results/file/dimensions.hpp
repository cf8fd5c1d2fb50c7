// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_result.hpp"

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
std::vector<Dimension> dimensions_of(const StoredResult& result);

/// Where an end is, among the positions of a state, 3 per node [m]; `other` is the line's first end.
std::array<double, 3> place_of(const DimensionEnd& end, const StoredResult& result,
                               const std::vector<double>& points, const std::array<double, 3>& other);

}  // namespace netloft::results
