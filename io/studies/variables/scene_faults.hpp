// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <map>
#include <string>

namespace netloft::studies {

/// Reports errors of a scene in another file (a study, for example) that sets keys of this scene. `keys` are
/// the places in the other file where keys are set, by path. An error that such a key causes is reported
/// there. Any other error is reported at `scene`, with its place in the scene.
void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to);

}  // namespace netloft::studies
