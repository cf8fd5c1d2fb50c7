// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::scenes {

/// The gear of a net plan as it is modelled, whole or one half of it, and the fineness of its mesh.
struct GearModel {
  gears::Gear gear;
  gears::Fineness fineness;
};

/// Reads `[gear]`. Returns nullopt if its keys have errors, which are reported.
std::optional<GearModel> read_gear_model(const gears::NetPlan& plan, formats::TableReader& root);

/// Converts a name of the plan to the names of the modelled gear, which are in `names`: the name itself or,
/// in a whole gear, its port and starboard copies. Returns an empty list if there are none.
std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names);

}  // namespace netloft::scenes
