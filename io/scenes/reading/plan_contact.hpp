// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/keys.hpp"

#include <string>
#include <vector>

namespace netloft::scenes {

// What of a net plan touches the bed, and what its tables say about that.

/// The row of gear_elements() for it.
const GearElements& contact_elements();

/// What `[elements.NAME]` says of a part itself, not of how it touches the bed. Takes a table.
formats::Value without_contact(formats::Value said);
/// What it says of how it touches the bed alone.
formats::Value only_contact(formats::Value said);

/// Whether a rope lies on the bed where a gear is towed over it, by its role in the plan.
bool rests_on_bed(const gears::Rope& rope);

/// Points of a body on which it stands: "door.toe", "door.heel", those of them that it has.
std::vector<std::string> shoes_of(const gears::PlanBody& body);

/// Half the diameter of the largest of the pieces that are strung along a rope [m]; 0: there are none.
double radius_along(const gears::NetPlan& plan, const std::string& rope);

}  // namespace netloft::scenes
