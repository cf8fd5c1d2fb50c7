// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace netloft::automatic {

/// What a user may change; plugin.cpp says of each what it is.
struct Options {
  std::int64_t restarts = 0;
  double restart_work = 0, slice = 0, growth = 0;
  double perturbation = 0;
  bool everywhere = false;
  const char* without = nullptr;
};

}  // namespace netloft::automatic
