// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

namespace netloft::io {

/// A logarithmic axis that includes all values with a margin, and its ticks.
///   place(v) = (lg v − lg low)/(lg high − lg low)                                          (1)
/// Its ends are whole multiples of powers of ten. Ticks with a label are powers of ten, every second, third …
/// of them when there are many; an axis with fewer than two of these labels 2 and 5 as well.
class LogAxis {
 public:
  struct Tick {
    double value;
    bool labelled;
  };

  /// Values that are not positive and finite are ignored. `most_labels` is the number of labels that fit.
  explicit LogAxis(std::span<const double> values, int most_labels = 6);

  double low() const { return low_; }
  double high() const { return high_; }
  /// 0 at the low end, 1 at the high one; `value` > 0.
  double place(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  /// Whether only powers of ten have a label.
  bool labels_powers() const { return labels_powers_; }

 private:
  void find_ends(std::span<const double> values);
  void find_ticks(int most_labels);

  double low_ = 1, high_ = 10;
  bool labels_powers_ = true;
  std::vector<Tick> ticks_;
};

}  // namespace netloft::io
