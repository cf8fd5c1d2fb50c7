// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/mean_forces.hpp"

#include "framework/assembler/gather.hpp"
#include "framework/assembler/mean_of_energy.hpp"
#include "framework/assembler/mean_of_members.hpp"

#include <cassert>

namespace netloft {

MeanForces::MeanForces(const ElementTiles& tiles, bool are_used)
    : tiles_(tiles), are_used_(are_used), step_(make_step_tile()) {
  for (std::size_t f = 0; f < tiles.families.size(); ++f) {
    rates_.emplace_back(tiles.group_of(f).tiling.tiles,
                        are_used ? tiles.families[f]->type().members.count : 0);
  }
}

StepTile MeanForces::make_step_tile() const { return StepTile(are_used_ ? tiles_.most_dofs() : 0); }

void MeanForces::gather(const Tiling& tiling, std::size_t tile, const StepEnds& ends, StepTile& step) const {
  assert(are_used_ && "the plan has room for mean forces");
  gather_positions(tiling, tile, ends.before, step.before.data());
  gather_positions(tiling, tile, ends.after, step.after.data());
}

int MeanForces::add(std::size_t family, const netloft_tile& t, const Request& request, TileSums& sums,
                    StepTile& step) const {
  const ElementFamily& f = *tiles_.families[family];
  const TileOfStep of{f, t, request, tiles_.symmetric, sums, step};
  for (const auto& term : f.active_terms()) {
    const bool counts = (term.traits & NETLOFT_CONSERVATIVE) && !(term.traits & NETLOFT_CONSTANT) &&
                        !(term.traits & request.without);
    if (!counts) continue;
    const int status = term.traits & NETLOFT_OF_MEMBERS
                           ? add_mean_of_members(of, rates_[family].kept(t.first / kTileLanes))
                           : add_mean_of_energy(of, term);
    if (status != NETLOFT_OK) return status;
  }
  return NETLOFT_OK;
}

bool MeanForces::remember(const StepEnds& ends, double memory, double time) {
  for (std::size_t family = 0; family < tiles_.families.size(); ++family) {
    if (rates_[family].empty()) continue;
    const Tiling& tiling = tiles_.group_of(family).tiling;
    for (std::size_t tile = 0; tile < tiling.tiles; ++tile) {
      gather(tiling, tile, ends, step_);
      if (!remember_stretch_rates(*tiles_.families[family], tile, ends, memory, time, step_,
                                  rates_[family].mutable_kept(tile)))
        return false;
    }
  }
  return true;
}

}  // namespace netloft
