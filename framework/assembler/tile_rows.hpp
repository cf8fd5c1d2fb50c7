// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft {

/// Rows of NETLOFT_LANES numbers that the terms of a tile add to, zero whenever a tile begins. Only rows that
/// the tile before may have left something in are set to zero again, whole: what no term asks for costs
/// nothing, and what one wrongly wrote beyond the last lane is gone before it is seen.
class TileRows {
 public:
  explicit TileRows(std::size_t rows) : all_((rows + kAtOnce - 1) / kAtOnce * kAtOnce * kWidth) {}

  double* data() { return all_.data(); }
  const double* data() const { return all_.data(); }

  /// Zeros for the next tile.
  void clear() {
    for (std::size_t row = 0; row < rows_; row += kAtOnce)
      std::fill_n(all_.data() + row * kWidth, kAtOnce * kWidth, 0.0);
    rows_ = 0;
  }
  /// For a term that adds to the first `rows` rows in the first `lanes` lanes, as many for all terms of a
  /// tile.
  double* open(std::size_t rows, std::size_t lanes) {
    rows_ = std::max(rows_, rows), lanes_ = lanes;
    return all_.data();
  }
  /// Whether this tile has added nothing; a full one then leaves nothing to set to zero.
  bool is_zero() {
    for (std::size_t row = 0; row < rows_; ++row)
      if (!is_zero(all_.data() + row * kWidth)) return false;
    if (lanes_ == kWidth) rows_ = 0;
    return true;
  }

 private:
  static constexpr std::size_t kWidth = NETLOFT_LANES;
  // Rows set to zero by one call: 2 KiB, of which libraries make plain stores. For more they take
  // instructions that are slow to begin, and row by row the calls count.
  static constexpr std::size_t kAtOnce = 4;

  bool is_zero(const double* row) const {
    constexpr std::size_t kApart = 8;  // none waits for the one before
    std::uint64_t some[kApart] = {};   // of integers the compiler makes vectors
    std::size_t lane = 0;
    for (; lane + kApart <= lanes_; lane += kApart)
      for (std::size_t i = 0; i < kApart; ++i) some[i] |= std::bit_cast<std::uint64_t>(row[lane + i]);
    for (; lane < lanes_; ++lane) some[0] |= std::bit_cast<std::uint64_t>(row[lane]);
    std::uint64_t bits = 0;
    for (const std::uint64_t others : some) bits |= others;
    return bits << 1 == 0;  // whatever the signs
  }

  std::vector<double> all_;
  std::size_t rows_ = 0, lanes_ = 0;  // beyond these rows all is zero, beyond these lanes it should be
};

}  // namespace netloft
