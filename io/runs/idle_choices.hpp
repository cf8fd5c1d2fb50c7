// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::runs {

/// Warns of parameters that a scene sets for terms which the plan leaves out, and of laws where no water
/// flows: they change nothing, though somebody wrote them down. One warning for all parts that share a
/// reason; it stands at the first of them.
void warn_of_idle_choices(const scenes::LoadedScene& loaded, const ScenePlan& plan,
                          formats::Diagnostics& diagnostics);

}  // namespace netloft::runs
