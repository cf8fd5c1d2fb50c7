// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Figures of the warps that only a motion has: their present length, the load on their blocks, and how fast
/// a winch that holds a tension pays out. They take the place of figures of the same name.
void add_warp_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Snapshot& at,
                      std::vector<NamedScalar>& gear);

}  // namespace netloft::results
