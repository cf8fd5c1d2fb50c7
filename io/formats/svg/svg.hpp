// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

struct PicturePoint {
  double x, y;  // position from the upper left corner, y downwards
};

enum class Anchor { start, middle, end };

/// Receives the lines and texts of a drawing in the order in which they are drawn, for any kind of file.
/// Colours are written as in SVG: "#222" or "#0b5fa5".
class LineDrawing {
 public:
  virtual ~LineDrawing() = default;
  virtual void line(PicturePoint from, PicturePoint to, const char* colour, double width) = 0;
  virtual void text(PicturePoint at, const std::string& text, double size, const char* colour,
                    Anchor anchor) = 0;
};

/// The size of a finished drawing.
struct DrawingSize {
  double width, height;
};

/// An SVG picture: a list of shapes, drawn in the order in which they are added.
class SvgPicture : public LineDrawing {
 public:
  void line(PicturePoint from, PicturePoint to, const char* colour, double width) override;
  void line(PicturePoint from, PicturePoint to, const char* colour, double width, const char* dashes);
  void frame(PicturePoint corner, PicturePoint opposite, const char* colour);
  void path(const std::vector<PicturePoint>& points, const char* colour, double width);
  /// A closed area without an outline; `opacity` from 0 to 1.
  void area(const std::vector<PicturePoint>& outline, const char* colour, double opacity);
  /// Draws one of eight shapes, which can be told apart without colour. From the ninth series on, shapes
  /// repeat.
  void marker(PicturePoint at, std::size_t shape, const char* colour, bool is_hollow = false);
  void text(PicturePoint at, const std::string& text, double size, const char* colour,
            Anchor anchor) override;
  /// Draws text that reads upwards. With `halo` the text has a white rim that separates it from the lines
  /// behind.
  void rotated_text(PicturePoint at, const std::string& text, double size, const char* colour, Anchor anchor,
                    bool halo = false);
  /// Draws the number of a tick as a power of ten (10⁻³) or as a decimal number (0.02).
  void number(PicturePoint at, double value, bool as_power, double size, Anchor anchor);

  /// The complete file, with a white background. On a screen, one unit is two pixels.
  std::string finish(double width, double height) const { return finish({width, height}, 2 * width); }
  /// The complete file with a given width on a screen [pixels].
  std::string finish(DrawingSize size, double pixels) const;

 private:
  void words(PicturePoint at, const std::string& markup, double size, const char* colour, Anchor anchor,
             const std::string& more = "");
  std::string body_;
};

/// Replaces & < > " by entities, and control characters that XML does not allow by spaces.
std::string escape_markup(const std::string& text);

}  // namespace netloft::formats
