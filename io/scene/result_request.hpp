// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/problem/verdict.hpp"
#include "io/scene/loaded_scene.hpp"
#include "io/toml/table_reader.hpp"

namespace netloft::io {

/// Own nodes of a part by the name of a set, or "node-17". False: there is none.
bool find_own_nodes(const PartGeometry& part, std::size_t count, const std::string& name,
                    std::vector<std::uint32_t>& own);
std::vector<std::string> set_names(const PartGeometry& part);
/// "did you mean "fore"?", or what there is.
std::string name_hint(const std::string& name, const std::vector<std::string>& there);

/// Fills what `take` asks for: "[min|max|mean|sum|range] quantity", the quantity being x, y, z, displacement,
/// reaction, reaction x … of nodes, or an output of the elements (tension) of a whole part, whose type is
/// given. False: an error was put at `take`.
bool understand(ResultRequest& request, const ElementType* type, TableReader& entry);

/// Its value in a solution; `outputs` are [family][output][element].
double value_of(const ResultRequest& request, const Scene& scene, const Assembler& assembler,
                const Solution& solution, const std::vector<std::vector<std::vector<double>>>& outputs);

}  // namespace netloft::io
