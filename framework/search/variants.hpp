// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

namespace netloft {

/// The variant that is the original scene itself, as its author wrote it.
netloft_variant as_written();
bool is_as_written(const netloft_variant& variant);
bool is_same(const netloft_variant& a, const netloft_variant& b);
/// Combines a variant `inner`, which is relative to `outer`, with `outer`: levels of mesh are added, factors
/// are multiplied, and the lower cap applies.
netloft_variant combined(const netloft_variant& outer, const netloft_variant& inner);
/// Description of a variant: "elements x 4, stiffness up to 120 N, no compression"; empty for the original
/// scene.
std::string text_of(const netloft_variant& variant);

/// Returns a scene with the same parts and nodes but other parameters; the coarser mesh of a variant is made
/// elsewhere. The roles of parameters determine which of them change (NETLOFT_STIFFNESS,
/// NETLOFT_COMPRESSION):
///   stiffness_cap divides all stiffnesses of a part by one factor if its largest axial
///                  stiffness exceeds the cap [N]; that stiffness then equals the cap
///   compression    multiplies stiffnesses in compression; at zero, the elastic energy under dead loads is
///                  convex, so that every equilibrium has the least energy
///   current        multiplies the velocities of the water and of the tow
Scene make_variant(const Scene& scene, Registry& registry, const netloft_variant& variant);

/// Largest axial stiffness (in newtons); zero if there is none.
double largest_stiffness(const Scene& scene, Registry& registry);

bool resists_compression(const Scene& scene, Registry& registry);

}  // namespace netloft
