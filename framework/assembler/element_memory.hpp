// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/element_tiles.hpp"
#include "framework/assembler/memory.hpp"
#include "framework/assembler/request.hpp"

#include <span>
#include <vector>

namespace netloft {

class TileEvaluator;

/// Makes the memory of each family (all elements of one type). If the ground moves under the gear
/// (`ground_passes`), terms that read the ground need no memory.
std::vector<Memory> make_memories(const ElementTiles& tiles, bool ground_passes);

/// Lets all elements store their state at the positions x (over all dofs) at the end of an accepted step.
/// Returns false and changes nothing if an element could not be evaluated.
bool remember(TileEvaluator& elements, std::span<const double> x, const Kinematics& motion);

/// Returns all numbers that elements remember: first the states of all families, then the stretch rates of
/// all members.
std::vector<double> read_memory(TileEvaluator& elements);
void write_memory(TileEvaluator& elements, std::span<const double> numbers);

}  // namespace netloft
