// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/sheet.hpp"

#include "io/formats/svg/svg.hpp"
#include "io/pictures/picture/base64.hpp"
#include "io/pictures/picture/drawn_text.hpp"
#include "io/pictures/picture/gear_painter.hpp"
#include "io/pictures/picture/part_legend.hpp"
#include "io/pictures/picture/png.hpp"
#include "io/pictures/picture/sheet_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr double kMargin = 16, kHead = 46, kFoot = 40, kTitleSize = 18;
constexpr double kBesideTitle = 24,
                 kBelowPicture = 8;  // least distances between title and legend, and between picture and
                                     // legend
// Limits of the height of the picture, relative to its width.
constexpr double kLeastHeight = 0.16, kGreatestHeight = 0.64;

struct Sheet {
  double width = 0, height = 0, picture_top = 0;
  Image picture{0, 0, {}};
  SheetLayout layout;
};

/// Shortens a title that is longer than `longest` [pixels], and adds an ellipsis.
std::string shortened(std::string text, double longest) {
  if (text_width(text, kTitleSize) <= longest) return text;
  while (!text.empty() && text_width(text + "…", kTitleSize) > longest) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

/// The middle of the box around points.
Point3 middle_of(const std::vector<Point3>& points) {
  Point3 middle{};
  for (std::size_t k = 0; k < 3 && !points.empty(); ++k) {
    const auto [lo, hi] = std::minmax_element(points.begin(), points.end(),
                                              [&](const Point3& a, const Point3& b) { return a[k] < b[k]; });
    middle[k] = ((*lo)[k] + (*hi)[k]) / 2;
  }
  return middle;
}

std::string title_of(const results::StoredShape& stored, std::size_t state, double longest) {
  std::string title = stored.result.title;
  if (!stored.stages.empty()) title += ", " + stored.stages[state];
  if (stored.result.motion) title += fmt::format(", {:.4g} s", stored.times[state]);
  return shortened(title, longest);
}

void add_title(const results::StoredShape& stored, const std::string& title, SheetLayout& layout) {
  layout.words.push_back({kMargin, 27, title, kTitleSize});
  if (!stored.result.is_answer())
    layout.words.push_back(
        {kMargin, 44,
         (stored.result.outcome.empty() ? "the run has not ended" : stored.result.outcome) +
             ": no equilibrium",
         13});
}

/// Adds the line of the bed under the gear, from edge to edge, in the side and front views. `foot` is the
/// lower edge of the picture.
void add_bed(const GearShape& shape, const Projection& projection, View view, double foot, Sheet& sheet) {
  constexpr int kPieces = 64;
  constexpr Colour kBed = {0.55f, 0.46f, 0.3f};
  const auto& bed = shape.stored->bed;
  if (!bed || (view != View::side && view != View::front)) return;
  const Point3 middle = middle_of(extent_of(shape, Framing::netting));
  const double there = projection(middle)[0];
  const auto at = [&](int piece) {
    const double column = std::lerp(kMargin, sheet.width - kMargin, static_cast<double>(piece) / kPieces);
    const double ahead = (column - there) / projection.pixels_per_metre;
    const double x = middle[0] + ahead * projection.right[0], y = middle[1] + ahead * projection.right[1];
    return std::array{column, sheet.picture_top + projection({x, y, bed->height(x, y)})[1]};
  };
  for (int piece = 0; piece < kPieces; ++piece) {
    const auto [x0, y0] = at(piece);
    const auto [x1, y1] = at(piece + 1);
    if (std::min(y0, y1) > sheet.picture_top && std::max(y0, y1) < foot + 6)
      sheet.layout.lines.push_back({x0, y0, x1, y1, 1.5, kBed});
  }
}

SheetLayout empty_layout(bool is_dark) {
  SheetLayout layout;
  layout.ground = is_dark ? Colour{0.08f, 0.19f, 0.25f} : Colour{1, 1, 1};
  layout.ink = is_dark ? Colour{0.93f, 0.96f, 0.97f} : Colour{0.08f, 0.13f, 0.17f};
  return layout;
}

/// The height that a picture of the points needs in a view, within limits [pixels].
double picture_height(View view, const std::vector<Point3>& points, double width) {
  const Projection projection = fit(view, points, {kMargin, 0, width - 2 * kMargin, 1e9});
  double low = INFINITY, high = -INFINITY;
  for (const auto& p : points) {
    low = std::min(low, projection(p)[1]);
    high = std::max(high, projection(p)[1]);
  }
  const double tall = points.empty() ? 0 : high - low;
  return std::round(std::clamp(tall + 2 * kMargin, kLeastHeight * width, kGreatestHeight * width));
}

Sheet compose(const results::StoredShape& stored, const SheetOptions& options) {
  const std::size_t state = std::min(options.state, stored.times.size() - 1);
  const GearShape shape = shape_of(stored, state, options.colouring);
  Sheet sheet;
  sheet.layout = empty_layout(options.is_dark);
  sheet.width = static_cast<double>(options.width);
  const std::string title = title_of(stored, state, sheet.width - 2 * kMargin);
  // If legends have no room beside the title, they are placed below it.
  const bool is_narrow =
      text_width(title, kTitleSize) + kBesideTitle + legend_width(shape) > sheet.width - 2 * kMargin;
  const double legends = legend_height(shape);
  const PartLegend parts(shape, sheet.width - 2 * kMargin);
  const auto points = extent_of(shape, options.framing);
  const double height = picture_height(options.view, points, sheet.width);
  sheet.picture_top = is_narrow ? kHead + legends : std::max(kHead, legends + 10);
  const double foot = height + sheet.picture_top;  // below the picture: legend of parts, scale bar
  sheet.height = foot + parts.height() + kFoot;
  const Projection projection =
      fit(options.view, points, {kMargin, kMargin, sheet.width - 2 * kMargin, height - 2 * kMargin});
  sheet.picture =
      paint(shape, projection, options.width, static_cast<std::size_t>(height), sheet.layout.ground);
  add_bed(shape, projection, options.view, foot, sheet);
  add_title(stored, title, sheet.layout);
  parts.add_to(sheet.layout, kMargin, foot + kBelowPicture);
  add_legends(shape, sheet.width - kMargin, is_narrow ? kHead : 12, sheet.layout);
  add_scale_bar(projection.pixels_per_metre, kMargin, sheet.height - kFoot / 2, sheet.width / 6,
                sheet.layout);
  if (options.with_dimensions)
    add_dimensions(shape, projection, sheet.picture, sheet.picture_top, sheet.layout);
  return sheet;
}

std::string svg_of(const SheetLayout::Words& words, const SheetLayout& layout) {
  const char* anchor = words.align == SheetLayout::Align::right    ? "end"
                       : words.align == SheetLayout::Align::middle ? "middle"
                                                                   : "start";
  const std::string halo =
      words.has_halo ? " stroke=\"" + hex(layout.ground) + "\" stroke-width=\"4\" paint-order=\"stroke\""
                     : "";
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
      words.x, words.y, words.size, hex(layout.ink), anchor, halo, formats::escape_markup(words.text));
}

void draw_box(const SheetLayout::Box& box, Image& image) {
  const auto pixel = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::round(x))); };
  for (std::size_t y = pixel(box.y); y < std::min(pixel(box.y + box.height), image.height); ++y)
    for (std::size_t x = pixel(box.x); x < std::min(pixel(box.x + box.width), image.width); ++x)
      image.set(x, y, box.colour);
}

void draw_words(const SheetLayout::Words& words, const SheetLayout& layout, Image& image) {
  const double width = text_width(words.text, words.size);
  const double left = words.align == SheetLayout::Align::right    ? words.x - width
                      : words.align == SheetLayout::Align::middle ? words.x - width / 2
                                                                  : words.x;
  if (words.has_halo)
    for (const double x : {-1.5, 0.0, 1.5})
      for (const double y : {-1.0, 0.0, 1.0})
        write_text(image, left + x, words.y + y, words.text, words.size, layout.ground);
  write_text(image, left, words.y, words.text, words.size, layout.ink);
}

}  // namespace

std::string svg_sheet(const results::StoredShape& stored, const SheetOptions& options) {
  const Sheet sheet = compose(stored, options);
  const SheetLayout& layout = sheet.layout;
  const std::string picture = options.is_small ? small_png(sheet.picture) : png(sheet.picture);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" role=\"img\" aria-label=\"{2}\" font-family=\"Noto "
      "Sans,Helvetica,Arial,sans-serif\">\n<rect "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"{3}\"/>\n<image y=\"{4:g}\" width=\"{5}\" height=\"{6}\" "
      "href=\"data:image/png;base64,{7}\"/>\n",
      sheet.width, sheet.height, formats::escape_markup("the shape of " + stored.result.title),
      hex(layout.ground), sheet.picture_top, sheet.picture.width, sheet.picture.height,
      base64(bytes_of(picture)));
  for (const auto& box : layout.boxes)
    svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       box.x, box.y, box.width, box.height, hex(box.colour));
  for (const auto& line : layout.lines)
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{:g}\"/>\n",
        line.x0, line.y0, line.x1, line.y1, hex(line.colour), line.width);
  for (const auto& words : layout.words) svg += svg_of(words, layout);
  return svg + "</svg>\n";
}

std::string png_sheet(const results::StoredShape& stored, const SheetOptions& options) {
  const Sheet sheet = compose(stored, options);
  Image image(static_cast<std::size_t>(sheet.width), static_cast<std::size_t>(sheet.height),
              sheet.layout.ground);
  const auto top = static_cast<std::size_t>(sheet.picture_top);
  std::copy(sheet.picture.bytes.begin(), sheet.picture.bytes.end(),
            image.bytes.begin() + static_cast<std::ptrdiff_t>(3 * top * image.width));
  for (const auto& box : sheet.layout.boxes) draw_box(box, image);
  for (const auto& line : sheet.layout.lines) draw_line(line, image);
  for (const auto& words : sheet.layout.words) draw_words(words, sheet.layout, image);
  return png(image);
}

}  // namespace netloft::pictures
