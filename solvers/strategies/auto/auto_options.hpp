// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

namespace netloft::automatic {

/// The options, which plugin.cpp explains.
struct Options {
  std::int64_t restarts = 0;
  double slice = 0;
  bool everywhere = false;
  const char* without = nullptr;
};

}  // namespace netloft::automatic
