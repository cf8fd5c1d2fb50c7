// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>

namespace netloft::pictures {

using Bytes = std::span<const unsigned char>;

inline Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// Encodes bytes in base64 with padding (RFC 4648).
std::string base64(Bytes bytes);

/// Compresses bytes in zlib's format at a fast level. Throws std::runtime_error if there is no memory.
std::string deflated(Bytes bytes);

}  // namespace netloft::pictures
