// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace netloft::gears {

/// Pieces of netting that are known to have the same face outwards, or opposite faces (disjoint sets with
/// parity). If two statements about faces contradict each other, the net is twisted and has no outside.
class Faces {
 public:
  explicit Faces(std::size_t pieces) : parent_(pieces), is_turned_(pieces, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Returns the representative of the connected pieces, and whether it and `piece` show opposite faces.
  std::pair<std::size_t, bool> root(std::size_t piece) const {
    bool is_turned = false;
    for (; parent_[piece] != piece; piece = parent_[piece]) is_turned = is_turned != is_turned_[piece];
    return {piece, is_turned};
  }

  /// States that two pieces show the same face outwards, or opposite faces if `turned`. Returns false if this
  /// contradicts an earlier statement.
  bool state(std::size_t a, std::size_t b, bool turned) {
    const auto one = root(a), other = root(b);
    if (one.first == other.first) return (one.second != other.second) == turned;
    parent_[one.first] = other.first;
    is_turned_[one.first] = (one.second != other.second) != turned;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> is_turned_;  // relative to the parent
};

}  // namespace netloft::gears
