// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/picture/canvas.hpp"

#include <cstddef>
#include <string>

namespace netloft::io {

/// Width in pixels of a text that write_text() writes; `size` is the edge of one dot of the letters.
std::size_t text_width(const std::string& text, std::size_t size);
inline constexpr std::size_t kLetterHeight = 7;  // dots

/// Writes a text in letters of five by seven dots, its upper left corner at (x, y): for pictures in pixels,
/// which have no fonts. Characters that it has not become a question mark.
void write_text(Image& image, long x, long y, const std::string& text, std::size_t size,
                const Colour& colour);

}  // namespace netloft::io
