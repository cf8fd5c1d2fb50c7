// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/document.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Replaces the names of catalogue parts in a scene, `twine = "pe-braided-4mm"`, by what they stand for. No
/// catalogue is read for a scene without such names. `catalogue` of the scene names folders of its own,
/// relative to `folder`. Returns the catalogue files that were read, for the record of a run, and
/// puts what its parts bear into `strengths`.
std::vector<formats::SourceFile> put_catalogue_parts(formats::Value& scene,
                                                     const std::filesystem::path& folder, Registry& registry,
                                                     formats::Diagnostics& diagnostics,
                                                     std::map<std::string, Strength>& strengths);

}  // namespace netloft::scenes
