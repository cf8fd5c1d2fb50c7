// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/keys.hpp"

#include <string>
#include <vector>

namespace netloft::scenes {

// Contact of a net plan with the bed, and the tables that describe it.

/// The row of gear_elements() for it.
const GearElements& contact_elements();

/// The keys of `[elements.NAME]` about a part itself, without those about its contact. `said` is a table.
formats::Value without_contact(formats::Value said);
/// The keys about its contact alone.
formats::Value only_contact(formats::Value said);

/// Whether a rope lies on the bed where a gear is towed over it, by its role in the plan.
bool rests_on_bed(const gears::Rope& rope);

/// Points of a body on which it stands: "door.toe", "door.heel", those of them that it has.
std::vector<std::string> shoes_of(const gears::PlanBody& body);

/// Half the diameter of the largest of the pieces that are strung along a rope [m]; 0: there are none.
double radius_along(const gears::NetPlan& plan, const std::string& rope);

}  // namespace netloft::scenes
