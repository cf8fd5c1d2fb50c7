// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/geometry.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace netloft::scenes {

/// Makes the nodes of a scene from the nodes of its parts. Nodes that are joined become one node, at the
/// position of the first of them.
class Joiner {
 public:
  /// Some nodes of one part, by their numbers within the part ("own" numbers).
  struct Ends {
    std::size_t part;
    std::vector<std::uint32_t> own;
  };

  explicit Joiner(const std::vector<Geometry>& geometries) : geometries_(geometries) {
    std::uint32_t next = 0;
    for (const auto& g : geometries) {
      first_.push_back(next);
      next += static_cast<std::uint32_t>(g.node_count());
    }
    leader_.resize(next);
    std::iota(leader_.begin(), leader_.end(), 0u);
  }

  /// A node, by its part and its number within the part.
  using OwnNode = std::pair<std::size_t, std::uint32_t>;

  /// Merges two nodes into one.
  void join(const OwnNode& one, const OwnNode& other) {
    const auto a = find(first_[one.first] + one.second), b = find(first_[other.first] + other.second);
    leader_[std::max(a, b)] = std::min(a, b);
  }

  /// For each i, merges the nodes with index i of all sets into one node.
  void join(const std::vector<Ends>& sets) {
    for (std::size_t s = 1; s < sets.size(); ++s)
      for (std::size_t i = 0; i < sets[0].own.size(); ++i)
        join({sets[0].part, sets[0].own[i]}, {sets[s].part, sets[s].own[i]});
  }

  /// Merges all nodes of all sets into one node at their mean position, as when netting is gathered.
  void gather(const std::vector<Ends>& sets) {
    std::vector<std::uint32_t> nodes;
    for (const auto& set : sets)
      for (const auto own : set.own) nodes.push_back(find(first_[set.part] + own));
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const auto node : nodes) leader_[node] = nodes[0];
    gathered_.push_back(std::move(nodes));
  }

  /// An element two of whose nodes are joined, so that it has no size.
  struct Collapse {
    std::size_t part, element;
  };
  std::optional<Collapse> find_collapse(const std::vector<int>& nodes_per_element) {
    std::set<std::uint32_t> gathered;  // leaders of the nodes in which netting is gathered
    for (const auto& nodes : gathered_) gathered.insert(find(nodes[0]));
    std::vector<std::uint32_t> corners;
    for (std::size_t p = 0; p < geometries_.size(); ++p) {
      const auto width = static_cast<std::size_t>(nodes_per_element[p]);
      const auto& own = geometries_[p].elements;
      for (std::size_t i = 0; i < own.size(); i += width) {
        corners.clear();
        for (std::size_t k = i; k < i + width; ++k) corners.push_back(find(first_[p] + own[k]));
        if (is_collapsed(corners, gathered)) return Collapse{p, i / width};
      }
    }
    return std::nullopt;
  }

  /// Numbers the nodes that remain after joins, and fills positions, labels and `held` of the scene.
  void number(Scene& scene) {
    number_.assign(leader_.size(), 0);
    scene.positions.reserve(3 * leader_.size());
    scene.labels.reserve(leader_.size());
    scene.held.reserve(leader_.size());
    std::uint32_t node = 0;
    for (std::uint32_t p = 0; p < geometries_.size(); ++p)
      for (std::uint32_t own = 0; own < geometries_[p].node_count(); ++own, ++node) {
        if (const auto leader = find(node); leader != node) {
          number_[node] = number_[leader];
          continue;
        }
        number_[node] = static_cast<std::uint32_t>(scene.held.size());
        for (std::size_t k = 3 * std::size_t{own}, end = k + 3; k < end; ++k)
          scene.positions.push_back(geometries_[p].positions[k]);
        scene.labels.push_back({p, own});
        scene.held.push_back(0);
      }
    for (const auto& nodes : gathered_) place_in_the_middle(nodes, scene);
  }

  /// The numbers in the scene of all nodes of a part, in the order of their numbers within the part.
  std::vector<std::uint32_t> nodes(std::size_t part) const {
    const auto begin = number_.begin() + first_[part];
    return {begin, begin + static_cast<std::ptrdiff_t>(geometries_[part].node_count())};
  }

 private:
  std::uint32_t find(std::uint32_t node) {
    while (leader_[node] != node) node = leader_[node] = leader_[leader_[node]];
    return node;
  }

  /// Whether joins have merged corners of an element, so that a bar has no length or a triangle no area. A
  /// triangle of gathered netting, two of whose corners are the same node, does not count.
  static bool is_collapsed(const std::vector<std::uint32_t>& corners,
                           const std::set<std::uint32_t>& gathered) {
    std::size_t twins = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (corners[i] == corners[k] && (++twins > 1 || corners.size() < 3 || !gathered.contains(corners[i])))
          return true;
    return false;
  }

  const double* position(std::uint32_t node) const {
    const auto part =
        static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), node) - first_.begin() - 1);
    return &geometries_[part].positions[3 * std::size_t{node - first_[part]}];
  }

  void place_in_the_middle(const std::vector<std::uint32_t>& nodes, Scene& scene) const {
    double* x = &scene.positions[3 * std::size_t{number_[nodes[0]]}];
    std::fill_n(x, 3, 0.0);
    for (const auto node : nodes)
      for (int axis = 0; axis < 3; ++axis) x[axis] += position(node)[axis] / double(nodes.size());
  }

  const std::vector<Geometry>& geometries_;
  std::vector<std::uint32_t> first_, leader_, number_;
  std::vector<std::vector<std::uint32_t>> gathered_;
};

}  // namespace netloft::scenes
