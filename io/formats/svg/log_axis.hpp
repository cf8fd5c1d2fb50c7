// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/axis.hpp"

#include <span>

namespace netloft::formats {

/// A logarithmic axis that includes all values with a margin, and its ticks.
///   place(v) = (lg v − lg low)/(lg high − lg low)                                          (1)
/// Its ends are integer multiples of powers of ten. Every power of ten has a label, or every second, third …
/// if there are many. If fewer than two powers of ten are on the axis, 2 and 5 times a power have labels,
/// too.
class LogAxis : public Axis {
 public:
  /// `values` that are not positive and finite are ignored. `most_labels` is the number of labels that fit.
  explicit LogAxis(std::span<const double> values, int most_labels = 6);

  bool has_place(double value) const override;
  double place(double value) const override;

 private:
  void find_ends(std::span<const double> values);
  void find_ticks(int most_labels);
};

}  // namespace netloft::formats
