// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft {

/// Whether a shared object is as long as its header says. The system's loader does not check the length, and
/// loading a truncated file ends the program (SIGBUS). Returns true for files that are not ELF files, because
/// the loader refuses them anyway.
bool is_whole(const std::filesystem::path& file);

}  // namespace netloft
