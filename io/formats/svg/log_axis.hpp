// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/axis.hpp"

#include <span>

namespace netloft::formats {

/// A logarithmic axis that includes all values with a margin, and its ticks.
///   place(v) = (lg v − lg low)/(lg high − lg low)                                          (1)
/// Its ends are whole multiples of powers of ten. Ticks with a label are powers of ten, every second, third …
/// of them when there are many; an axis with fewer than two of these labels 2 and 5 as well.
class LogAxis : public Axis {
 public:
  /// Values that are not positive and finite are ignored. `most_labels` is the number of labels that fit.
  explicit LogAxis(std::span<const double> values, int most_labels = 6);

  bool has_place(double value) const override;
  double place(double value) const override;

 private:
  void find_ends(std::span<const double> values);
  void find_ticks(int most_labels);
};

}  // namespace netloft::formats
