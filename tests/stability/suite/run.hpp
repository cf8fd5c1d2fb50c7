// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "tests/stability/suite/references.hpp"

#include <functional>
#include <optional>

namespace netloft::hard_cases {

/// The result of one case at one size in one column.
struct Cell {
  std::string name, size, solver;
  Expected expected = Expected::stable;
  std::size_t unknowns = 0;
  Verdict verdict;
  bool confirmed = true;  // false: no solver but this one has found a stable equilibrium
  std::string status, stability, reason;
  int iterations = 0, factorisations = 0;
  double cpu_seconds = 0, energy = 0;
  std::vector<StageRecord> stages;       // stages before the last, if there were several
  Shapes shapes;                         // other equilibria that restarts have found
  std::vector<IterationRecord> history;  // the first and last iterations, and some between them
};

/// All solvers on one case at one size.
struct Row {
  const HardCase* about = nullptr;
  std::string size;
  std::vector<Cell> cells;
  std::size_t shapes = 0;  // number of stable equilibria that differ in energy or place
};

struct RunOptions {
  std::vector<std::string> sizes;  // of kSizes
  std::string pattern;             // only cases whose name contains it
  double seconds = 0;              // limit for one case; 0: 10 s, for large ones 60 s
  double work = 0;                 // limit for one case, in iterations of Newton's method; 0: none
  int threads = 1;
  bool update = false;  // whether the references are renewed
  runs::Watch watch;
  std::function<void(const Row&)> on_row;
};

/// Looks for a column with which every chosen case is refused, although some case is accepted without the
/// settings of the column: they are wrong in general, not only unsuitable for some gears. Returns the
/// diagnostics of the first such column, or nothing if there is none.
std::optional<formats::Diagnostics> refuse_settings(const Suite& suite, const std::vector<Column>& columns,
                                                    References& references, Registry& registry,
                                                    const RunOptions& options);

/// Runs the suite, case by case. An interrupt ends the run, and the unfinished case is left out.
std::vector<Row> run_suite(const Suite& suite, const std::vector<Column>& columns, References& references,
                           Registry& registry, const RunOptions& options);

}  // namespace netloft::hard_cases
