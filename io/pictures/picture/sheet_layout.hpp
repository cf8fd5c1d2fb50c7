// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/drawn_line.hpp"
#include "io/pictures/picture/gear_shape.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// Title, legend, labels and dimension lines of a picture, in pixels from the upper left corner of the sheet,
/// for SVG and for PNG.
struct SheetLayout {
  enum class Align { left, middle, right };
  struct Box {
    double x, y, width, height;
    Colour colour;
  };
  struct Words {
    double x, y;  // start, middle or end of the base line, by `align`
    std::string text;
    double size;
    Align align = Align::left;
    bool has_halo = false;  // an outline in the background colour, for text over a picture
  };

  Colour ground, ink;
  std::vector<Box> boxes;
  std::vector<StraightLine> lines;
  std::vector<Words> words;
};

/// Height and greatest width of the legends of a shape [pixels]; zero if there are none.
double legend_height(const GearShape& shape);
double legend_width(const GearShape& shape);
/// Adds colour bars with round values: one for each of netting, ropes and single nodes that has the field.
/// The upper right corner of the bars is at (right, top).
void add_legends(const GearShape& shape, double right, double top, SheetLayout& layout);

/// Adds a scale bar of a round number of metres with its left end at (x, y), at most `longest` long [pixels].
void add_scale_bar(double pixels_per_metre, double x, double y, double longest, SheetLayout& layout);

/// Adds dimension lines for the height and the spreads, each with its length. A line is left out unless both
/// ends are inside the picture `painted`, which lies `top` pixels below the upper edge of the sheet. Lengths
/// are written beside the gear if there is room.
void add_dimensions(const GearShape& shape, const Projection& projection, const Image& painted, double top,
                    SheetLayout& layout);

}  // namespace netloft::pictures
