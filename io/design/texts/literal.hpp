// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string_view>

namespace netloft::design {

/// The index of the byte at a line and a column of a text. Both count from 1, columns in characters. If the
/// line or the text is shorter, the result is its end.
std::size_t byte_at(std::string_view text, int line, int column);

/// The number of bytes of the TOML value that begins at byte `begin` of a valid text: a text in quotes, an
/// array, an inline table, or a bare word such as -2.5e3.
std::size_t length_of_literal(std::string_view text, std::size_t begin);

}  // namespace netloft::design
