// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/meshes.hpp"

#include "io/formats/work/long_work.hpp"
#include "io/runs/coarser.hpp"

#include <utility>

namespace netloft::runs {

namespace {

// Limit of coarser levels: the number of cells is an int and cannot be halved more often.
constexpr unsigned kMostLevels = 32;

/// Gives the free nodes of the coarse scene their initial positions, interpolated from those of the finer
/// scene. Held nodes do not move. Returns false if the scenes do not have the same parts.
bool start_like(const scenes::LoadedScene& finer, scenes::LoadedScene& coarse) {
  const auto positions = carried_over(finer, finer.scene.positions, coarse);
  if (!positions) return false;
  for (std::size_t d = 0; d < positions->size(); ++d)
    if (coarse.scene.held[d / 3] == 0) coarse.scene.positions[d] = (*positions)[d];
  return true;
}

}  // namespace

Meshes::Meshes(const CaseSource& source, const scenes::LoadedScene& finest, Registry& registry)
    : source_(source),
      finest_(finest),
      registry_(registry),
      most_(halved_cells(finest, Halved::all).empty() ? 1 : kMostLevels) {}

const Scene* Meshes::scene(unsigned level) {
  const scenes::LoadedScene* const found = loaded(level);
  return found ? &found->scene : nullptr;
}

const scenes::LoadedScene* Meshes::loaded(unsigned level) {
  if (level == 0) return &finest_;
  if (level >= most_) return nullptr;
  const scenes::LoadedScene* const finer = loaded(level - 1);
  if (!finer) return nullptr;
  if (coarser_.size() < level) coarser_.push_back(read_coarser(*finer));
  return coarser_[level - 1].get();
}

/// Halves the cells of all parts. If the parts then no longer fit, halves the cells only of parts with even
/// numbers of cells.
std::unique_ptr<scenes::LoadedScene> Meshes::read_coarser(const scenes::LoadedScene& finer) {
  for (const Halved which : {Halved::all, Halved::even_only})
    if (auto coarse = read_halved(finer, halved_cells(finer, which))) return coarse;
  return nullptr;
}

std::unique_ptr<scenes::LoadedScene> Meshes::read_halved(const scenes::LoadedScene& finer,
                                                         const std::vector<formats::Change>& halved) {
  if (halved.empty()) return nullptr;
  std::vector<formats::Change> changes = source_.changes;
  formats::append(changes, halved);
  formats::Diagnostics diagnostics;
  bool refused = false;
  try {
    auto coarse = std::make_unique<scenes::LoadedScene>(
        source_.scene.instance(changes, registry_, diagnostics, refused));
    if (refused || diagnostics.errors() || !start_like(finer, *coarse)) return nullptr;
    source_.changes = std::move(changes);
    return coarse;
  } catch (const formats::Interrupted&) {
    return nullptr;  // the search is interrupted and does not need this mesh
  }
}

std::vector<double> Meshes::carry(unsigned from, std::span<const double> positions, unsigned to) {
  const scenes::LoadedScene *const source = loaded(from), *const target = loaded(to);
  if (!source || !target) return {};
  return carried_over(*source, {positions.begin(), positions.end()}, *target).value_or(std::vector<double>{});
}

}  // namespace netloft::runs
