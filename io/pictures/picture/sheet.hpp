// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/gear_shape.hpp"

#include <cstddef>
#include <string>

namespace netloft::pictures {

/// Options for drawing a result on a sheet.
struct SheetOptions {
  View view = View::oblique;
  Colouring colouring;
  std::size_t width = 1000;               // [pixels]
  std::size_t state = std::string::npos;  // index of the state; npos: the newest
  Framing framing = Framing::netting;
  bool with_dimensions = false;  // whether height and spreads are drawn as lines with their lengths
  bool is_dark = false;
  bool is_small = false;  // true: an SVG with few colours, for pages
};

/// Title, picture, legends and scale bar as SVG. Letters and lines are vectors; the gear is a pixel image, in
/// which hidden surfaces are removed. Throws std::invalid_argument for a field that the result does not have.
std::string svg_sheet(const results::StoredShape& stored, const SheetOptions& options);

/// The same sheet as the bytes of a PNG file.
std::string png_sheet(const results::StoredShape& stored, const SheetOptions& options);

}  // namespace netloft::pictures
