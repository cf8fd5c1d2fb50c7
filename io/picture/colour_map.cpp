// SPDX-License-Identifier: BSD-3-Clause
#include "io/picture/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace netloft::io {

namespace {

constexpr double kDecades = 1e-4;  // of the largest value: the least one of a logarithmic scale

Colour from_hex(std::uint32_t rgb) {
  return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
          static_cast<float>(rgb & 255) / 255};
}

}  // namespace

Colour colour_at(double place) {
  static const std::array<std::uint32_t, 9> stops = {0x440154, 0x472c7a, 0x3b518b, 0x2c718e, 0x21908d,
                                                     0x27ad81, 0x5cc863, 0xaadc32, 0xfde725};
  const double at = std::clamp(place, 0.0, 1.0) * (stops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const Colour a = from_hex(stops[k]), b = from_hex(stops[k + 1]);
  const float t = static_cast<float>(at - static_cast<double>(k));
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Colour colour_of_part(std::uint32_t part) {
  static const std::array<std::uint32_t, 8> colours = {0x56b4e9, 0xe69f00, 0x009e73, 0xf0e442,
                                                       0x0072b2, 0xd55e00, 0xcc79a7, 0x999999};
  return from_hex(colours[part % colours.size()]);
}

std::string hex(const Colour& colour) {
  const auto byte = [](float c) { return static_cast<int>(std::lround(255 * std::clamp(c, 0.0f, 1.0f))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

ColourScale::ColourScale(double lo, double hi, bool logarithmic)
    : logarithmic_(logarithmic && hi > 0), lo_(logarithmic_ ? std::max(lo, hi * kDecades) : lo), hi_(hi) {
  if (!(hi_ > lo_)) hi_ = lo_ + (lo_ == 0 ? 1 : std::abs(lo_));
}

double ColourScale::place(double value) const {
  return logarithmic_ ? std::log(std::max(value, lo_) / lo_) / std::log(hi_ / lo_)
                      : (value - lo_) / (hi_ - lo_);
}

double ColourScale::value(double place) const {
  return logarithmic_ ? lo_ * std::pow(hi_ / lo_, place) : lo_ + place * (hi_ - lo_);
}

}  // namespace netloft::io
