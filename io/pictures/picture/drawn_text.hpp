// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// Width of a text that write_text() writes [pixels]; `size` is the font size, as in CSS.
double text_width(const std::string& text, double size);

/// Writes a text in Noto Sans (letters/) into a pixel image, with its base line beginning at (x, y).
/// Characters that the font lacks appear as its symbol for missing characters.
void write_text(Image& image, double x, double y, const std::string& text, double size, const Colour& colour);

/// A letter of the font.
struct Glyph {
  int number;     // in the font file
  int character;  // its code in Unicode
};
std::vector<Glyph> glyphs_of(const std::string& text);
/// Distance from the beginning of a letter to that of the next one, over the font size.
double advance_of(int character);

/// The box around all letters of the font, from the beginning of the base line, over the font size.
struct FontBox {
  double left, bottom, right, top;
};
FontBox font_box();

}  // namespace netloft::pictures
