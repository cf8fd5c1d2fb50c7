// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft {

/// Whether some term of the element acts with these parameters; riders that cannot act are not laid out.
bool may_act(const ElementType& type, const Values& parameters);

/// The part that an element riding on another makes out of a part of that one: neighbouring bars of a rope
/// become bar pairs, triangles that share an edge triangle pairs. Data of the riders come from those of the
/// ridden by name: a number per element becomes two (first, second), a number per corner becomes one per node
/// of the pair. The parameters are those of the part that the rider's table knows.
Part make_companion(const Part& part, const ElementType& ridden, const ElementType& rider);

}  // namespace netloft
