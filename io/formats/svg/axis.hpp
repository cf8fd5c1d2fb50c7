// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace netloft::formats {

/// One axis of a plot: determines where on the axis values and ticks are drawn.
class Axis {
 public:
  struct Tick {
    double value;
    bool labelled;
  };

  virtual ~Axis() = default;
  virtual bool has_place(double value) const = 0;
  /// The position of a value: 0 at the low end, 1 at the high end.
  virtual double place(double value) const = 0;

  double low() const { return low_; }
  double high() const { return high_; }
  const std::vector<Tick>& ticks() const { return ticks_; }
  bool labels_powers() const { return labels_powers_; }

 protected:
  double low_ = 0, high_ = 1;
  bool labels_powers_ = false;
  std::vector<Tick> ticks_;
};

}  // namespace netloft::formats
