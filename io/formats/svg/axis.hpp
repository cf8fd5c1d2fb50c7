// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace netloft::formats {

/// One direction of a plot: the position of a value, and the ticks.
class Axis {
 public:
  struct Tick {
    double value;
    bool labelled;
  };

  virtual ~Axis() = default;
  /// Whether a value can be drawn at all.
  virtual bool has_place(double value) const = 0;
  /// 0 at the low end, 1 at the high one.
  virtual double place(double value) const = 0;

  double low() const { return low_; }
  double high() const { return high_; }
  const std::vector<Tick>& ticks() const { return ticks_; }
  /// Whether labels are powers of ten.
  bool labels_powers() const { return labels_powers_; }

 protected:
  double low_ = 0, high_ = 1;
  bool labels_powers_ = false;
  std::vector<Tick> ticks_;
};

}  // namespace netloft::formats
