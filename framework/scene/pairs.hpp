// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

namespace netloft {

/// Whether some term of the element acts with these parameters; riders without such a term are not created.
bool may_act(const ElementType& type, const Values& parameters);

/// Makes the part of an element that rides on another one: neighbouring bars of a rope become bar pairs,
/// triangles with a common edge become triangle pairs. Data of the rider are taken from the data of the same
/// name: a number per element becomes two (first, second), a number per corner becomes one per node of the
/// pair. Parameters are copied if the rider's table has them.
Part make_companion(const Part& part, const ElementType& ridden, const ElementType& rider);

}  // namespace netloft
