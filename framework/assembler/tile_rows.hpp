// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/lanes.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

/// Rows of 64 numbers to which the terms of a tile (64 elements) add. When the first term opens rows, they
/// are set to zero in the lanes of the tile, unless the previous tile left them zero. Rows that no term opens
/// cost no time. Numbers that a term wrongly wrote beyond the last lane are cleared before they are used.
class TileRows {
 public:
  explicit TileRows(std::size_t rows) : all_(rows * kTileLanes) {}

  double* data() { return all_.data(); }
  const double* data() const { return all_.data(); }

  void begin() { rows_ = 0; }
  /// Opens the first `rows` rows in the first `lanes` lanes for a term to add to; all terms of a tile use the
  /// same number of lanes.
  double* open(std::size_t rows, std::size_t lanes) {
    assert(rows * kTileLanes <= all_.size() && lanes <= kTileLanes);
    if (rows > rows_) {
      set_zero(rows_, rows, lanes);
      rows_ = rows;
      zero_rows_ = 0;
    }
    lanes_ = lanes;
    return all_.data();
  }
  /// Whether some term of this tile has opened rows.
  bool is_open() const { return rows_ > 0; }
  /// Whether every number that the terms of this tile added is zero.
  bool is_zero() {
    for (std::size_t row = 0; row < rows_; ++row)
      if (!is_zero(all_.data() + row * kTileLanes)) return false;
    if (rows_ > 0) {
      zero_rows_ = rows_;
      zero_lanes_ = lanes_;
    }
    return true;
  }

 private:
  // set_zero() sets kAtOnce rows (2 KiB) to zero in each call of std::fill: libraries fill an area of this
  // size with plain stores, but a larger one with instructions that take long to start. Clearing row by row
  // would need too many calls. With up to kManyLanes lanes, rows are cleared eight numbers at a time.
  static constexpr std::size_t kAtOnce = 4, kManyLanes = 48, kEight = 8;

  void set_zero(std::size_t begin, std::size_t end, std::size_t lanes) {
    if (lanes <= zero_lanes_) begin = std::max(begin, zero_rows_);
    double *from = all_.data() + begin * kTileLanes, *to = all_.data() + end * kTileLanes;
    if (lanes > kManyLanes)
      for (; from < to; from += kAtOnce * kTileLanes)
        std::fill(from, std::min(from + kAtOnce * kTileLanes, to), 0.0);
    else
      for (std::size_t lane = 0; lane < lanes; lane += kEight)
        for (double* row = from; row < to; row += kTileLanes) std::fill_n(row + lane, kEight, 0.0);
  }
  bool is_zero(const double* row) const {
    constexpr std::size_t kApart = 8;  // number of independent accumulators
    std::uint64_t some[kApart] = {};   // integers, which the compiler can vectorise
    std::size_t lane = 0;
    for (; lane + kApart <= lanes_; lane += kApart)
      for (std::size_t i = 0; i < kApart; ++i) some[i] |= std::bit_cast<std::uint64_t>(row[lane + i]);
    for (; lane < lanes_; ++lane) some[0] |= std::bit_cast<std::uint64_t>(row[lane]);
    std::uint64_t bits = 0;
    for (const std::uint64_t others : some) bits |= others;
    return bits << 1 == 0;  // shifting out the sign makes -0.0 count as zero, too
  }

  std::vector<double> all_;
  std::size_t rows_ = 0, lanes_ = 0;            // rows and lanes that this tile has opened
  std::size_t zero_rows_ = 0, zero_lanes_ = 0;  // rows and lanes that the previous tile left zero
};

}  // namespace netloft
