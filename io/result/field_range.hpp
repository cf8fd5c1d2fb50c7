// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <vector>

namespace netloft::io {

/// Finds the range of a field over all of its states, so that a colour means the same in each.
class FieldRange {
 public:
  void take(const std::vector<double>& values);

  bool is_known() const { return lo_ <= hi_; }
  double lo() const { return lo_; }
  double hi() const { return hi_; }
  /// The value that a fiftieth of all lies below: where a logarithmic scale may begin, because a few slack
  /// elements with next to no tension would take up most of its colours.
  double low() const;

 private:
  double lo_ = INFINITY, hi_ = -INFINITY;
  std::vector<double> sample_;
};

}  // namespace netloft::io
