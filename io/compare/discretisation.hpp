// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/compare/division.hpp"
#include "io/compare/places.hpp"
#include "io/compare/richardson.hpp"
#include "io/compare/trial.hpp"

namespace netloft::io {

/// One division of the gear and how far it is from the finest, or from what they all tend to.
struct MeshResult {
  std::int64_t cells = 0;
  std::size_t unknowns = 0;
  Trial trial;
  double error = std::numeric_limits<double>::quiet_NaN();  // largest node distance to the extrapolation [m]
  double order = std::numeric_limits<double>::quiet_NaN();  // of this level and the two before it
};

/// The error of dividing a gear into cells, apart from that of solving for its nodes.
struct Discretisation {
  std::string part;  // whose cells are counted
  std::vector<MeshResult> levels;
  double order = std::numeric_limits<double>::quiet_NaN();  // observed on the three finest levels
  bool steady = false;  // orders agree; if not, errors are distances to the finest level, which has none
};

/// Solves every level and extrapolates node by node from the two finest, with the order observed on the nodes
/// that the three finest have in common (mean over nodes, for corners alone converge slower).
Discretisation find_discretisation_error(const CaseSource& source, Registry& registry, const Method& method,
                                         const std::string& part, const std::vector<MeshLevel>& levels,
                                         const Watch& watch);

/// The same from places of nodes on rising numbers of cells; what find_discretisation_error does with them.
void judge_meshes(const std::vector<Places>& places, Discretisation& result);

}  // namespace netloft::io
