// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/svg.hpp"

#include <string>
#include <vector>

namespace netloft::gears {

/// Lines of text below one another, at the same anchor.
struct TextBlock {
  formats::PicturePoint at;  // anchor of the first base line
  std::vector<std::string> lines;
  formats::Anchor anchor;
};

/// Writes texts on a drawing of a given width, and stores their places, so that later texts can avoid them.
/// Lengths of texts are estimated, because fonts differ between computers.
class Lettering {
 public:
  static constexpr double kSmall = 10, kNormal = 12, kLeading = 13.6;  // sizes and distance of lines

  Lettering(formats::LineDrawing& drawing, double width) : drawing_(drawing), width_(width) {}

  /// The estimated length of a text.
  static double length_of(const std::string& text, double size);
  /// Writes a text, moved to the side if it would be cut at the edge of the drawing.
  void write(formats::PicturePoint at, const std::string& text, double size, const char* colour,
             formats::Anchor anchor);
  /// Writes a block, the first line in normal size and the others in small size.
  void write(const TextBlock& block, const char* colour);
  /// The area in which a block would overlap earlier texts or cross the edge of the drawing.
  double overlap(const TextBlock& block) const;

 private:
  struct Area {
    double left, right, top, bottom;
  };
  static Area area_of(formats::PicturePoint at, const std::string& text, double size, formats::Anchor anchor);
  static Area area_of(const TextBlock& block, std::size_t line);

  formats::LineDrawing& drawing_;
  double width_;
  std::vector<Area> taken_;
};

/// Breaks a text at spaces into lines no longer than `longest`. A single longer word gets a line of its own.
std::vector<std::string> broken_into_lines(const std::string& text, double size, double longest);

}  // namespace netloft::gears
