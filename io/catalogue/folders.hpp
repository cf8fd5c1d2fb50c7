// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace netloft::io {

/// The folders that are searched for catalogues: `own` (those a file names, in order), those in the variable
/// NETLOFT_CATALOGUE (divided by colons), then the gear library: share/netloft/gear-library/catalogue beside
/// the program or above it, so that the folder may be moved.
std::vector<std::filesystem::path> catalogue_folders(std::vector<std::filesystem::path> own = {});

/// What keeps a folder that a file names from being read, as a sentence; empty if nothing does.
std::string folder_fault(const std::filesystem::path& folder);

}  // namespace netloft::io
