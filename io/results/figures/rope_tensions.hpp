// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// The tensions of the bars of a rope in the gear, from the rope's start to its end.
struct RopeTensions {
  std::string rope;
  std::vector<double> tension;      // [N]
  std::vector<double> rest_length;  // [m]

  /// The tension [N] at a distance from the start along the unstretched rope [m], interpolated linearly
  /// between the middles of bars.
  double at(double distance) const;
  RopeTensions turned_round() const;
};

/// Empty if the scene has no gear.
std::vector<RopeTensions> find_rope_tensions(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                             const Response& answer);

}  // namespace netloft::results
