// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// A number about a gear. Its name is a path such as "ropes/headrope/tension_end" with the names of the plan;
/// it is the same on the terminal, in JSON, in result files and in comparisons of results.
struct Figure {
  std::string name, unit, doc;
  double value = 0;
};

/// The figures that describe a gear to its designer. d is the unit vector of the current (aft, x, in still
/// water), P₀ … P_n the nodes of the headline and then, backwards, those of the footrope, in a closed curve:
///   S = ½ Σ P_i × P_{i+1},   mouth area = |d·S|              projected on the plane across the current (1)
///   opening = sin α = mesh width over stretched mesh         of taut twines, α half their angle       (2)
///   mean of (2) over the meshes of a panel
///   area = Σ A_e,   filtered area = Σ A_e |d·n_e|            triangles e of netting, normals n_e       (3)
///   fraction on the ground = Σ ½ l_b t_b / Σ l_b           bars b of the footrope, t_b touching ends  (4)
/// (2) is the horizontal hanging ratio of the meshes as they are: 0 closed, 0.71 square, 1 pulled flat
/// across. (3) counts all water that passes through netting, once for each wall of netting that it passes.
/// Forces are those on the gear: `drag` is the total force of the water, including its push on a catch.
/// Weight in water is positive if the part sinks. The tension at the end of a rope is extrapolated from the
/// two outer bars if it changes steadily there; otherwise it is the tension of the outer bar.
///
/// If one half was modelled (GearInScene::times = 2), sums are those of the whole gear, twice those of the
/// half. Only forces across the gear, along y, are those of the starboard half alone, because they cancel in
/// the whole gear.
///
/// Figures of parts that the gear does not have are left out. A scene without a net plan has only the figures
/// of its rigid bodies: the positions of their origins and their attitude (netloft/attitude.hpp).
std::vector<Figure> find_gear_figures(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer);

}  // namespace netloft::results
