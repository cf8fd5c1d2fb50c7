// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"

namespace netloft::runs {

/// Finds bodies and nodes without the inertia that a motion needs, by part, and the keys that would give it:
/// the parameters of their elements whose unit is that of the missing inertia. `is_explicit` says that the
/// integrator divides by masses of nodes.
std::vector<SceneFault> find_missing_inertia(const Scene& scene, const ScenePlan& plan, Registry& registry,
                                             Assembler& assembler, bool is_explicit);

}  // namespace netloft::runs
