// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

/// Draws the outline of a panel from its counts and cuttings. After a change of counts or cuttings, the
/// caller stores the new outline in Panel::outline.
Outline outline_of(const Panel& panel);

/// The number of meshes at the aft edge of the whole panel that follows from the fore edge and the cuttings.
double aft_by_cuttings(const Panel& panel);

}  // namespace netloft::gears
