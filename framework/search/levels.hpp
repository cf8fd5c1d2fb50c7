// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Coarser meshes of a scene. Only the reader of the scene knows how parts are divided into cells. A search
/// therefore gets the scene of a level, and positions interpolated between levels, from this class.
class Levels {
 public:
  virtual ~Levels() = default;
  /// Largest possible number of meshes, at least one. Some levels may not exist; `scene` returns nullptr for
  /// such a level.
  virtual unsigned most() const = 0;
  /// The scene on a level; 0 is the original mesh. nullptr if the level does not exist.
  virtual const Scene* scene(unsigned level) = 0;
  /// Interpolates positions of the nodes of one level [m], 3 per node, to the nodes of another level. Returns
  /// an empty vector if the meshes do not divide the same parts.
  virtual std::vector<double> carry(unsigned from, std::span<const double> positions, unsigned to) = 0;
};

}  // namespace netloft
