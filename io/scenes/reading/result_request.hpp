// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Fills what `take` asks for: "[min|max|mean|sum|range] quantity", the quantity being x, y, z, displacement,
/// reaction, reaction x … of nodes; heading, heel, trim of a body; or an output (tension) of the part's
/// elements, if `of` is a whole part.
/// False: an error was put at `take`.
bool understand(ResultRequest& request, const ElementType& type, formats::TableReader& entry);

/// Its value in a solution; `outputs` are [family][output][element].
double value_of(const ResultRequest& request, const LoadedScene& loaded, const Assembler& assembler,
                const Solution& solution, const std::vector<std::vector<std::vector<double>>>& outputs);

}  // namespace netloft::scenes
