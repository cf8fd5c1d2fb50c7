// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/march_settings.hpp"

#include <cstddef>
#include <vector>

namespace netloft {

/// The times at which outputs are written and steps end.
class MarchTimes {
 public:
  /// `corners`: times at which the rate of a prescribed motion jumps [s].
  MarchTimes(const MarchSettings& settings, std::vector<double> corners);

  std::size_t output_count() const;
  double output(std::size_t i) const;
  /// Whether a march with these settings has an output at time t of another march.
  bool is_output(double t) const;
  /// The next time after t at which a step must end. A time that differs from t only by rounding is skipped.
  double next_corner(double t) const;

 private:
  const MarchSettings& settings_;
  std::vector<double> corners_;  // corners, including outputs if steps end at outputs
};

}  // namespace netloft
