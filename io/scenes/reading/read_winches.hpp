// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Checks that the analysis can find or change the lengths of warps on winches, and that the elements of
/// these warps allow it. In a motion, gives each of these warps a table of length factors over time; for a
/// static analysis, removes the winches.
void ready_winches(const gears::NetPlan& plan, Registry& registry, LoadedScene& out,
                   formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
