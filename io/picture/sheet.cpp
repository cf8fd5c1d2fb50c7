// SPDX-License-Identifier: BSD-3-Clause
#include "io/picture/sheet.hpp"

#include "io/picture/bytes.hpp"
#include "io/picture/font.hpp"
#include "io/picture/png.hpp"
#include "io/plot/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

constexpr double kNarrow = 900;  // below, the legend has a row of its own
constexpr double kMargin = 16, kHead = 46, kTallHead = 74, kFoot = 40, kLegendWidth = 300, kLegendHeight = 10;
constexpr double kLeastHeight = 0.16, kGreatestHeight = 0.8;  // of the picture, relative to its width

/// What stands around the picture, in pixels from the upper left corner of the sheet.
struct Box {
  double x, y, width, height;
  Colour colour;
};
struct Words {
  double x, y;  // left end of the base line; right end if `to_left`, middle if `centred`
  std::string text;
  double size;
  bool to_left = false, centred = false;
};

struct Sheet {
  double width = 0, height = 0;
  Colour ground, ink;
  Image picture{0, 0, {}};
  double picture_top = kHead;

  bool is_narrow() const { return width < kNarrow; }
  std::vector<Box> boxes;
  std::vector<Words> words;
};

/// A long title is cut, with a mark that it was.
std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string number(double value) { return fmt::format("{:.3g}", value); }

std::string legend_title(const GearShape& shape) {
  if (!shape.field) return "colours: parts";
  std::string name = shape.field->name;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (shape.field->unit != "1") name += " [" + shape.field->unit + "]";
  return name + (shape.scale->is_logarithmic() ? ", logarithmic" : "");
}

void add_legend(const GearShape& shape, Sheet& sheet) {
  const double left = sheet.width - kMargin - kLegendWidth,
               top = sheet.is_narrow() ? kTallHead - kHead + 10 : 10;
  sheet.words.push_back({left - 10, top + kLegendHeight, legend_title(shape), 12, true});
  if (!shape.scale) return;
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i)
    sheet.boxes.push_back({left + i * kLegendWidth / kSteps, top, kLegendWidth / kSteps + 0.5, kLegendHeight,
                           colour_at(i / (kSteps - 1.0))});
  for (const double place : {0.0, 1.0 / 3, 2.0 / 3, 1.0})
    sheet.words.push_back({left + place * kLegendWidth, top + kLegendHeight + 14,
                           (place == 0 && shape.is_cut_below ? "< " : "") + number(shape.scale->value(place)),
                           11, place == 1, place > 0 && place < 1});
}

/// A scale of a round number of metres, about a sixth of the sheet.
void add_scale_bar(double pixels_per_metre, Sheet& sheet) {
  const double wanted = sheet.width / 6 / pixels_per_metre,
               power = std::pow(10, std::floor(std::log10(wanted)));
  const double metres = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
  const double length = metres * pixels_per_metre, y = sheet.height - kFoot / 2;
  sheet.boxes.push_back({kMargin, y - 1, length, 2, sheet.ink});
  sheet.boxes.push_back({kMargin, y - 5, 2, 10, sheet.ink});
  sheet.boxes.push_back({kMargin + length - 2, y - 5, 2, 10, sheet.ink});
  sheet.words.push_back({kMargin + length + 10, y + 5, number(metres) + " m", 12});
}

/// In views along the level: the bed under the gear.
void add_bed(const GearShape& shape, const Projection& projection, View view, Sheet& sheet) {
  const auto& bed = shape.result->bed;
  const bool is_level = bed && bed->slope_x == 0 && bed->slope_y == 0;
  if (!is_level || (view != View::side && view != View::front)) return;
  const double y = sheet.picture_top + projection({0, 0, -bed->depth})[1];
  if (y > sheet.picture_top && y < sheet.height - kFoot + 6)
    sheet.boxes.push_back({kMargin, y, sheet.width - 2 * kMargin, 1.5, {0.55f, 0.46f, 0.3f}});
}

void add_title(const StoredResult& result, std::size_t state, Sheet& sheet) {
  std::string title = result.title();
  if (result.is_motion) title += fmt::format(", {:.4g} s", result.times[state]);
  if (!result.is_answer())
    title += " (" + (result.outcome.empty() ? std::string("not ended") : result.outcome) + ")";
  sheet.words.push_back({kMargin, 20, shortened(title, 46), 15});
}

Sheet compose(const StoredResult& result, const SheetOptions& options) {
  const std::size_t state = std::min(options.state, result.times.size() - 1);
  const GearShape shape = shape_of(result, state, options.field);
  Sheet sheet;
  sheet.ground = options.is_dark ? Colour{0.08f, 0.19f, 0.25f} : Colour{1, 1, 1};
  sheet.ink = options.is_dark ? Colour{0.93f, 0.96f, 0.97f} : Colour{0.08f, 0.13f, 0.17f};
  sheet.width = static_cast<double>(options.width);
  const auto points = extent_of(shape, options.with_ropes);
  const double inner = sheet.width - 2 * kMargin;
  Projection projection = fit(options.view, points, {kMargin, 0, inner, 1e9});
  double low = INFINITY, high = -INFINITY;
  for (const auto& p : points) low = std::min(low, projection(p)[1]), high = std::max(high, projection(p)[1]);
  const double tall = points.empty() ? 0 : high - low;
  const double height =
      std::clamp(tall + 2 * kMargin, kLeastHeight * sheet.width, kGreatestHeight * sheet.width);
  projection = fit(options.view, points, {kMargin, kMargin, inner, height - 2 * kMargin});
  sheet.picture_top = sheet.is_narrow() ? kTallHead : kHead;
  sheet.height = std::round(height) + sheet.picture_top + kFoot;
  sheet.picture =
      paint(shape, projection, options.width, static_cast<std::size_t>(std::round(height)), sheet.ground);
  add_bed(shape, projection, options.view, sheet);
  add_title(result, state, sheet);
  add_legend(shape, sheet);
  add_scale_bar(projection.pixels_per_metre, sheet);
  return sheet;
}

}  // namespace

std::string svg_sheet(const StoredResult& result, const SheetOptions& options) {
  const Sheet sheet = compose(result, options);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" role=\"img\" aria-label=\"{2}\" font-family=\"Helvetica,Arial,sans-serif\">\n<rect "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"{3}\"/>\n<image y=\"{4:g}\" width=\"{5}\" height=\"{6}\" "
      "href=\"data:image/png;base64,{7}\"/>\n",
      sheet.width, sheet.height, escape_markup("the shape of " + result.title()), hex(sheet.ground),
      sheet.picture_top, sheet.picture.width, sheet.picture.height, base64(bytes_of(png(sheet.picture))));
  for (const auto& box : sheet.boxes)
    svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       box.x, box.y, box.width, box.height, hex(box.colour));
  for (const auto& words : sheet.words)
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\">{}</text>\n",
        words.x, words.y, words.size, hex(sheet.ink),
        words.to_left   ? "end"
        : words.centred ? "middle"
                        : "start",
        escape_markup(words.text));
  return svg + "</svg>\n";
}

std::string png_sheet(const StoredResult& result, const SheetOptions& options) {
  const Sheet sheet = compose(result, options);
  Image image(static_cast<std::size_t>(sheet.width), static_cast<std::size_t>(sheet.height), sheet.ground);
  const auto top = static_cast<std::size_t>(sheet.picture_top);
  std::copy(sheet.picture.bytes.begin(), sheet.picture.bytes.end(),
            image.bytes.begin() + static_cast<std::ptrdiff_t>(3 * top * image.width));
  const auto pixel = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::round(x))); };
  for (const auto& box : sheet.boxes)
    for (std::size_t y = pixel(box.y); y < std::min(pixel(box.y + box.height), image.height); ++y)
      for (std::size_t x = pixel(box.x); x < std::min(pixel(box.x + box.width), image.width); ++x)
        image.set(x, y, box.colour);
  for (const auto& words : sheet.words) {
    const std::size_t size = words.size > 14 ? 2 : 1;
    const auto width = static_cast<double>(text_width(words.text, size));
    const double left = words.to_left ? words.x - width : words.centred ? words.x - width / 2 : words.x;
    write_text(image, std::lround(left), std::lround(words.y) - static_cast<long>(size * kLetterHeight),
               words.text, size, sheet.ink);
  }
  return png(image);
}

}  // namespace netloft::io
