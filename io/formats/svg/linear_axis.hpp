// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/axis.hpp"

#include <span>

namespace netloft::formats {

/// A linear axis that includes all values with a margin.
///   place(v) = (v − low)/(high − low)                                                      (1)
/// Ticks are at integer multiples of 1, 2 or 5 times a power of ten; all ticks have labels.
class LinearAxis : public Axis {
 public:
  /// `values` that are not finite are ignored. `most_labels` is the number of labels that fit.
  explicit LinearAxis(std::span<const double> values, int most_labels = 7);

  bool has_place(double value) const override;
  double place(double value) const override;

 private:
  void find_ticks(int most_labels);
};

}  // namespace netloft::formats
