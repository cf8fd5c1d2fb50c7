// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

#include <string>
#include <vector>

namespace netloft::design {

/// The members that became slack or taut and the nodes that touched or left the ground between two equilibria
/// with the same mesh, by parts: "12 members of top-wing became slack; 3 nodes of footrope left the ground".
/// A sentence that says so if there are none.
std::string switched_parts(runs::PreparedScene& before, const std::vector<double>& x_before,
                           runs::PreparedScene& after, const std::vector<double>& x_after);

}  // namespace netloft::design
