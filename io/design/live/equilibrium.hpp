// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/make_result.hpp"
#include "io/results/file/stored_shape.hpp"
#include "io/runs/prepared_scene.hpp"

#include <filesystem>
#include <memory>
#include <vector>

namespace netloft::design {

/// An equilibrium, and the scene to which it belongs.
struct Equilibrium {
  std::shared_ptr<runs::PreparedScene> scene;
  Solution solution;
  results::Result result;
  std::vector<double> points;  // positions of the nodes, 3 each [m]
};

/// Writes equilibria as result files, from which pictures are made, to a temporary private folder. The folder
/// is removed with this object.
class EquilibriumStore {
 public:
  EquilibriumStore();
  ~EquilibriumStore();
  EquilibriumStore(const EquilibriumStore&) = delete;
  EquilibriumStore& operator=(const EquilibriumStore&) = delete;

  /// Throws formats::FileError if the disk is full, for example.
  results::StoredShape shape_of(const Equilibrium& of) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace netloft::design
