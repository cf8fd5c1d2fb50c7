// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Coarser meshes of a scene. What divides parts into cells is known to whoever read the scene; a search only
/// asks for scenes by their level and for positions read from one on another.
class Levels {
 public:
  virtual ~Levels() = default;
  /// Meshes there may be, at least one. A level below it need not exist: `scene` says.
  virtual unsigned most() const = 0;
  /// The scene on a level; 0 is the scene's own mesh. Null: there is no such level.
  virtual const Scene* scene(unsigned level) = 0;
  /// Positions of the nodes of one level [m], 3 per node, read off those of another one. Empty: the two are
  /// not divisions of the same parts.
  virtual std::vector<double> carry(unsigned from, std::span<const double> positions, unsigned to) = 0;
};

}  // namespace netloft
