// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"

namespace netloft::runs {

/// Finds bodies and nodes that lack the inertia that a motion needs. Each fault names the part, and the
/// parameters of its elements that would give this inertia. `is_explicit`: the integrator divides by nodal
/// masses.
std::vector<SceneFault> find_missing_inertia(const Scene& scene, const ScenePlan& plan, Registry& registry,
                                             Assembler& assembler, bool is_explicit);

}  // namespace netloft::runs
