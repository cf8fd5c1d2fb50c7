// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::scenes {

/// What of a net plan is modelled, the whole or a half, and how finely.
struct GearModel {
  gears::Gear gear;
  gears::Fineness fineness;
};

/// Reads `[gear]`. Nothing where its keys are wrong, as the diagnostics then say.
std::optional<GearModel> read_gear_model(const gears::NetPlan& plan, formats::TableReader& root);

/// Of the names in a gear those that a plan's name stands for: itself, or in the whole both of a pair.
std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names);

}  // namespace netloft::scenes
