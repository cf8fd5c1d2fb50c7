// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::runs {

/// Warns of parameters that a scene sets for terms which the plan leaves out, and of laws in still water,
/// because they have no effect. There is one warning for all parts with the same reason, located at the
/// first.
void warn_of_idle_choices(const scenes::LoadedScene& loaded, const ScenePlan& plan,
                          formats::Diagnostics& diagnostics);

}  // namespace netloft::runs
