// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace netloft::formats {

/// Length of the UTF-8 sequence that begins `text` (RFC 3629, table 3-7 of Unicode), 0 if there is none.
std::size_t sequence_length(std::string_view text);

}  // namespace netloft::formats
