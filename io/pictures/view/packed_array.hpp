// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>

namespace netloft::pictures {

/// Packs an array in the format that the page reads: bytes sorted by their position within a number,
/// deflated, in base64. Doubles are stored as floats.
nlohmann::ordered_json packed(std::span<const double> values);
nlohmann::ordered_json packed(std::span<const std::uint32_t> values);

/// Number of binary digits of reals that are stored, more than a page shows. All digits would double the size
/// of a page, because the last ones do not compress.
inline constexpr int kShownBits = 15;
float rounded_to_shown(double value);
nlohmann::ordered_json packed_as_shown(std::span<const double> values);

}  // namespace netloft::pictures
