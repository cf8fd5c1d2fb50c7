// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/svg.hpp"

#include <map>
#include <string>

namespace netloft::pictures {

/// A drawing as a PDF file of one page (ISO 32000-1), in vectors, with its letters (Noto Sans) in it: it
/// looks the same on every computer, can be printed at any size, and its texts can be searched.
class PdfPicture : public formats::LineDrawing {
 public:
  void line(formats::PicturePoint from, formats::PicturePoint to, const char* colour, double width) override;
  void text(formats::PicturePoint at, const std::string& text, double size, const char* colour,
            formats::Anchor anchor) override;

  /// The bytes of the file, the same for the same drawing. The page is as large as the drawing, of which one
  /// unit is a pixel of CSS (1/96 inch).
  std::string finish(formats::DrawingSize size) const;

 private:
  std::string drawn_;
  std::map<int, int> characters_;  // of each glyph that is used
};

}  // namespace netloft::pictures
