// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/validation/real_gears/solving.hpp"

namespace netloft::real_gears {

/// A test that is run on each of the five gears, and skipped if their files are missing.
class RealGear : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("NETLOFT_REAL_GEARS");
    if (!folder) GTEST_SKIP() << "NETLOFT_REAL_GEARS does not name the folder of the gears";
    gear_ = read_neutral_case(std::filesystem::path(folder) / (std::string(GetParam()) + ".json"));
  }
  NeutralCase gear_;
};

inline std::string gear_name(const testing::TestParamInfo<const char*>& gear) { return gear.param; }

}  // namespace netloft::real_gears
