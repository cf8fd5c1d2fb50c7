// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <map>
#include <string>

namespace netloft::studies {

/// Reports errors of a scene in the file (of a study, for example) that sets keys of this scene. An error
/// that a key causes is reported at the place in that file where the key is set (`keys`: places by path), any
/// other error at `scene`, with its place in the scene.
void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to);

}  // namespace netloft::studies
