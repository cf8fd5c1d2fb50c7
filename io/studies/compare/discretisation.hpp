// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/division.hpp"
#include "io/studies/compare/places.hpp"
#include "io/studies/compare/richardson.hpp"
#include "io/studies/compare/timed_trial.hpp"

namespace netloft::studies {

/// One division of the gear, and its distance from the extrapolated limit or from the finest mesh.
struct MeshResult {
  std::int64_t cells = 0;
  std::size_t unknowns = 0;
  Trial trial;
  double error = std::numeric_limits<double>::quiet_NaN();  // largest node distance to the extrapolation [m]
  double order = std::numeric_limits<double>::quiet_NaN();  // observed on this level and the two coarser ones
};

/// The error of dividing a gear into cells, separate from the error of solving for its nodes.
struct Discretisation {
  std::string part;  // the part whose cells are counted
  std::vector<MeshResult> levels;
  double order = std::numeric_limits<double>::quiet_NaN();  // observed on the three finest levels
  // whether the orders agree; if not, errors are distances to the finest level, which has no error
  bool steady = false;
};

/// Solves every level and extrapolates node by node from the two finest levels. The order is observed on the
/// common nodes of the three finest levels, from mean distances over these nodes, because corners alone
/// converge more slowly.
Discretisation find_discretisation_error(const runs::CaseSource& source, Registry& registry,
                                         const Method& method, const std::string& part,
                                         const std::vector<MeshLevel>& levels, const runs::Watch& watch);

/// Computes errors and orders of `result` from the positions of the nodes on meshes with increasing numbers
/// of cells. find_discretisation_error calls it with the solved levels.
void judge_meshes(const std::vector<Places>& places, Discretisation& result);

}  // namespace netloft::studies
