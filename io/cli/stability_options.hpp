// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace netloft::io {

/// What `netloft stability` is asked for beyond what other commands know.
struct StabilityOptions {
  std::string suite;                    // none: tests/stability of this folder, else the installed suite
  std::vector<std::string> solvers;     // --solver, may be repeated; none: those of the suite
  std::vector<std::string> strategies;  // --strategy, may be repeated
  std::vector<std::string> without;     // --without, may be repeated
  std::vector<std::string> sizes;       // --size
  std::string pattern;                  // --case
  std::string html;                     // --html FILE
  std::uint64_t draw = 1;               // --draw
  double seconds = 0;                   // --seconds-per-case; 0: the default of the size
  double work = 0;                      // --work; 0: any
  bool update_references = false;       // --update-references
};

}  // namespace netloft::io
