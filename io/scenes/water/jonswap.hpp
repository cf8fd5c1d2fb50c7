// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/water/airy.hpp"

#include <cstdint>

namespace netloft::scenes {

/// The spectrum of a sea that the wind still makes grow (K. Hasselmann et al., "Measurements of wind-wave
/// growth and swell decay during the Joint North Sea Wave Project", Deutsche Hydrographische Zeitschrift A8
/// (12), 1973):
///   S(f) ~ f⁻⁵ exp(−5/4 (f_p/f)⁴) γ^exp(−(f/f_p − 1)²/(2 σ²)),  σ = 0.07 up to f_p, 0.09 above it     (1)
///   ∫ S df = H_s²/16                                                                                  (2)
struct Jonswap {
  double height = 0;        // H_s, significant [m]
  double period = 0;        // 1/f_p, of the peak [s]
  double peakedness = 3.3;  // γ, the mean of JONSWAP; 1 is Pierson and Moskowitz's
  std::int64_t components = 100, seed = 1;

  /// (1) over f/f_p, without its factor.
  static double shape(double ratio, double peakedness);
};

/// Waves of equal energy: (1) between 0.4 and 5 f_p, but for 0.2 % of its energy all of it, is cut into as
/// many bands, each one wave of a random frequency in it, so that the sea does not repeat, and of any phase.
/// Sampled by a generator of our own: a seed is the same sea on every machine. (2) holds as it stands.
std::vector<AiryWaves::Component> sample(const Jonswap& spectrum);

}  // namespace netloft::scenes
