// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <nlohmann/json.hpp>

namespace netloft::pictures {

/// The region around a gear in which bed and surface are drawn, and heights of the bed on an even grid over
/// this region: {x: [first, last], y: [first, last], places, heights [x][y]} [m]; `heights` is null without a
/// bed.
nlohmann::ordered_json ground_json(const results::StoredShape& stored);

}  // namespace netloft::pictures
