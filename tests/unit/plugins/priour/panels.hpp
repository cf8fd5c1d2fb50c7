// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/triangle.hpp"
#include "tests/unit/plugins/kernel_oracle.hpp"

namespace netloft {

/// Triangles of 2 to 6 meshes, with corners in either sense of rotation; bars of 0.1 m.
inline std::vector<priour::Triangle::Data> panels() {
  std::mt19937_64 random(2);
  std::vector<priour::Triangle::Data> all(kLanes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double s = uniform(random, 2, 6), skew = uniform(random, -0.5, 0.5);
    all[lane] = {{0, s, skew}, {0, skew, s}, 0.1};
    if (lane % 2) std::swap(all[lane].u[1], all[lane].u[2]), std::swap(all[lane].v[1], all[lane].v[2]);
  }
  return all;
}

}  // namespace netloft
