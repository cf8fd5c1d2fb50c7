// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <map>
#include <string>

namespace netloft::studies {

/// Shows what is wrong with a scene that another file sets keys of, in that file: what a key is to blame for
/// at `keys`, the places of keys by their path; all else, with its place in the scene, at `scene`.
void hand_on_faults(const formats::Diagnostics& of_scene, const std::map<std::string, formats::Place>& keys,
                    const formats::Place& scene, formats::Diagnostics& to);

}  // namespace netloft::studies
