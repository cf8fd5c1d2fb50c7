// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft {

/// Whether a shared object is as long as its header says. The system's loader does not ask: it maps what is
/// missing of a truncated file and dies of it (SIGBUS). True for what is no ELF file, which the loader
/// refuses.
bool is_whole(const std::filesystem::path& file);

}  // namespace netloft
