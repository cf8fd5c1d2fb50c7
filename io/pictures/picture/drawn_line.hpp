// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

namespace netloft::pictures {

/// A straight line in pixels from the upper left corner of a picture.
struct StraightLine {
  double x0, y0, x1, y1, width;
  Colour colour;
};

/// Draws a line with soft edges: the opacity of a pixel follows from its distance to the line.
void draw_line(const StraightLine& line, Image& image);

}  // namespace netloft::pictures
