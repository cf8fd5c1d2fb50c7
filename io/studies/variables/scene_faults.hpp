// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <map>
#include <string>

namespace netloft::studies {

/// Reports errors of a scene in the file that sets keys of this scene. Errors that a key causes are reported
/// at its place in `keys` (places by path), all others at `scene`, with their place in the scene.
void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to);

}  // namespace netloft::studies
