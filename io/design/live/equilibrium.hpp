// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/live/temporary_folder.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/results/file/stored_shape.hpp"
#include "io/runs/prepared_scene.hpp"

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

/// Writes equilibria as result files, from which pictures are made, to a temporary folder.
class EquilibriumStore {
 public:
  /// Throws formats::FileError if the disk is full, for example.
  results::StoredShape shape_of(const Equilibrium& of) const;

 private:
  TemporaryFolder folder_;
};

}  // namespace netloft::design
