// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Fills a request from its key `take`: "[min|max|mean|sum|range] quantity". The quantity is x, y, z,
/// displacement, reaction, reaction x … of nodes; heading, heel, trim of a body; or, if `of` names a whole
/// part, an output of its elements such as tension. Returns false after an error, which is reported at
/// `take`.
bool understand(ResultRequest& request, const ElementType& type, formats::TableReader& entry);

/// The requested number in a solution; `outputs` are indexed [family][output][element], where a family is all
/// elements of one type.
double value_of(const ResultRequest& request, const LoadedScene& loaded, const Assembler& assembler,
                const Solution& solution, const std::vector<std::vector<std::vector<double>>>& outputs);

}  // namespace netloft::scenes
