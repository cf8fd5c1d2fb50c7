// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/sheet_layout.hpp"

#include "io/pictures/picture/drawn_text.hpp"
#include "io/pictures/picture/labels.hpp"

#include "io/results/file/dimensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr double kBarWidth = 260, kBarHeight = 11, kRow = 38, kBesideBar = 16, kAfterBar = 12,
                 kLegendTitle = 13;
// Dimension lines shorter than this [pixels] are left out, because they are nearly parallel to the line of
// sight.
constexpr double kLeastDimension = 24;

/// Formats three significant digits, or all digits before the point of a larger number.
std::string three_digits(double value) {
  const double size = std::abs(value);
  return size >= 1000 && size < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// The title of a legend, such as "tension of twines [N]".
std::string legend_title(const GearShape& shape, results::CellKind kind, std::size_t rows) {
  std::string name = shape.field->name;
  std::replace(name.begin(), name.end(), '_', ' ');
  if (rows > 1)
    name += kind == results::CellKind::netting ? ", netting"
            : kind == results::CellKind::rope  ? ", ropes"
                                               : ", single nodes";
  const std::string& unit = shape.field->unit(kind);
  return unit == "1" ? name : name + " [" + (unit == "N/m2" ? "N/m²" : unit == "m2" ? "m²" : unit) + "]";
}

std::size_t rows_of(const GearShape& shape) {
  return shape.field
             ? static_cast<std::size_t>(std::count_if(shape.scales.begin(), shape.scales.end(),
                                                      [](const auto& scale) { return scale.has_value(); }))
             : 0;
}

void add_ticks(const results::Scale& scale, double left, double top, SheetLayout& layout) {
  const auto ticks = scale.ticks();
  for (const double tick : ticks) {
    const double x = left + kBarWidth * scale.place(tick);
    layout.boxes.push_back({x - 0.5, top + kBarHeight, 1, 3, layout.ink});
    layout.words.push_back({x, top + kBarHeight + 15, three_digits(tick), 12, SheetLayout::Align::middle});
  }
  // The sign < or > at an end of the scale means that some values lie beyond this end.
  if (scale.is_cut_below)
    layout.words.push_back({left - 4, top + kBarHeight, "<", 12, SheetLayout::Align::right});
  if (scale.is_cut_above) layout.words.push_back({left + kBarWidth + 4, top + kBarHeight, ">", 12});
}

void add_legend(const GearShape& shape, results::CellKind kind, double right, double top,
                SheetLayout& layout) {
  const results::Scale& scale = *shape.scales[static_cast<std::size_t>(kind)];
  const double left = right - kBarWidth - kAfterBar;
  constexpr int kSteps = 65;
  for (int i = 0; i < kSteps; ++i)
    layout.boxes.push_back({left + i * kBarWidth / kSteps, top, kBarWidth / kSteps + 0.5, kBarHeight,
                            colour_at(i / (kSteps - 1.0))});
  layout.words.push_back({left - kBesideBar, top + kBarHeight, legend_title(shape, kind, rows_of(shape)),
                          kLegendTitle, SheetLayout::Align::right});
  add_ticks(scale, left, top, layout);
}

}  // namespace

double legend_width(const GearShape& shape) {
  double longest = 0;
  for (const auto kind : {results::CellKind::netting, results::CellKind::rope, results::CellKind::point})
    if (shape.field && shape.scales[static_cast<std::size_t>(kind)])
      longest = std::max(longest, text_width(legend_title(shape, kind, rows_of(shape)), kLegendTitle));
  return longest > 0 ? longest + kBesideBar + kBarWidth + kAfterBar : 0;
}

double legend_height(const GearShape& shape) { return kRow * static_cast<double>(rows_of(shape)); }

void add_legends(const GearShape& shape, double right, double top, SheetLayout& layout) {
  for (const auto kind : {results::CellKind::netting, results::CellKind::rope, results::CellKind::point}) {
    if (!shape.field || !shape.scales[static_cast<std::size_t>(kind)]) continue;
    add_legend(shape, kind, right, top, layout);
    top += kRow;
  }
}

void add_scale_bar(double pixels_per_metre, double x, double y, double longest, SheetLayout& layout) {
  const double wanted = longest / pixels_per_metre, power = std::pow(10, std::floor(std::log10(wanted)));
  const double metres = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
  const double length = metres * pixels_per_metre;
  layout.boxes.push_back({x, y - 1, length, 2, layout.ink});
  layout.boxes.push_back({x, y - 5, 2, 10, layout.ink});
  layout.boxes.push_back({x + length - 2, y - 5, 2, 10, layout.ink});
  layout.words.push_back({x + length + 10, y + 4,
                          metres < 1 ? three_digits(1000 * metres) + " mm" : three_digits(metres) + " m",
                          13});
}

namespace {

/// Adds a line with an arrow at either end.
void add_arrow(const Point3& a, const Point3& b, SheetLayout& layout) {
  constexpr double kHead = 9, kOpen = 0.32;
  const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
  const double ux = dx / length, uy = dy / length;
  layout.lines.push_back({a[0], a[1], b[0], b[1], 1.3, layout.ink});
  for (const auto& [tip, sign] : {std::pair{a, 1.0}, {b, -1.0}})
    for (const double side : {-kOpen, kOpen})
      layout.lines.push_back({tip[0], tip[1], tip[0] + sign * kHead * (ux - side * uy),
                              tip[1] + sign * kHead * (uy + side * ux), 1.3, layout.ink});
}

/// Adds a thin line from a label to the point of the line to which the label belongs.
void add_leader(const LabelPlace& place, SheetLayout& layout) {
  constexpr double kDot = 4;
  const Point3 start = place.start_of_leader();
  layout.lines.push_back({start[0], start[1], place.point[0], place.point[1], 0.8, layout.ink});
  layout.boxes.push_back({place.point[0] - kDot / 2, place.point[1] - kDot / 2, kDot, kDot, layout.ink});
}

/// The fraction of a frame in which the gear is painted.
double painted_in(const Frame& frame, const Image& painted, double top, const Colour& ground) {
  constexpr double kStep = 3, kSame = 0.02;  // distance of samples [pixels]; invisible difference of colours
  double seen = 0, all = 0;
  for (double y = frame.top - top; y < frame.top - top + frame.height; y += kStep)
    for (double x = frame.left; x < frame.left + frame.width; x += kStep) {
      ++all;
      if (x < 0 || y < 0 || x >= static_cast<double>(painted.width) ||
          y >= static_cast<double>(painted.height))
        continue;
      const Colour colour = painted.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
      for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(colour[k] - ground[k]) > kSame) {
          ++seen;
          break;
        }
    }
  return all > 0 ? seen / all : 0;
}

bool is_inside(const Point3& p, const Frame& frame) {
  return p[0] >= frame.left && p[0] <= frame.left + frame.width && p[1] >= frame.top &&
         p[1] <= frame.top + frame.height;
}

}  // namespace

void add_dimensions(const GearShape& shape, const Projection& projection, const Image& painted, double top,
                    SheetLayout& layout) {
  constexpr double kWords = 13;  // font size [pixels]
  const Frame picture{0, top, static_cast<double>(painted.width), static_cast<double>(painted.height)};
  std::vector<double> points;
  for (const auto& node : shape.nodes) points.insert(points.end(), node.begin(), node.end());
  std::vector<LabelledLine> lines;
  std::vector<std::string> words;
  for (const auto& dimension : results::dimensions_of(*shape.stored)) {
    const Point3 from = results::place_of(dimension.from, *shape.stored, points, {});
    const Point3 to = results::place_of(dimension.to, *shape.stored, points, from);
    Point3 a = projection(from), b = projection(to);
    a[1] += picture.top;
    b[1] += picture.top;
    if (!is_inside(a, picture) || !is_inside(b, picture)) continue;
    if (std::hypot(b[0] - a[0], b[1] - a[1]) < kLeastDimension) continue;
    add_arrow(a, b, layout);
    const double metres = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    words.push_back(fmt::format("{} {:.3g} m", dimension.name, metres));
    lines.push_back({a, b, text_width(words.back(), kWords)});
  }
  const auto places = place_labels(lines, kWords, picture, [&](const Frame& frame) {
    return painted_in(frame, painted, top, layout.ground);
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Frame& frame = places[i].frame;
    if (places[i].is_apart) add_leader(places[i], layout);
    layout.words.push_back(
        {frame.left, frame.top + frame.height, words[i], kWords, SheetLayout::Align::left, true});
  }
}

}  // namespace netloft::pictures
