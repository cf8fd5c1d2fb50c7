// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::program {

/// Options of the command `scope` alone.
struct ScopeOptions {
  std::string depth;            // --depth LO:HI[:N]
  std::string warp = "2:5:13";  // --warp, likewise, over the depth
  std::string heel = "-5:5";    // --heel LO:HI
  std::string spread;           // --spread LO:HI; empty: any
};

}  // namespace netloft::program
