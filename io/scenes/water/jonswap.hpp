// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/water/airy.hpp"

#include <cstdint>

namespace netloft::scenes {

/// The spectrum S(f) [m² s], over the frequency f [Hz], of a sea that is still growing under the wind (K.
/// Hasselmann et al., "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave
/// Project", Deutsche Hydrographische Zeitschrift A8 (12), 1973):
///   S(f) ~ f⁻⁵ exp(−5/4 (f_p/f)⁴) γ^exp(−(f/f_p − 1)²/(2 σ²)),  σ = 0.07 up to f_p, 0.09 above it     (1)
///   ∫ S df = H_s²/16                                                                                  (2)
struct Jonswap {
  double height = 0;        // significant wave height H_s [m]
  double period = 0;        // peak period 1/f_p [s]
  double peakedness = 3.3;  // γ; 3.3 is the mean of JONSWAP, 1 the spectrum of Pierson and Moskowitz
  std::int64_t components = 100, seed = 1;

  /// The shape (1) at `ratio` = f/f_p, without its factor.
  static double shape(double ratio, double peakedness);
};

/// Represents the spectrum by waves of equal energy. The frequencies from 0.4 to 5 f_p, which have all but
/// 0.2 % of the energy of (1), are divided into as many bands as there are waves. Each band gives one wave
/// with a random phase and a random frequency within the band, so that the sea does not repeat. The random
/// numbers come from Dice, so that a seed gives the same sea on every machine. The waves satisfy (2) exactly.
std::vector<AiryWaves::Component> sample(const Jonswap& spectrum);

}  // namespace netloft::scenes
