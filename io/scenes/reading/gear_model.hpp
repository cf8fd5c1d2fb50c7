// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/net_plan.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::scenes {

/// The modelled part of a net plan, the whole or a half, and its fineness.
struct GearModel {
  gears::Gear gear;
  gears::Fineness fineness;
};

/// Reads `[gear]`. Nothing where its keys are wrong, as the diagnostics then say.
std::optional<GearModel> read_gear_model(const gears::NetPlan& plan, formats::TableReader& root);

/// The names in a gear for a name in its plan: the same name, or both of a pair in the whole gear.
std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names);

}  // namespace netloft::scenes
