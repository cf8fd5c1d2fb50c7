// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"

namespace netloft::runs {

/// What a motion cannot move because nothing gives it inertia, by its part, and the keys that would give it:
/// those parameters of its elements whose unit is that of what is missing. `is_explicit`: the integrator
/// divides by masses of nodes.
std::vector<SceneFault> find_missing_inertia(const Scene& scene, const ScenePlan& plan, Registry& registry,
                                             Assembler& assembler, bool is_explicit);

}  // namespace netloft::runs
