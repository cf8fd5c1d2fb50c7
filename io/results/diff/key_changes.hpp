// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::results {

/// A key that has different values in two scenes, or in two files. Values are written in the syntax of
/// `--set`. An empty value means that the key does not exist.
struct KeyChange {
  std::string path;  // such as "floats.headline.spread" or "hold[0].at"
  std::string before, after;
};

/// Compares the scenes of two results key by key, after included files are merged and the `--set` options of
/// the command lines are applied. Tables and keys that only one scene has are reported as a whole. Adds the
/// paths of the files of both scenes to `files`. nullopt if one of the results does not have the texts of its
/// scene.
std::optional<std::vector<KeyChange>> find_key_changes(const Origins& before, const Origins& after,
                                                       std::set<std::string>& files);

/// Compares two TOML texts key by key. nullopt if one of them is not TOML.
std::optional<std::vector<KeyChange>> find_key_changes(const std::string& before, const std::string& after);

}  // namespace netloft::results
