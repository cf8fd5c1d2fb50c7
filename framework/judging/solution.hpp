// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/cost.hpp"

namespace netloft {

/// Another place where the gear is in equilibrium that is not unstable.
struct OtherShape {
  double energy = 0;           // [J]
  double distance = 0;         // of its furthest node from where the solution has it [m]
  std::string furthest;        // that node
  int times = 1;               // that it was found
  std::vector<double> x = {};  // positions over all dofs
};

/// What was found by looking for other shapes, and by which rule the solution was chosen among them
/// (framework/search/shapes.hpp).
struct Shapes {
  bool by_energy = false;       // the least; else the first that was found
  int restarts = 0, times = 1;  // that the solution was found, the first time included
  std::vector<OtherShape> others;
};

/// What a solver leaves besides the point where it ended.
struct SolverRun {
  Stop stop = Stop::none;  // why it was told to stop
  std::vector<IterationRecord> history;
  std::string factorisation = "none";  // that it used last, for people
};

/// Where a solver ended, what the host makes of it, and what it cost.
struct Solution : Assessment {
  std::vector<double> u;  // displacements of the unknowns that x stands for
  SolverRun run;
  Cost cost;
  bool does_not_settle = false;  // given up because it went on and on (Limits::path), or its motions were
  Shapes shapes;
  std::vector<double> factors;           // of the settings of the scene, at which this is its equilibrium
  std::vector<std::string> diagnostics;  // what may be why it did not converge, by whoever knows the parts
};

}  // namespace netloft
