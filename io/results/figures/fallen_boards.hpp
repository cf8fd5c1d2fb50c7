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

/// Finds, among the boards that form pairs, those that have fallen over (heel of more than 90 degrees to
/// either side), and those that water and ground push inward. Inward means towards the other board of the
/// pair, regardless of the towing direction. Such equilibria exist, mostly at low speeds, but no gear is
/// designed for them. `figures` are the figures of the gear (gear_figures.hpp).
std::vector<FallenBoard> find_fallen_boards(const scenes::LoadedScene& loaded,
                                            const std::vector<NamedScalar>& figures);

}  // namespace netloft::results
