// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::program {

/// Flags that compile a plugin: `c++ $(netloft --cflags) otter.cpp -o otter.so`.
std::string compiler_flags();

}  // namespace netloft::program
