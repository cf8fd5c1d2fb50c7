// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace netloft::formats {

/// The CRC-32 of zlib, going on from the one of the bytes before; 0 where there are none. Processors that
/// multiply polynomials take it at the speed of memory: reading and writing checks every byte several times.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

}  // namespace netloft::formats
