// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/svg.hpp"
#include "io/pictures/picture/drawn_line.hpp"

#include <string>
#include <vector>

namespace netloft::pictures {

/// A drawing as a PNG file. Lines and texts are stored until the size is known; then lines are drawn, and
/// texts over them.
class PixelPicture : public formats::LineDrawing {
 public:
  void line(formats::PicturePoint from, formats::PicturePoint to, const char* colour, double width) override;
  void text(formats::PicturePoint at, const std::string& text, double size, const char* colour,
            formats::Anchor anchor) override;

  /// The bytes of the file, `pixels` wide, with a white background. Throws std::invalid_argument with a
  /// sentence if the picture would be too high.
  std::string finish(formats::DrawingSize size, double pixels) const;

 private:
  struct Words {
    formats::PicturePoint at;
    std::string text;
    double size;
    Colour colour;
    formats::Anchor anchor;
  };

  static void write(const Words& words, double scale, Image& image);

  std::vector<StraightLine> lines_;
  std::vector<Words> words_;
};

}  // namespace netloft::pictures
