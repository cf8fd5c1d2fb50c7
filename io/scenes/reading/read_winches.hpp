// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Whether the lengths of warps can be looked for and changed by what the scene is analysed by, and with what
/// its ropes are made of. In a motion, winches then have a table to change; at rest there are none.
void ready_winches(const gears::NetPlan& plan, Registry& registry, LoadedScene& out,
                   formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
