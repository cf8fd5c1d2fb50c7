// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/jonswap.hpp"

#include "io/scenes/water/dice.hpp"

#include <cmath>
#include <numbers>

namespace netloft::scenes {

namespace {

constexpr double kLowest = 0.4, kHighest = 5;  // range of f/f_p that the waves cover
constexpr std::size_t kSamples = 20001;        // of the integral; limits of bands are then accurate to 1e-6

/// For each sample of f/f_p, the energy of waves with lower frequencies as a fraction of the total energy, by
/// the trapezoidal rule.
std::vector<double> energy_below(double peakedness) {
  const double step = (kHighest - kLowest) / static_cast<double>(kSamples - 1);
  std::vector<double> sums(kSamples);
  double before = Jonswap::shape(kLowest, peakedness);
  for (std::size_t i = 1; i < kSamples; ++i) {
    const double here = Jonswap::shape(kLowest + static_cast<double>(i) * step, peakedness);
    sums[i] = sums[i - 1] + 0.5 * step * (before + here);
    before = here;
  }
  for (double& sum : sums) sum /= sums.back();
  return sums;
}

/// The ratio f/f_p below which the given fraction of the energy lies.
double ratio_of(const std::vector<double>& sums, double fraction) {
  const auto after = std::upper_bound(sums.begin() + 1, sums.end() - 1, fraction);
  const double place =
      static_cast<double>(after - sums.begin() - 1) + (fraction - after[-1]) / (*after - after[-1]);
  return kLowest + place * (kHighest - kLowest) / static_cast<double>(kSamples - 1);
}

}  // namespace

double Jonswap::shape(double ratio, double peakedness) {
  const double sigma = ratio <= 1 ? 0.07 : 0.09, off = (ratio - 1) / sigma;
  return std::pow(ratio, -5) * std::exp(-1.25 * std::pow(ratio, -4)) *
         std::pow(peakedness, std::exp(-0.5 * off * off));  // (1)
}

std::vector<AiryWaves::Component> sample(const Jonswap& spectrum) {
  const auto sums = energy_below(spectrum.peakedness);
  const auto count = static_cast<double>(spectrum.components);
  const double amplitude = spectrum.height / std::sqrt(8 * count);  // Σ a²/2 = H_s²/16, (2)
  Dice dice("waves", static_cast<std::uint64_t>(spectrum.seed));
  std::vector<AiryWaves::Component> all;
  for (std::int64_t i = 0; i < spectrum.components; ++i) {
    const double fraction = (static_cast<double>(i) + dice.uniform(0, 1)) / count;
    const double omega = 2 * std::numbers::pi * ratio_of(sums, fraction) / spectrum.period;
    all.push_back({amplitude, omega, dice.uniform(0, 2 * std::numbers::pi)});
  }
  return all;
}

}  // namespace netloft::scenes
