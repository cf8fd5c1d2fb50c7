// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/report/answer.hpp"
#include "io/scene/loaded_scene.hpp"

namespace netloft::io {

/// A number about a gear. Its name is a path in the plan's words, "ropes/headrope/tension_end": the same on
/// the terminal, in JSON, in result files and in comparisons of results.
struct Figure {
  std::string name, unit, doc;
  double value = 0;
};

/// What a gear designer asks of a gear. d the unit vector of the current (aft, x, in still water), P₀ … P_n
/// the nodes of the headline and then, backwards, those of the footrope, in a closed curve:
///   S = ½ Σ P_i × P_{i+1},   mouth area = |d·S|              projected on the plane across the current (1)
///   opening = sin α = mesh width over stretched mesh         of taut twines, α half their angle       (2)
///   mean of (2) over the meshes of a panel
///   area = Σ A_e,   filtered area = Σ A_e |d·n_e|            triangles e of netting, normals n_e       (3)
///   share on the ground = Σ ½ l_b t_b / Σ l_b                bars b of the footrope, t_b ends that touch (4)
/// (2) is the horizontal hanging ratio that the meshes have taken up: 0 closed, 0.71 square, 1 pulled flat
/// across. (3) is all the water that goes through netting, once for every wall of netting it goes through.
/// Forces are those on the gear: `drag` is all that the water does with it, the push on a catch included.
/// Weight in water is positive of what sinks. Tension at the end of a rope is extrapolated to it from the two
/// outer bars where it changes steadily, else that of the outer bar.
///
/// Of a half (GearInScene::times = 2) sums are those of the whole, twice those of what was modelled; only
/// forces across the gear, along y, are of the starboard half alone: those on the other half cancel them.
///
/// Only what the gear has is listed: no headline, no height. `answer` is one of a scene with a gear.
std::vector<Figure> find_gear_figures(const LoadedScene& loaded, const Assembler& assembler,
                                      const Answer& answer);

}  // namespace netloft::io
