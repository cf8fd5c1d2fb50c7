// SPDX-License-Identifier: BSD-3-Clause
#include "io/plot/plot.hpp"

#include "io/plot/log_axis.hpp"
#include "io/plot/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::io {

namespace {

// Lengths are in units of the picture; kWidth units are a column of 8.5 cm, so one unit is 0.71 pt.
constexpr double kWidth = 340, kInnerHeight = 210;
constexpr double kLeft = 46, kRight = 10, kTop = 24, kAxisRoom = 38, kLegendLine = 14, kMargin = 6;
constexpr double kText = 10, kSmall = 8.5;
constexpr double kLetter = 0.6;  // width of a letter relative to its height, estimated generously
constexpr const char *kInk = "#222222", *kGrid = "#dddddd", *kMinorGrid = "#f0f0f0", *kMarkInk = "#666666";

/// M. Okabe and K. Ito, Color Universal Design, 2008; yellow is left out because it is too light on white.
constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                              "#e69f00", "#56b4e9", "#000000"};

bool has_place(double value) { return value > 0 && std::isfinite(value); }
bool has_place(const PlotSeries::Point& p) { return has_place(p.x) && has_place(p.y); }

/// All x or all y that can be drawn.
std::vector<double> values_of(const LogLogPlot& plot, bool of_x) {
  std::vector<double> values;
  for (const auto& series : plot.series)
    for (const auto& p : series.points)
      if (has_place(p)) values.push_back(of_x ? p.x : p.y);
  for (const auto& mark : plot.marks)
    if (of_x) values.push_back(mark.x);
  return values;
}

class Drawing {
 public:
  explicit Drawing(const LogLogPlot& plot)
      : plot_(plot), x_(values_of(plot, true)), y_(values_of(plot, false)) {}

  std::string draw() {
    draw_ticks();
    draw_marks();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(i);
    draw_frame();
    draw_legend();
    return picture_.finish(kWidth, legend_top() + kLegendLine * double(plot_.series.size()) + kMargin);
  }

 private:
  double x(double value) const { return kLeft + x_.place(value) * (kWidth - kLeft - kRight); }
  double y(double value) const { return bottom() - y_.place(value) * kInnerHeight; }
  static double bottom() { return kTop + kInnerHeight; }
  static double right() { return kWidth - kRight; }
  static double legend_top() { return bottom() + kAxisRoom; }
  static const char* colour(std::size_t series) { return kColours[series % kColours.size()]; }

  void draw_ticks() {
    for (const bool labelled : {false, true}) {  // labelled lines are drawn last
      const char* grid = labelled ? kGrid : kMinorGrid;
      for (const auto& tick : x_.ticks())
        if (tick.labelled == labelled)
          picture_.line({x(tick.value), kTop}, {x(tick.value), bottom()}, grid, 0.6);
      for (const auto& tick : y_.ticks())
        if (tick.labelled == labelled)
          picture_.line({kLeft, y(tick.value)}, {right(), y(tick.value)}, grid, 0.6);
    }
    for (const auto& tick : x_.ticks())
      if (tick.labelled)
        picture_.number({x(tick.value), bottom() + 13}, tick.value, x_.labels_powers(), kText,
                        Anchor::middle);
    for (const auto& tick : y_.ticks())
      if (tick.labelled)
        picture_.number({kLeft - 5, y(tick.value) + 3.5}, tick.value, y_.labels_powers(), kText, Anchor::end);
  }

  void draw_frame() {
    picture_.frame({kLeft, kTop}, {right(), bottom()}, kInk);
    const double middle = (kLeft + right()) / 2;
    picture_.text({middle, bottom() + 28}, plot_.x_label, kText, kInk, Anchor::middle);
    picture_.rotated_text({11, (kTop + bottom()) / 2}, plot_.y_label, kText, kInk, Anchor::middle);
    picture_.text({middle, 15}, plot_.title, kText, kInk, Anchor::middle);
  }

  /// Draws marks from left to right with labels above the lines; of two close labels the right one is lower.
  void draw_marks() {
    std::vector<PlotMark> marks = plot_.marks;
    std::erase_if(marks, [](const PlotMark& mark) { return !has_place(mark.x); });
    std::sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    for (const auto& mark : marks)
      picture_.line({x(mark.x), kTop}, {x(mark.x), bottom()}, kMarkInk, 0.9, "5 3");
    double last = -kWidth, depth = 0;
    for (const auto& mark : marks) {
      const double at = x(mark.x) - kLeft < kSmall + 3 ? x(mark.x) + kSmall : x(mark.x) - 3;
      depth = at - last < kSmall + 4 ? depth : 0;
      picture_.rotated_text({at, kTop + 4 + depth}, mark.label, kSmall, kMarkInk, Anchor::end, true);
      last = at, depth += kLetter * kSmall * static_cast<double>(mark.label.size());
    }
  }

  void draw_series(std::size_t i) {
    std::vector<PicturePoint> path;
    for (const auto& p : plot_.series[i].points)
      if (has_place(p)) path.push_back({x(p.x), y(p.y)});
    picture_.path(path, colour(i), 1.4);
    for (const auto& at : path) picture_.marker(at, i, colour(i));
  }

  void draw_legend() {
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const double at = legend_top() + kLegendLine * (double(i) + 0.5);
      picture_.line({kLeft, at}, {kLeft + 22, at}, colour(i), 1.4);
      picture_.marker({kLeft + 11, at}, i, colour(i));
      picture_.text({kLeft + 28, at + 3.5}, plot_.series[i].name, kText, kInk, Anchor::start);
    }
  }

  const LogLogPlot& plot_;
  LogAxis x_, y_;
  SvgPicture picture_;
};

}  // namespace

std::string draw_svg(const LogLogPlot& plot) { return Drawing(plot).draw(); }

std::string draw_html(const LogLogPlot& plot) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>" +
         escape_markup(plot.title) +
         "</title>\n<style>body { margin: 2em; background: #ffffff; } svg { width: 100%; max-width: 42em; "
         "height: auto; }</style></head>\n<body>\n" +
         draw_svg(plot) + "</body>\n</html>\n";
}

}  // namespace netloft::io
