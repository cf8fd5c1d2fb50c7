// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/search/levels.hpp"
#include "io/runs/prepared_scene.hpp"

#include <memory>

namespace netloft::runs {

/// The meshes of a scene for strategies that start on coarse meshes. Level 0 is the scene itself; on each
/// further level, parts have half as many cells along a side, if the cells can be halved (coarser.hpp). A
/// mesh is read on first use.
class Meshes : public Levels {
 public:
  Meshes(const CaseSource& source, const scenes::LoadedScene& finest, Registry& registry);

  unsigned most() const override { return most_; }
  const Scene* scene(unsigned level) override;
  std::vector<double> carry(unsigned from, std::span<const double> positions, unsigned to) override;

 private:
  const scenes::LoadedScene* loaded(unsigned level);
  std::unique_ptr<scenes::LoadedScene> read_coarser(const scenes::LoadedScene& finer);
  std::unique_ptr<scenes::LoadedScene> read_halved(const scenes::LoadedScene& finer,
                                                   const std::vector<formats::Change>& halved);

  CaseSource source_;  // source of the coarsest mesh read so far
  const scenes::LoadedScene& finest_;
  Registry& registry_;
  unsigned most_;
  // The scenes of levels 1, 2, …; nullptr if the level does not exist.
  std::vector<std::unique_ptr<scenes::LoadedScene>> coarser_;
};

}  // namespace netloft::runs
