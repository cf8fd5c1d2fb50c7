// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/march_settings.hpp"

#include <cstddef>
#include <vector>

namespace netloft {

/// When outputs of a march are written, and where its steps end.
class MarchTimes {
 public:
  /// `corners`: times at which what moves the scene has corners [s].
  MarchTimes(const MarchSettings& settings, std::vector<double> corners);

  std::size_t output_count() const;
  double output(std::size_t i) const;
  /// Whether an output of another march, which may be at other times, is one of this, too.
  bool is_output(double t) const;
  /// The next end of a step after t, leaving out those that rounding alone has left.
  double next_corner(double t) const;

 private:
  const MarchSettings& settings_;
  std::vector<double> corners_;  // outputs among them, unless those are between steps
};

}  // namespace netloft
