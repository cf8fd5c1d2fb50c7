// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/element_tiles.hpp"
#include "framework/assembler/memory.hpp"
#include "framework/assembler/step_tile.hpp"

#include <vector>

namespace netloft {

/// Mean forces over a time step for all families (all elements of one type each), as mean_of_members.hpp and
/// mean_of_energy.hpp define them. Also stores the rates at which members (twines, ropes) stretch.
class MeanForces {
 public:
  /// `are_used`: whether the integrator uses mean forces; if not, no memory is allocated.
  MeanForces(const ElementTiles& tiles, bool are_used);

  StepTile make_step_tile() const;
  /// Gathers the positions at the ends of a step.
  void gather(const Tiling& tiling, std::size_t tile, const StepEnds& ends, StepTile& step) const;
  /// Corrects the sums of conservative terms, which were evaluated in the middle of a step: replaces forces
  /// by the mean forces of the step, and tangents by the derivatives of the mean forces. Returns the first
  /// status other than NETLOFT_OK.
  int add(std::size_t family, const netloft_tile& tile, const Request& request, TileSums& sums,
          StepTile& step) const;
  /// Updates the stretch rates after an accepted step by (3) of mean_of_members.hpp. Returns false if an
  /// element fails to write its members.
  bool remember(const StepEnds& ends, double memory, double time);
  /// Stretch rates of the members of each family [m/s]; empty for families without members.
  std::vector<Memory>& rates() { return rates_; }

 private:
  const ElementTiles& tiles_;
  bool are_used_;
  std::vector<Memory> rates_;
  StepTile step_;
};

}  // namespace netloft
