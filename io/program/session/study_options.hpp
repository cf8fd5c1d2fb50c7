// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::program {

/// Options of the command `study` alone.
struct StudyCommandOptions {
  std::string action;                    // plan, run, missing, submit, collect, show, estimate, sobol
  std::string items;                     // --items 1-10,15
  std::string engine;                    // --engine parallel, slurm
  std::vector<std::string> figures, at;  // --figure, --at NAME=VALUE
  std::string over, by;                  // --over, --by
  int jobs = 0;                          // --jobs; 0: as many as the machine has
  int chunk = 0;                         // --chunk; 0: as many items as take a minute
};

}  // namespace netloft::program
