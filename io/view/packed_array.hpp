// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>

namespace netloft::io {

/// Arrays as the page reads them: bytes sorted by their place in a number, deflated, in base64. Reals become
/// floats.
nlohmann::ordered_json packed(std::span<const double> values);
nlohmann::ordered_json packed(std::span<const std::uint32_t> values);

}  // namespace netloft::io
