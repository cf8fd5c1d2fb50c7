// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <string>

namespace netloft::pictures {

/// Width of a text that write_text() writes [pixels]; `size` is the font size, as in CSS.
double text_width(const std::string& text, double size);

/// Writes a text in Noto Sans (letters/) into a pixel image, with its base line beginning at (x, y).
/// Characters that the font lacks appear as its symbol for missing characters.
void write_text(Image& image, double x, double y, const std::string& text, double size, const Colour& colour);

}  // namespace netloft::pictures
