// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/diagnostics.hpp"

#include <string>
#include <vector>

namespace netloft::hard_cases {

/// A column of the matrix: a strategy, a solver, and other settings of the analysis.
struct Column {
  std::string solver;    // "newton:method=classic"; empty: that of the analysis
  std::string strategy;  // "auto:without=restarts"; empty: only the solver
  std::vector<std::string> overrides = {};
  std::vector<std::string> sizes = {};  // sizes at which it runs if no option names it; empty: all
  std::string title = {};               // its heading; empty: the strategy and the solver

  std::string head() const;
};

/// Returns the column of a solver alone, such as "newton:method=classic".
Column column_of(const std::string& solver);

/// Adds `parts` to the parameter `without` of the strategy auto, the list of attempts that it leaves out.
/// Columns of other strategies stay as they are.
void leave_out(const std::vector<std::string>& parts, Column& column);

/// Returns the name of the component in a specification: "newton" in "newton:method=classic".
std::string component_of(const std::string& specification);

/// Settings path=value that replace the analysis of a scene by the analysis of the column. Throws
/// std::invalid_argument with a sentence if a specification is not understood.
std::vector<std::string> overrides_of(const Column& column);

/// Reports settings of the analysis that are wrong in every case. Returns whether a plugin was refused.
bool check_settings(const Column& column, Registry& registry, formats::Diagnostics& diagnostics);

}  // namespace netloft::hard_cases
