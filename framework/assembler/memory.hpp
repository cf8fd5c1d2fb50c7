// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cstddef>
#include <vector>

namespace netloft {

/// What the elements of one family remember of the last accepted step, and what they would remember of the
/// next: [tile][width][64], so that a tile is handed its part as it stands. All zero: no past.
class Memory {
 public:
  Memory(std::size_t tiles, std::size_t width)
      : stride_(width * NETLOFT_LANES), kept_(tiles * stride_, 0.0), next_(kept_) {}

  bool empty() const { return kept_.empty(); }
  const double* kept(std::size_t tile) const { return empty() ? nullptr : &kept_[tile * stride_]; }
  /// Where a tile may write what it will remember; it finds there what it remembers now.
  double* next(std::size_t tile) { return &next_[tile * stride_]; }
  void begin() { next_ = kept_; }
  void accept() { kept_.swap(next_); }
  std::vector<double>& all() { return kept_; }
  const std::vector<double>& all() const { return kept_; }

 private:
  std::size_t stride_;
  std::vector<double> kept_, next_;
};

}  // namespace netloft
