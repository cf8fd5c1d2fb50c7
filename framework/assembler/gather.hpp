// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/lanes.hpp"
#include "framework/assembler/request.hpp"
#include "framework/assembler/riders.hpp"
#include "framework/registry/extensions.hpp"

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace netloft {

/// The inputs of the elements of one tile, in rows of 64 numbers. The array of an input is empty if the scene
/// has no such input.
struct TileInputs {
  std::vector<double> x, x_low;                     // positions [m]; digits that rounding removes from x
  std::vector<double> v, a;                         // [m/s], [m/s²]; empty if everything is at rest
  std::vector<double> current, current_dz;          // [m/s], [1/s]; empty in still water
  std::vector<double> water_acceleration, surface;  // [m/s²], [m]; empty without waves
  std::vector<double> bed;                          // bed per node: height, slopes and second derivatives
  // Data of extensions of the plugin interface for the family that receives the tile.
  ExtensionInputs extensions;
  // The time [s] at which `current` was evaluated, if the current is uniform.
  double current_time = std::numeric_limits<double>::quiet_NaN();
};

/// Copies the positions of a tile's nodes, [dof][64], from a vector over all dofs. Rotations of bodies are
/// converted from lengths to radians.
void gather_positions(const Tiling& tiling, std::size_t tile, const double* x, double* to);

/// Gathers the inputs of the elements of a tile: positions and rates from vectors over all dofs, and the
/// water and the seabed at the nodes.
class Gatherer {
 public:
  Gatherer(const Scene& scene, const ScenePlan& plan);

  /// Allocates the inputs of a tile of elements with up to `dofs` degrees of freedom.
  TileInputs make_inputs(std::size_t dofs) const;
  /// Gathers all inputs that some family of a group reads.
  void gather(const FamilyGroup& group, std::size_t tile, std::span<const double> x, const Kinematics& motion,
              TileInputs& inputs) const;
  /// Makes the tile that one family of the group receives. Extension data are filled in, but the caller
  /// attaches them to the tile, and adds the elements' memory and a buffer for messages.
  netloft_tile make_tile(const ElementFamily& family, std::size_t tile, const Kinematics& motion,
                         TileInputs& inputs) const;
  bool ground_passes() const { return ground_passes_; }

 private:
  void gather_current(const Tiling& tiling, std::size_t tile, double time, TileInputs& inputs) const;
  void fill_current(double time, TileInputs& inputs) const;
  void gather_waves(const Tiling& tiling, std::size_t tile, double time, TileInputs& inputs) const;
  void gather_bed(const Tiling& tiling, std::size_t tile, TileInputs& inputs) const;

  SceneWater water_;
  Current current_;
  std::shared_ptr<const WaterField> waves_;  // nullptr in statics and without waves
  std::array<double, 3> ground_;             // [m/s]
  SeaBed bed_;
  bool ground_passes_, has_rates_;
};

}  // namespace netloft
