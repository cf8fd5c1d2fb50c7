// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace netloft {

/// Opens a shared object, which stays open until the program ends, and returns its checked content.
/// If opening changes the floating-point environment, the environment is restored and the plugin refused.
/// Throws PluginRefused.
PluginContent open_library(const std::filesystem::path& file);

/// Returns the build of `folder/NAME.so` for the newest x86-64 level that this processor supports, or an
/// empty path if there is none.
std::filesystem::path best_build(const std::filesystem::path& folder, const std::string& name);

/// Names of the plugins in a folder that have a build for this processor.
std::set<std::string> names_of_builds(const std::filesystem::path& folder);

}  // namespace netloft
