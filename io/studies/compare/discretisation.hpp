// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/division.hpp"
#include "io/studies/compare/places.hpp"
#include "io/studies/compare/richardson.hpp"
#include "io/studies/compare/timed_trial.hpp"

namespace netloft::studies {

/// The answer on one mesh, and the distance of this answer from the extrapolated limit, or from the answer on
/// the finest mesh if there is no limit.
struct MeshResult {
  std::int64_t cells = 0;
  std::size_t unknowns = 0;
  Trial trial;
  double error = std::numeric_limits<double>::quiet_NaN();  // largest distance of a node [m]
  double order = std::numeric_limits<double>::quiet_NaN();  // order on this and the two coarser meshes
};

/// The error caused by dividing a gear into cells, without the error of the solver.
struct Discretisation {
  std::string part;  // name of the part whose cells are counted
  std::vector<MeshResult> levels;
  double order = std::numeric_limits<double>::quiet_NaN();  // order on the three finest meshes
  // Whether the observed orders agree. If not, errors are distances from the answer on the finest mesh, whose
  // own error is unknown.
  bool steady = false;
};

/// Solves the scene on every mesh, and extrapolates the position of each node from the two finest meshes. The
/// order of convergence is observed on the nodes that the three finest meshes have in common, from mean
/// distances over these nodes, because corners converge more slowly than other places.
Discretisation find_discretisation_error(const runs::CaseSource& source, Registry& registry,
                                         const Method& method, const std::string& part,
                                         const std::vector<MeshLevel>& levels, const runs::Watch& watch);

/// Sets the errors and orders in `result`. `places` has the positions of nodes on each mesh, the coarsest
/// first.
void judge_meshes(const std::vector<Places>& places, Discretisation& result);

}  // namespace netloft::studies
