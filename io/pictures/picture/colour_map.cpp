// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr Colour from_hex(std::uint32_t rgb) {
  return {static_cast<float>(rgb >> 16 & 255) / 255, static_cast<float>(rgb >> 8 & 255) / 255,
          static_cast<float>(rgb & 255) / 255};
}

}  // namespace

const std::array<Colour, 9>& colour_stops() {
  static constexpr std::array<Colour, 9> stops = {from_hex(0x440154), from_hex(0x472c7a), from_hex(0x3b518b),
                                                  from_hex(0x2c718e), from_hex(0x21908d), from_hex(0x27ad81),
                                                  from_hex(0x5cc863), from_hex(0xaadc32), from_hex(0xfde725)};
  return stops;
}

const std::array<Colour, 8>& part_colours() {
  static constexpr std::array<Colour, 8> colours = {
      from_hex(0x56b4e9), from_hex(0xe69f00), from_hex(0x009e73), from_hex(0xf0e442),
      from_hex(0x0072b2), from_hex(0xd55e00), from_hex(0xcc79a7), from_hex(0x999999)};
  return colours;
}

Colour colour_at(double place) {
  const auto& stops = colour_stops();
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const Colour &a = stops[k], &b = stops[k + 1];
  const float t = static_cast<float>(at - static_cast<double>(k));
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Colour colour_of_part(std::uint32_t part) { return part_colours()[part % part_colours().size()]; }

std::string hex(const Colour& colour) {
  const auto byte = [](float c) { return static_cast<int>(std::lround(255 * std::clamp(c, 0.0f, 1.0f))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

Colour colour_of(const std::string& hex) {
  std::string digits = hex.substr(1);
  if (digits.size() == 3) digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  assert(digits.size() == 6);
  return from_hex(static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16)));
}

}  // namespace netloft::pictures
