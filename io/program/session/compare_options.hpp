// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::program {

/// What `netloft compare` is asked for beyond what other commands know.
struct CompareOptions {
  std::vector<std::string> methods;      // --solver, --strategy or --integrator, at least once
  std::string accuracy;                  // --accuracy LO:HI, of motions; empty: 1e-3:1e-1
  std::string tolerance = "1e-10:1e-2";  // --tolerance LO:HI
  std::string cells;                     // --cells [PART=]N,N,…
  std::string reference;                 // --reference NAME[:key=value,…]
  int repeats = 3;                       // --repeats
  std::string csv, plot;                 // --csv FILE, --plot FILE.svg|.html
};

}  // namespace netloft::program
