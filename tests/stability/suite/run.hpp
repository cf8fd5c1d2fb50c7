// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "tests/stability/suite/references.hpp"

#include <functional>

namespace netloft::hard_cases {

/// One case, one size, one column: what became of it.
struct Cell {
  std::string name, size, solver;
  Expected expected = Expected::stable;
  std::size_t unknowns = 0;
  Verdict verdict;
  bool confirmed = true;  // if it is an answer, another solver knows a stable equilibrium of the case, too
  std::string status, stability, reason;
  int iterations = 0, factorisations = 0;
  double cpu_seconds = 0, energy = 0;
  std::vector<StageRecord> stages;       // what was solved on the way, if it was not solved at once
  Shapes shapes;                         // those that the solver was told to look for
  std::vector<IterationRecord> history;  // some of it: the first, the last, and some between
};

/// All solvers on one case at one size.
struct Row {
  const HardCase* about = nullptr;
  std::string size;
  std::vector<Cell> cells;
  std::size_t shapes = 0;  // stable shapes that were found, told apart by energy and place
};

struct RunOptions {
  std::vector<std::string> sizes;  // of kSizes
  std::string pattern;             // only cases whose name contains it
  double seconds = 0;              // for one case; 0: 10, of large ones 60
  double work = 0;                 // the same in iterations of Newton's method for the scene; 0: any
  int threads = 1;
  bool update = false;  // the book of references
  runs::Watch watch;
  std::function<void(const Row&)> on_row;
};

/// Runs the suite, case by case; an interrupt ends it after the case at hand, which is left out.
std::vector<Row> run_suite(const Suite& suite, const std::vector<Column>& columns, References& references,
                           Registry& registry, const RunOptions& options);

}  // namespace netloft::hard_cases
