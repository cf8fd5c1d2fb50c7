// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>

namespace netloft::pictures {

/// Arrays as the page reads them: bytes sorted by their place in a number, deflated, in base64. Reals become
/// floats.
nlohmann::ordered_json packed(std::span<const double> values);
nlohmann::ordered_json packed(std::span<const std::uint32_t> values);

/// Reals to kShownBits binary digits, which is more than a page shows of them: what is left out would be
/// half of the page, since it does not deflate.
inline constexpr int kShownBits = 15;
float rounded_to_shown(double value);
nlohmann::ordered_json packed_as_shown(std::span<const double> values);

}  // namespace netloft::pictures
