// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/results/figures/result.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::results {

/// Names of the element outputs that are tensions: one for ropes, and one for each twine direction of
/// netting.
inline constexpr std::array<std::string_view, 3> kTensions = {"tension", "tension_u", "tension_v"};

/// Whether `part` is the part `name` of the net plan, or its port or starboard copy.
bool is_called(const std::string& part, const std::string& name);

/// The bill of materials of a gear, without loads: the materials of its plan, and its rigid bodies. A pair of
/// bodies to port and to starboard is one row with the number 2, even if only one half was modelled. Empty
/// without a net plan.
std::vector<Material> find_bill(const scenes::LoadedScene& loaded);

/// Adds masses, areas and loads to the rows of a bill, computed from the figures of the gear.
void add_loads(const std::vector<NamedScalar>& figures, std::vector<Material>& materials);

/// A sentence for every material that carries more than half of its breaking load.
std::vector<std::string> load_warnings(const std::vector<Material>& materials);

}  // namespace netloft::results
