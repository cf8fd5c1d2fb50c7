// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <cstdint>

namespace netloft::program {

struct CompareOptions : SceneOptions {
  std::vector<std::string> methods;      // options --solver, --strategy or --integrator, at least once
  std::string accuracy;                  // option --accuracy LO:HI, for motions; empty: 1e-3:1e-1
  std::string tolerance = "1e-10:1e-2";  // option --tolerance LO:HI
  std::string cells;                     // option --cells [PART=]N,N,…
  std::string reference;                 // option --reference NAME[:key=value,…]
  int repeats = 3;                       // option --repeats
  std::vector<std::string> outputs;      // options -o FILE.svg|.html|.csv
};

struct RefineOptions : MethodOptions {
  std::vector<std::int64_t> nodes;  // option --nodes N,N,…
  std::string cells;                // option --cells [PART=]N,N,…
};

int compare_command(const CompareOptions& options);  // compares speed and error of methods
int refine_command(const RefineOptions& options);    // compares the numbers of a scene between meshes

}  // namespace netloft::program
