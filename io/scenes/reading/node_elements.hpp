// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/scene/scene.hpp"

#include <span>

namespace netloft::scenes {

/// The elements at each node of a scene. With this list, the time to make a rider (a part on other parts)
/// does not depend on the number of parts of the scene.
class NodeElements {
 public:
  /// An element, by the index of its part and its number within that part.
  struct At {
    std::uint32_t part, element;
  };

  /// `types` contains the element type of each part. Parts of an unknown type (nullptr) have no elements
  /// here.
  NodeElements(const Scene& scene, const std::vector<const ElementType*>& types);

  /// The elements at a node, part by part. An element with several corners at the node is listed once for
  /// each corner.
  std::span<const At> at(std::uint32_t node) const;
  /// The elements of one part at a node.
  std::span<const At> at(std::uint32_t node, std::size_t part) const;

 private:
  std::vector<std::size_t> begins_;  // index of the first element of each node, and the end
  std::vector<At> all_;
};

}  // namespace netloft::scenes
