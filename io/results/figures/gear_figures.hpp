// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// A number that describes a gear. Its name is a path that contains names of the net plan, such as
/// "ropes/headrope/tension_end". The name is the same on the terminal, in JSON, in result files and in
/// comparisons of results.
struct Figure {
  std::string name, unit, doc;
  double value = 0;
};

/// Computes the figures of a gear: the numbers that matter to its designer. d is the unit vector of the
/// current (aft, along x, in still water). P₀ … P_n is a closed curve: the nodes of the headline, followed by
/// the nodes of the footrope in reverse order:
///   S = ½ Σ P_i × P_{i+1},   mouth area = |d·S|              projected on the plane across the current (1)
///   opening = sin α = mesh width over stretched mesh         of taut twines, α half their angle       (2)
///   mean of (2) over the meshes of a panel
///   area = Σ A_e,   filtered area = Σ A_e |d·n_e|            triangles e of netting, normals n_e       (3)
///   fraction on the ground = Σ ½ l_b t_b / Σ l_b           bars b of the footrope with t_b ends on it  (4)
/// (2) is the horizontal hanging ratio of the deformed meshes: 0 closed, 0.71 square, 1 stretched across. (3)
/// is the area that filters water; a flow line that passes through two walls of netting counts twice. Forces
/// are those on the gear: `drag` is the total force of the water, including its push on a catch. Weight in
/// water is positive if the part sinks. The tension at the end of a rope is extrapolated from the two outer
/// bars if it changes steadily there; otherwise it is the tension of the outer bar.
///
/// If only the starboard half was modelled (GearInScene::times = 2), sums are doubled, so that they hold for
/// the whole gear. Forces across the gear, along y, are not doubled, because they cancel in the whole gear.
///
/// A scene without a net plan has only the figures of its rigid bodies: the positions of their origins and
/// their attitude (netloft/attitude.hpp).
std::vector<Figure> find_gear_figures(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer);

}  // namespace netloft::results
