// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// A board of a pair that does not spread the gear.
struct FallenBoard {
  std::string board, sentence;
};

/// Boards of pairs that lie over, their heel beyond a right angle either way, and those that water and ground
/// push inward. Both are equilibria like others, found at low speeds above all; a gear in one is not the gear
/// that somebody meant. Inward is towards the other board of the pair, whichever way the ship goes. `figures`
/// are those of the gear (gear_figures.hpp).
std::vector<FallenBoard> find_fallen_boards(const scenes::LoadedScene& loaded,
                                            const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
