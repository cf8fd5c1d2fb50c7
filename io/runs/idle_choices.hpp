// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::runs {

/// Warns of settings without effect: parameters for terms that the plan leaves out, and laws of flow in still
/// water. All parts with the same reason share one warning, located at the first.
void warn_of_idle_choices(const scenes::LoadedScene& loaded, const ScenePlan& plan,
                          formats::Diagnostics& diagnostics);

}  // namespace netloft::runs
