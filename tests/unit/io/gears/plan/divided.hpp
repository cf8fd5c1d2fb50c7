// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/mesh_faults.hpp"

#include <gtest/gtest.h>

namespace netloft::gears {

inline void expect_areas(const Gear& gear, const GearMesh& mesh) {
  EXPECT_EQ(area_faults(gear, mesh), std::vector<std::string>{});
}

inline void expect_closed_and_oriented(const Gear& gear, const GearMesh& mesh) {
  EXPECT_EQ(seam_faults(gear, mesh), std::vector<std::string>{});
}

}  // namespace netloft::gears
