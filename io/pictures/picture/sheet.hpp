// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/gear_shape.hpp"

#include <cstddef>
#include <string>

namespace netloft::pictures {

/// How a result is drawn on a sheet.
struct SheetOptions {
  View view = View::oblique;
  Colouring colouring;
  std::size_t width = 1000;               // [pixels]
  std::size_t state = std::string::npos;  // npos: the newest
  Framing framing = Framing::netting;
  bool with_dimensions = false;  // height and spreads are drawn as lines with their lengths
  bool is_dark = false;
  bool is_small = false;  // an SVG with few colours, for pages
};

/// Title, picture, legends and scale bar as SVG: letters and lines are vectors, the gear is a picture in
/// pixels, in which hidden surfaces are right. Throws std::invalid_argument for a field that the result has
/// not.
std::string svg_sheet(const results::StoredShape& stored, const SheetOptions& options);

/// The same as the bytes of a PNG file.
std::string png_sheet(const results::StoredShape& stored, const SheetOptions& options);

}  // namespace netloft::pictures
