// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft {

/// Whether some term of the element acts with these parameters. Elements on pairs of other elements are
/// created only in this case.
bool may_act(const ElementType& type, const Values& parameters);

/// Makes the part of a rider, an element that exists on each pair of neighbouring elements of another type:
/// neighbouring bars of a rope become bar pairs, triangles with a common edge become triangle pairs. The data
/// of the rider are made from the data of the same name in `part`: one number per element becomes two (first,
/// second), one number per corner becomes one per node of the pair. Parameters of `part` are copied if the
/// rider's table has them.
Part make_companion(const Part& part, const ElementType& ridden, const ElementType& rider);

}  // namespace netloft
