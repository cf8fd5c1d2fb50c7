// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/value.hpp"
#include "io/results/figures/result.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::results {

/// All values of an option, such as "--set", in the command line of a result.
std::vector<std::string> values_of_option(const Origins& origins, const std::string& option);

/// The scene of a result as one table, with its included files merged and the `--set` options of its command
/// line applied. No file is opened. The paths of the files are added to `paths`. nullopt unless the result
/// contains the texts of all these files.
std::optional<formats::Value> merged_scene(const Origins& origins, std::set<std::string>& paths);

/// A setting of the scene under which the figures of a gear hold.
struct Condition {
  std::string name, value;  // "depth", "66 m"
};

/// Title and source of the gear, its speed, the current, the depth and the length of warp, as they are
/// written in the scene. Empty for a result without a net plan.
std::vector<Condition> conditions_of(const Result& result);

/// All conditions except the title and the source, in one line: "speed of the ship 3 kn, depth 66 m".
std::string conditions_line(const std::vector<Condition>& conditions);

}  // namespace netloft::results
