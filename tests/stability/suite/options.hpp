// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::hard_cases {

struct SuiteOptions : program::PluginOptions {
  std::vector<std::string> set;  // --set, may be repeated
  int threads = 1;               // --threads
  std::string suite = "tests/stability";
  std::vector<std::string> solvers;     // --solver, may be repeated; none: the columns of the suite
  std::vector<std::string> strategies;  // --strategy, may be repeated
  std::vector<std::string> without;     // --without, may be repeated
  std::vector<std::string> sizes;       // --size
  std::string pattern;                  // --case
  std::string flow;                     // --flow; empty: all cases, without a flow
  std::string output;                   // -o FILE.html
  std::uint64_t seed = 1;               // --seed
  double seconds = 0;                   // --seconds-per-case; 0: the default of the size
  double work = 0;                      // --work; 0: no limit
  bool update_references = false;       // --update-references
};

/// All options of the program, which are read into `options`.
void add_options(CLI::App& app, SuiteOptions& options);

}  // namespace netloft::hard_cases
