// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace netloft::program {

/// The folder that contains bin/netloft, lib/netloft and include/netloft, even after it was moved. The build
/// folder has the same layout.
std::filesystem::path installed_prefix();

/// Flags that compile a plugin: `c++ $(netloft --cflags) otter.cpp -o otter.so`.
std::string compiler_flags();

}  // namespace netloft::program
