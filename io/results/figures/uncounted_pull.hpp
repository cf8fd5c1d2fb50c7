// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::results {

/// Warns of holds that pull a towed gear forwards although no warp begins there, such as the block of a
/// middle warp whose rope has no role: the figures of towing leave their pull out. `residual`: over all dofs
/// [N].
std::vector<std::string> uncounted_pull_warnings(const scenes::LoadedScene& loaded,
                                                 const Assembler& assembler, std::span<const double> residual,
                                                 const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
