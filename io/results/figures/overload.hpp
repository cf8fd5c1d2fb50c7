// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Returns a sentence for every part whose tension exceeds its breaking load, except parts in the bill of
/// materials, which load_warnings() checks. Also returns a sentence for every part with a strain that no rope
/// or twine can bear.
std::vector<std::string> overload_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                           const Response& answer);

/// Returns a sentence for every part with elements outside their range of validity (outputs with the role
/// NETLOFT_OUTPUT_DOUBT). Also returns a sentence for half a gear that has crossed its plane of symmetry, and
/// for every pair of bodies that have crossed each other.
std::vector<std::string> doubt_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                        const Response& answer);

}  // namespace netloft::results
