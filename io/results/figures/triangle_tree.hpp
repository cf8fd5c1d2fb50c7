// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace netloft::results {

/// A box with edges along the axes [m].
struct AxisBox {
  std::array<double, 3> low, high;

  static AxisBox none() {
    constexpr double far = std::numeric_limits<double>::infinity();
    return {{far, far, far}, {-far, -far, -far}};
  }
  void include(const double* x) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
    }
  }
  bool meets(const AxisBox& other) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (low[axis] > other.high[axis] || other.low[axis] > high[axis]) return false;
    return true;
  }
};

/// A tree of boxes round triangles, each divided in two at the median along its longest side. It answers
/// which triangles may meet a given box, in a time that grows with the logarithm of their number.
class TriangleTree {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// The triangles and the positions of their nodes must outlive the tree.
  TriangleTree(std::span<const Triangle> triangles, std::span<const double> positions)
      : triangles_(triangles), positions_(positions), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    for (const Triangle& t : triangles) {
      boxes_.push_back(AxisBox::none());
      for (const auto node : t) boxes_.back().include(&positions_[3 * std::size_t{node}]);
    }
    if (!order_.empty()) divide(0, order_.size());
  }

  /// Calls visit(index of the triangle) for every triangle whose box meets the given box.
  template <class Visit>
  void visit(const AxisBox& box, Visit&& visit) const {
    if (!branches_.empty()) descend(0, box, visit);
  }

 private:
  static constexpr std::size_t kOfLeaf = 8;  // most triangles of a branch that is not divided further

  struct Branch {
    AxisBox box;
    std::size_t begin, end;
    std::size_t left = 0, right = 0;  // 0: none
  };

  std::size_t divide(std::size_t begin, std::size_t end) {
    const std::size_t own = branches_.size();
    branches_.push_back({AxisBox::none(), begin, end});
    AxisBox box = AxisBox::none();
    for (std::size_t k = begin; k < end; ++k) {
      box.include(boxes_[order_[k]].low.data());
      box.include(boxes_[order_[k]].high.data());
    }
    branches_[own].box = box;
    if (end - begin <= kOfLeaf) return own;
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (box.high[a] - box.low[a] > box.high[axis] - box.low[axis]) axis = a;
    const auto middle = [&](std::uint32_t t) { return boxes_[t].low[axis] + boxes_[t].high[axis]; };
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(half), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
    });
    const std::size_t left = divide(begin, half), right = divide(half, end);
    branches_[own].left = left;
    branches_[own].right = right;
    return own;
  }

  template <class Visit>
  void descend(std::size_t branch, const AxisBox& box, Visit& visit) const {
    const Branch& b = branches_[branch];
    if (!b.box.meets(box)) return;
    if (b.left == 0)
      for (std::size_t k = b.begin; k < b.end; ++k) {
        if (boxes_[order_[k]].meets(box)) visit(order_[k]);
      }
    else
      descend(b.left, box, visit), descend(b.right, box, visit);
  }

  std::span<const Triangle> triangles_;
  std::span<const double> positions_;
  std::vector<std::uint32_t> order_;
  std::vector<AxisBox> boxes_;
  std::vector<Branch> branches_;
};

}  // namespace netloft::results
