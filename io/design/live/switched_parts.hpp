// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

#include <string>
#include <vector>

namespace netloft::design {

/// Describes what changed between two equilibria, part by part: members that became slack
/// or taut, and nodes that touched or left the ground. Example: "12 members of top-wing became slack; 3 nodes
/// of footrope left the ground". If nothing changed, the sentence says so.
std::string switched_parts(runs::PreparedScene& before, const std::vector<double>& x_before,
                           runs::PreparedScene& after, const std::vector<double>& x_after);

}  // namespace netloft::design
