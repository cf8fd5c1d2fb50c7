// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace netloft::pictures {

/// Red, green and blue from 0 to 1.
using Colour = std::array<float, 3>;

/// The colour map Viridis (S. van der Walt and N. Smith, matplotlib, CC0) at `place`, from 0 to 1. Its
/// brightness rises evenly, so that it also suits colour-blind readers and grey prints.
Colour colour_at(double place);
/// The evenly spaced colours between which colour_at() interpolates. Pages receive them as data.
const std::array<Colour, 9>& colour_stops();

/// One of eight colours that colour-blind readers can distinguish (M. Okabe and K. Ito, 2008); from the ninth
/// part on, colours repeat.
Colour colour_of_part(std::uint32_t part);
const std::array<Colour, 8>& part_colours();

// Colours of elements without a value of the shown field: netting and ropes; elements on single nodes, such
// as floats, which are usually orange; the catch; boards; the ship.
inline constexpr Colour kNoValue = {0.55f, 0.55f, 0.55f}, kFloatColour = {0.93f, 0.53f, 0.18f},
                        kCatchColour = {0.66f, 0.71f, 0.76f}, kBodyColour = {0.36f, 0.45f, 0.54f},
                        kShipColour = {0.72f, 0.33f, 0.27f};

/// The colour as hexadecimal text, "#21908d".
std::string hex(const Colour& colour);
/// The colour of a hexadecimal text, "#21908d" or "#222".
Colour colour_of(const std::string& hex);

}  // namespace netloft::pictures
