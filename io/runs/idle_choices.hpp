// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::runs {

/// Warns of settings without effect: parameters of forces that this analysis does not evaluate, and drag laws
/// in still water. Parts with the same setting and the same reason share one warning, whose place is that of
/// the first part.
void warn_of_idle_choices(const scenes::LoadedScene& loaded, const ScenePlan& plan,
                          formats::Diagnostics& diagnostics);

}  // namespace netloft::runs
