// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace netloft {

/// Names of the exported symbols of a shared object (ELF), sorted, without those that linkers add.
std::vector<std::string> exported_symbols(const std::filesystem::path& file);

}  // namespace netloft
