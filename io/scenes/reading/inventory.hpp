// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes {

/// The breaking load in the table of a twine or a rope [N]; NaN if the table has none.
double breaking_load_of(const formats::Value& numbers);

/// The rows of the bill of materials of a gear: panels, ropes, floats and weights. Each row is for one name
/// in the plan, so that port and starboard share a row.
std::vector<BillItem> bill_of(const gears::NetPlan& plan);

/// The panels of a plan that are described by counts and cuttings. Panels given by corners are left out.
std::vector<NettingSheet> netting_of(const gears::NetPlan& plan);

/// The place of every panel of the gear on the drawing of its plan.
std::map<std::string, SheetPlace> sheet_of(const gears::NetPlan& plan, const gears::Gear& gear);

}  // namespace netloft::scenes
