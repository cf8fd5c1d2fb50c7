// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes {

/// The tension at which what a table describes breaks [N]; NaN if it does not say.
double breaking_load_of(const formats::Value& numbers);

/// The rows of a gear's bill of materials: panels, ropes, and what is hung on them, each under its name in
/// the plan, port and starboard in one row.
std::vector<BillItem> bill_of(const gears::NetPlan& plan);

/// The place of every panel of the gear on the drawing of its plan.
std::map<std::string, SheetPlace> sheet_of(const gears::NetPlan& plan, const gears::Gear& gear);

}  // namespace netloft::scenes
