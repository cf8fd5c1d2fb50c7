// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::hard_cases {

/// A column of the matrix: a strategy, a solver, and what else the analysis is given.
struct Column {
  std::string solver;    // "newton:method=classic"; empty: that of the analysis
  std::string strategy;  // "auto:without=restarts"; empty: the solver alone
  std::vector<std::string> overrides = {};
  std::vector<std::string> sizes = {};  // that it is run at unless asked for by name; empty: all
  std::string title = {};               // at its head; empty: the strategy and the solver

  std::string head() const;
};

/// A solver alone, "newton:method=classic".
Column column_of(const std::string& solver);

/// Takes attempts away from the strategy auto, with those that the column leaves out itself: its parameter
/// `without`. Other columns stay as they are.
void leave_out(const std::vector<std::string>& parts, Column& column);

/// Name of a component in "newton:method=classic".
std::string component_of(const std::string& specification);

/// Settings, path=value, that replace the analysis of a scene by that of the column. Throws
/// std::invalid_argument with a sentence if a specification is not understood.
std::vector<std::string> overrides_of(const Column& column);

}  // namespace netloft::hard_cases
