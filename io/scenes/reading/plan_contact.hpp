// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/keys.hpp"

#include <string>
#include <vector>

namespace netloft::scenes {

// The contact of ropes and bodies of a net plan with the bed, and the tables that describe it.

/// The entry of gear_elements() for contact with the bed.
const GearElements& contact_elements();

/// The table `[elements.NAME]` without its keys for contact. `said` must be a table.
formats::Value without_contact(formats::Value said);
/// The table `[elements.NAME]` with only its keys for contact.
formats::Value only_contact(formats::Value said);

/// Whether a rope lies on the bed while the gear is towed, according to the role of the rope in the plan.
bool rests_on_bed(const gears::Rope& rope);

/// The points on which a body rests: "door.toe" and "door.heel", if the body has them.
std::vector<std::string> shoes_of(const gears::PlanBody& body);

/// Half the diameter of the largest piece, such as a roller, that is strung on a rope [m]; 0 if there is
/// none.
double radius_along(const gears::NetPlan& plan, const std::string& rope);

}  // namespace netloft::scenes
