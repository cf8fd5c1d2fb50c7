// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::scenes {

/// The modelled gear of a net plan, whole or half, and the fineness of its mesh.
struct GearModel {
  gears::Gear gear;
  gears::Fineness fineness;
};

/// Reads `[gear]`. Returns nullopt if its keys have errors, which are reported.
std::optional<GearModel> read_gear_model(const gears::NetPlan& plan, formats::TableReader& root);

/// Converts a name of the plan to names of the modelled gear, all of which are in `names`: the name itself
/// or, in a whole gear, its port and starboard copies. Empty if the modelled gear has none of these names.
std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names);

}  // namespace netloft::scenes
