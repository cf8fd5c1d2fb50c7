// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

#include <map>
#include <optional>

namespace netloft {

/// The same scene made easier to solve: the same parts on the same nodes, with other numbers. Which numbers,
/// the parameters say themselves (NETLOFT_COMPRESSION, NETLOFT_STIFFNESS); what they mean is not known here.

/// The value that a real parameter of a part has, given or by default.
double value_of(const Part& part, const ElementType& type, const netloft_parameter& parameter);

/// A stiffness of bars counts in newtons, one of hinges or of a ground otherwise.
bool is_in_newtons(const netloft_parameter& parameter);

/// Nothing resists shortening. Under dead loads the energy is then convex: one answer, downhill from
/// anywhere. Empty if that changes nothing.
std::optional<Scene> without_compression(const Scene& scene, Registry& registry);

/// Stiffnesses of every part in proportion, so that none counted in newtons exceeds `cap` [N].
Scene softened(const Scene& scene, Registry& registry, double cap);

/// Largest stiffness counted in newtons [N]; zero if there is none.
double largest_stiffness(const Scene& scene, Registry& registry);

/// `share` of the current.
Scene with_current(const Scene& scene, double share);

}  // namespace netloft
