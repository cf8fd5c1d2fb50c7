// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

namespace netloft::program {

/// The folder that holds bin/netloft, lib/netloft and include/netloft, wherever it was moved. The build
/// folder is laid out in the same way.
std::filesystem::path installed_prefix();

/// Flags that compile a plugin: `c++ $(netloft --cflags) otter.cpp -o otter.so`.
std::string compiler_flags();

}  // namespace netloft::program
