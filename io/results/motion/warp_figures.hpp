// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "io/results/figures/run_result.hpp"

namespace netloft::results {

/// Figures of the warps that only a motion has: how long they are now, what their blocks bear, and how fast a
/// winch that holds a tension pays out. They take the place of figures of the same name.
void add_warp_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Snapshot& at,
                      std::vector<NamedScalar>& gear);

}  // namespace netloft::results
