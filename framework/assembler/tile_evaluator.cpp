// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tile_evaluator.hpp"

#include "framework/assembler/element_memory.hpp"
#include "framework/assembler/scatter.hpp"

#include <numeric>

namespace netloft {

namespace {

// Least number of tiles of one colour (tiling.hpp) for which several threads are faster than one
// (bench_assembly).
constexpr std::size_t kSerialBelow = 8;

}  // namespace

TileEvaluator::TileEvaluator(const Scene& scene, const ScenePlan& plan, const ElementTiles& tiles,
                             int threads)
    : tiles_(tiles),
      gatherer_(scene, plan),
      calls_(plan.tangent, tiles.symmetric),
      mean_forces_(tiles, plan.between),
      memories_(make_memories(tiles, gatherer_.ground_passes())),
      tile_energy_(tiles.count),
      workers_(threads) {
  for (std::size_t w = 0; w < workers_.size(); ++w)
    works_.push_back(std::make_unique<Work>(Work{gatherer_.make_inputs(tiles.most_dofs()),
                                                 TileSums(tiles.most_dofs(), plan.symmetric),
                                                 mean_forces_.make_step_tile(), FaultNote()}));
}

bool TileEvaluator::run(std::span<const double> x, const Request& request) {
  for (const FamilyGroup& group : tiles_.groups)
    if (!run_group(group, x, request)) return false;
  return true;
}

double TileEvaluator::energy() const {
  return std::accumulate(tile_energy_.begin(), tile_energy_.end(), 0.0);
}

/// Evaluates the tiles of a group. Tiles of one colour have no common nodes and run at the same time, one
/// colour after another. If only energies are requested, no two tiles write to the same entry, and all tiles
/// run at the same time.
bool TileEvaluator::run_group(const FamilyGroup& group, std::span<const double> x, const Request& request) {
  const Tiling& tiling = group.tiling;
  const auto run = [&](std::size_t begin, std::size_t end) {
    workers_.run(end - begin, kSerialBelow, [&](std::size_t worker, std::size_t i) {
      run_tile(group, tiling.order[begin + i], x, request, *works_[worker]);
    });
  };
  if (!request.residual && !request.values)
    run(0, tiling.tiles);
  else
    for (std::size_t c = 0; c + 1 < tiling.colour_begin.size(); ++c)
      run(tiling.colour_begin[c], tiling.colour_begin[c + 1]);
  return collect_faults();
}

bool TileEvaluator::run_carried(std::span<const double> x, const Request& request) {
  for (const FamilyGroup& group : tiles_.groups)
    for (const std::uint32_t tile : group.carried_tiles) run_tile(group, tile, x, request, *works_[0]);
  return collect_faults();
}

void TileEvaluator::run_tile(const FamilyGroup& group, std::size_t tile, std::span<const double> x,
                             const Request& request, Work& work) {
  const Tiling& tiling = group.tiling;
  TileSums& sums = work.sums;
  gatherer_.gather(group, tile, x, request.motion, work.inputs);
  if (request.between) mean_forces_.gather(tiling, tile, *request.between, work.step);
  sums.begin(request.energy != nullptr);
  if (!call_families(group, tile, true, request, work)) return;
  if (request.gradient) scatter_gradient(tiling, tile, sums, request.gradient);
  if (!request.conservative_only && !call_families(group, tile, false, request, work)) return;
  if (request.energy)
    tile_energy_[group.first_tile + tile] =
        std::accumulate(sums.energy, sums.energy + tiling.lanes(tile), 0.0);
  scatter(tiling, tile, tiles_.symmetric, sums, request.residual, request.values);
}

/// Calls terms of all families on a tile: the conservative terms if `with_energy`, otherwise all others.
/// Returns false if an element could not be evaluated.
bool TileEvaluator::call_families(const FamilyGroup& group, std::size_t tile, bool with_energy,
                                  const Request& request, Work& work) {
  for (const std::size_t family : group.families) {
    netloft_tile t = make_tile(family, tile, request.motion, work);
    int status = calls_.call(*tiles_.families[family], with_energy, t, request, work.sums);
    if (status == NETLOFT_OK && request.between && with_energy)
      status = mean_forces_.add(family, t, request, work.sums, work.step);
    if (status != NETLOFT_OK) {
      work.fault.keep(family, t, status);
      return false;
    }
  }
  return true;
}

netloft_tile TileEvaluator::make_tile(std::size_t family, std::size_t tile, const Kinematics& motion,
                                      Work& work) const {
  const ElementFamily& f = *tiles_.families[family];
  netloft_tile t = gatherer_.make_tile(f, tile, motion, work.inputs);
  ExtensionInputs& extensions = work.inputs.extensions;
  extensions.memory.state = memories_[family].kept(tile);
  extensions.memory.state_new = nullptr;
  extensions.hand_to(t, f.type().inputs);
  work.fault.begin(t);
  return t;
}

/// Reports the fault with the lowest element number, whichever thread found it.
bool TileEvaluator::collect_faults() {
  const FaultNote* first = nullptr;
  for (const auto& work : works_)
    if (work->fault.is_set() && (!first || work->fault.is_before(*first))) first = &work->fault;
  if (!first) return true;
  fault_ = first->fault();
  for (const auto& work : works_) work->fault.clear();
  return false;
}

int TileEvaluator::threads_used() const {
  for (const FamilyGroup& group : tiles_.groups)
    for (std::size_t c = 0; c + 1 < group.tiling.colour_begin.size(); ++c)
      if (group.tiling.colour_begin[c + 1] - group.tiling.colour_begin[c] >= kSerialBelow)
        return static_cast<int>(workers_.size());
  return 1;
}

}  // namespace netloft
