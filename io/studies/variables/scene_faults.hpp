// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <map>
#include <string>

namespace netloft::studies {

/// Reports errors of a scene in another file that sets keys of this scene, such as a study. `keys` are the
/// places in the other file at which keys are set, by the paths of the keys. An error that such a key causes
/// is reported at its place in the other file. Any other error is reported at `scene`, with its place in the
/// scene file.
void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to);

}  // namespace netloft::studies
