// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Adds the figures of warps that exist only in a motion: their present length, the load on their blocks, and
/// the speed at which a constant-tension winch pays out. A figure of the same name in `gear` is replaced.
void add_warp_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Snapshot& at,
                      std::vector<NamedScalar>& gear);

}  // namespace netloft::results
