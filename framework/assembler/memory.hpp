// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cassert>
#include <cstddef>
#include <vector>

namespace netloft {

/// The state that the elements of one family (all elements of one type) remember from the last accepted step,
/// and their next state. The layout is [tile][width][64], so that a tile receives its part without a copy.
/// Before the first step, all numbers are zero.
class Memory {
 public:
  Memory(std::size_t tiles, std::size_t width)
      : stride_(width * NETLOFT_LANES), kept_(tiles * stride_, 0.0), next_(kept_) {}

  bool empty() const { return kept_.empty(); }
  const double* kept(std::size_t tile) const { return empty() ? nullptr : &kept_[place_of(tile)]; }
  double* mutable_kept(std::size_t tile) { return &kept_[place_of(tile)]; }
  /// The array to which a tile writes its next state. At first, it contains the current state.
  double* next(std::size_t tile) { return &next_[place_of(tile)]; }
  void begin() { next_ = kept_; }
  void accept() { kept_.swap(next_); }
  std::vector<double>& all() { return kept_; }
  const std::vector<double>& all() const { return kept_; }

 private:
  std::size_t place_of(std::size_t tile) const {
    assert((tile + 1) * stride_ <= kept_.size());
    return tile * stride_;
  }

  std::size_t stride_;
  std::vector<double> kept_, next_;
};

}  // namespace netloft
