// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/toml/value.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace netloft::gears {

/// The folders that are searched for catalogues, in this order: the folders `own`, which a file names; the
/// folders in the environment variable NETLOFT_CATALOGUE, separated by colons; and the gear library
/// (share/netloft/gear-library/catalogue of the installation). If a folder in the variable cannot be read, an
/// error is reported.
std::vector<std::filesystem::path> catalogue_folders(formats::Diagnostics& diagnostics,
                                                     std::vector<std::filesystem::path> own = {});

/// The folders that the key `catalogue` of a document names, relative to `folder`. If one of them cannot be
/// read, an error is reported.
std::vector<std::filesystem::path> named_folders(const formats::Value& document,
                                                 const std::filesystem::path& folder,
                                                 formats::Diagnostics& diagnostics);

/// The reason why a folder cannot be read, as a sentence; empty if it can.
std::string folder_fault(const std::filesystem::path& folder);

}  // namespace netloft::gears
