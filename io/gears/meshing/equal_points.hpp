// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

namespace netloft::gears {

/// Sets of identical points, built from pairs of points that are known to be identical (disjoint sets, Tarjan
/// 1975).
class EqualPoints {
 public:
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  bool are_one(std::size_t a, std::size_t b) { return root(a) == root(b); }
  std::size_t root(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace netloft::gears
