// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft::results {

/// Warns of holds that pull a towed gear forwards at nodes where no warp begins. The figures of towing do not
/// include this pull. An example is the block of a middle warp whose rope has no role in the plan.
/// `residual`: residual over all degrees of freedom [N].
std::vector<std::string> uncounted_pull_warnings(const scenes::LoadedScene& loaded,
                                                 const Assembler& assembler, std::span<const double> residual,
                                                 const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
