// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/calls.hpp"
#include "framework/assembler/element_tiles.hpp"
#include "framework/assembler/faults.hpp"
#include "framework/assembler/gather.hpp"
#include "framework/assembler/mean_forces.hpp"
#include "framework/assembler/workers.hpp"

#include <memory>
#include <span>
#include <vector>

namespace netloft {

/// Evaluates the elements of a scene in tiles of 64: gathers their inputs (gather.hpp), calls the terms of
/// all families that have these nodes (calls.hpp), corrects their forces to mean forces of a step
/// (mean_forces.hpp) and adds the forces to the sums (scatter.hpp). Forces are in the world frame and act on
/// the nodes of the elements: they are not yet passed on to bodies or rotated to nodes' own axes. Allocates
/// nothing after construction.
class TileEvaluator {
 public:
  /// `tiles` must outlive this object.
  TileEvaluator(const Scene& scene, const ScenePlan& plan, const ElementTiles& tiles, int threads);

  /// Adds all elements at positions x (over all dofs) to the forces and the matrix of a request. Returns
  /// false if an element could not be evaluated: see fault().
  bool run(std::span<const double> x, const Request& request);
  /// Energy [J] of the last run that computed one.
  double energy() const;
  /// The same as run(), but only for tiles with nodes that bodies carry.
  bool run_carried(std::span<const double> x, const Request& request);
  /// For each tile of one family, sets the forces of `t` to zero and calls evaluate(tile, t, sums), then
  /// visit(tile, t, sums). Runs on one thread. Returns false if `evaluate` does not return NETLOFT_OK: see
  /// fault().
  template <class Evaluate, class Visit>
  bool visit(std::span<const double> x, const Kinematics& motion, std::size_t family,
             const Evaluate& evaluate, const Visit& visit);

  /// Sets the memory [width][64] for the new state of one tile, the tile of the following call of visit().
  /// The terms write the new state there.
  void take_next_state(double* next) { works_[0]->inputs.extensions.memory.state_new = next; }

  const ElementFault& fault() const { return fault_; }
  const ElementTiles& tiles() const { return tiles_; }
  /// Number of threads used; 1 if the scene is too small to gain from more.
  int threads_used() const;
  std::vector<Memory>& memories() { return memories_; }
  MeanForces& mean_forces() { return mean_forces_; }

 private:
  /// The working memory of one thread.
  struct Work {
    TileInputs inputs;
    TileSums sums;
    StepTile step;
    FaultNote fault;
  };
  bool run_group(const FamilyGroup& group, std::span<const double> x, const Request& request);
  void run_tile(const FamilyGroup& group, std::size_t tile, std::span<const double> x, const Request& request,
                Work& work);
  bool call_families(const FamilyGroup& group, std::size_t tile, bool with_energy, const Request& request,
                     Work& work);
  netloft_tile make_tile(std::size_t family, std::size_t tile, const Kinematics& motion, Work& work) const;
  bool collect_faults();

  const ElementTiles& tiles_;
  Gatherer gatherer_;
  TermCalls calls_;
  MeanForces mean_forces_;
  std::vector<Memory> memories_;     // memory of each family
  std::vector<double> tile_energy_;  // [J]
  Workers workers_;
  std::vector<std::unique_ptr<Work>> works_;
  ElementFault fault_;
};

template <class Evaluate, class Visit>
bool TileEvaluator::visit(std::span<const double> x, const Kinematics& motion, std::size_t family,
                          const Evaluate& evaluate, const Visit& visit) {
  const FamilyGroup& group = tiles_.group_of(family);
  const auto dofs = static_cast<std::size_t>(tiles_.families[family]->type().dofs());
  Work& work = *works_[0];
  for (std::size_t tile = 0; tile < group.tiling.tiles; ++tile) {
    gatherer_.gather(group, tile, x, motion, work.inputs);
    netloft_tile t = make_tile(family, tile, motion, work);
    work.sums.begin(true);
    t.force = work.sums.force.open(dofs, t.count);
    t.want = NETLOFT_WANT_FORCE;
    if (const int status = evaluate(tile, t, work.sums); status != NETLOFT_OK) {
      work.fault.keep(family, t, status);
      return collect_faults();
    }
    visit(tile, t, work.sums);
  }
  return true;
}

}  // namespace netloft
