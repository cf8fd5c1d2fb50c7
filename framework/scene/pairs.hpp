// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft {

/// Whether some term of the element acts with these parameters. An element on pairs of another element is
/// created only if it has such a term.
bool may_act(const ElementType& type, const Values& parameters);

/// Makes the part of a rider. Such an element exists on each pair of neighbouring elements of another type:
/// neighbouring bars of a rope become bar pairs, triangles with a common edge become triangle pairs. The data
/// of the rider are made from data of the same name of the other type: a number per element becomes two
/// (first, second), a number per corner becomes one per node of the pair. Parameters are copied if the
/// rider's table has them.
Part make_companion(const Part& part, const ElementType& ridden, const ElementType& rider);

}  // namespace netloft
