// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <memory>

namespace netloft::scenes {

/// Reads `water.waves`. The water, current and bed of the scene must have been read before. Returns nullptr
/// if the table is absent or has errors.
std::shared_ptr<const WaterField> read_waves(formats::TableReader& water, const Scene& scene);

}  // namespace netloft::scenes
