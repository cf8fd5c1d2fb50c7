// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/run_result.hpp"

#include <nlohmann/json.hpp>

namespace netloft::results {

/// The value and the unit of every number.
nlohmann::ordered_json values_json(const std::vector<NamedScalar>& scalars);
nlohmann::ordered_json units_json(const std::vector<NamedScalar>& scalars);

/// The errors of every number; unknown ones are null.
nlohmann::ordered_json errors_json(const std::vector<NamedScalar>& scalars);

/// The figures of a gear, by name; null if the scene has none.
nlohmann::ordered_json gear_json(const scenes::LoadedScene& loaded, const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
