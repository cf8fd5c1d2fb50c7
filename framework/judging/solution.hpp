// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/cost.hpp"

namespace netloft {

/// Another equilibrium of the gear that was found besides the solution and is not unstable.
struct OtherShape {
  double energy = 0;           // [J]
  double distance = 0;         // largest distance of a node from its position in the solution [m]
  std::string furthest;        // name of that node
  int times = 1;               // number of restarts that found it
  std::vector<double> x = {};  // positions over all dofs
};

/// Result of the search for other equilibria, and the rule by which the solution was chosen
/// (framework/search/shapes.hpp).
struct Shapes {
  bool by_energy = false;  // whether the solution is the equilibrium of least energy, not the first one found
  int restarts = 0, times = 1;  // `times`: how often the solution was found, at least 1
  std::vector<OtherShape> others;
};

/// The record of a solver's run, without its final point.
struct SolverRun {
  Stop stop = Stop::none;  // why the host stopped it
  std::vector<IterationRecord> history;
  std::string factorisation = "none";  // description of the last factorisation, for reports
};

/// The final point of a solver, its assessment and its cost.
struct Solution : Assessment {
  std::vector<double> u;  // displacements of the unknowns; x are the positions
  SolverRun run;
  Cost cost;
  bool does_not_settle = false;  // whether the path of the solver exceeded Limits::path, or motions did not
                                 // come to rest
  Shapes shapes;
  // The factors found for the settings of the scene (search/settings.hpp), such as the length of a rope that
  // must bear a given force.
  std::vector<double> factors;
  std::vector<std::string> diagnostics;  // possible reasons why the solver did not converge
};

}  // namespace netloft
