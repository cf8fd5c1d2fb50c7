// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/sheet_layout.hpp"

namespace netloft::pictures {

/// The legend of a picture whose colours show parts. It lists each colour with the names of its parts, in
/// rows. Because colours repeat after eight parts, a colour may have several names.
class PartLegend {
 public:
  /// The legend of a shape in rows of `width` pixels; it has no rows if a field is shown.
  PartLegend(const GearShape& shape, double width);

  /// Height of the rows [pixels].
  double height() const;
  /// Adds the rows with the upper left corner at (left, top).
  void add_to(SheetLayout& layout, double left, double top) const;

 private:
  struct Entry {
    double x;
    std::size_t row;
    std::string text;
    std::optional<Colour> colour;  // a square before the text; empty for further names of the same colour
  };

  void add(const Colour& colour, const std::vector<std::string>& names);
  void append(const std::string& text, const std::optional<Colour>& colour);

  double width_, x_ = 0;
  std::size_t rows_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace netloft::pictures
