// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/units/in_quotes.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>
#include <vector>

namespace netloft::scenes {

/// Finds nodes of a part by the name of a set or by a name such as "node-17", and sets `own` to their numbers
/// within the part. Returns false if there are none.
bool find_own_nodes(const PartGeometry& part, std::size_t count, const std::string& name,
                    std::vector<std::uint32_t>& own);

/// A hint for a wrong name: "did you mean "rope"?", or a list of the existing names.
std::string name_hint(const std::string& name, const std::vector<std::string>& there);

/// A hint for a wrong name of a set or a node of a part.
std::string set_hint(const PartGeometry& part, std::size_t count, const std::string& name);

}  // namespace netloft::scenes
