// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/plot.hpp"

#include "io/formats/svg/linear_axis.hpp"
#include "io/formats/svg/log_axis.hpp"
#include "io/formats/svg/style.hpp"
#include "io/formats/svg/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace netloft::formats {

namespace {

// Lengths have the unit of the picture: kWidth units are a column of 8.5 cm, so one unit is 0.71 pt.
constexpr double kInnerHeight = 210;
constexpr double kLeft = 46, kRight = 10, kTop = 24, kMargin = 6;
constexpr double kShade = 0.2;  // opacity of bands
constexpr double kSmall = 8.5;
constexpr const char *kMinorGrid = "#f0f0f0", *kMarkInk = "#666666";

/// M. Okabe and K. Ito, Color Universal Design, 2008; yellow is left out because it is too light on white.
constexpr std::array<const char*, 7> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                              "#e69f00", "#56b4e9", "#000000"};

/// All x or all y values of a plot, including the ends of bands.
std::vector<double> values_of(const LinePlot& plot, bool of_x) {
  std::vector<double> values;
  for (const auto& series : plot.series) {
    for (const auto& p : series.points)
      if (std::isfinite(p.x) && std::isfinite(p.y)) values.push_back(of_x ? p.x : p.y);
    for (const auto& p : series.curve) values.push_back(of_x ? p.x : p.y);
    for (const auto& span : series.band) {
      values.push_back(of_x ? span.x : span.low);
      if (!of_x) values.push_back(span.high);
    }
  }
  for (const auto& mark : plot.marks)
    if (of_x) values.push_back(mark.x);
  return values;
}

std::unique_ptr<Axis> make_axis(AxisScale scale, const std::vector<double>& values) {
  if (scale == AxisScale::linear) return std::make_unique<LinearAxis>(values);
  return std::make_unique<LogAxis>(values);
}

class Drawing {
 public:
  explicit Drawing(const LinePlot& plot)
      : plot_(plot),
        x_(make_axis(plot.x_scale, values_of(plot, true))),
        y_(make_axis(plot.y_scale, values_of(plot, false))) {}

  std::string draw() {
    draw_ticks();
    draw_marks();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_band(i);
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_series(i);
    draw_frame();
    draw_legend();
    return picture_.finish(kWidth, legend_top() + kLegendLine * double(legend_lines()) + kMargin);
  }

 private:
  double x(double value) const { return kLeft + x_->place(value) * (kWidth - kLeft - kRight); }
  double y(double value) const { return bottom() - y_->place(value) * kInnerHeight; }
  static double bottom() { return kTop + kInnerHeight; }
  static double right() { return kWidth - kRight; }
  static double legend_top() { return bottom() + kAxisRoom; }
  std::size_t legend_lines() const { return plot_.series.size() + (has_hollow() ? 1 : 0); }
  bool has_hollow() const {
    return std::ranges::any_of(plot_.series, [](const PlotSeries& series) {
      return std::ranges::any_of(series.points, &PlotSeries::Point::is_hollow);
    });
  }
  static const char* colour(std::size_t series) { return kColours[series % kColours.size()]; }

  void draw_ticks() {
    for (const bool labelled : {false, true}) {  // labelled lines are drawn last
      const char* grid = labelled ? kGrid : kMinorGrid;
      for (const auto& tick : x_->ticks())
        if (tick.labelled == labelled)
          picture_.line({x(tick.value), kTop}, {x(tick.value), bottom()}, grid, 0.6);
      for (const auto& tick : y_->ticks())
        if (tick.labelled == labelled)
          picture_.line({kLeft, y(tick.value)}, {right(), y(tick.value)}, grid, 0.6);
    }
    for (const auto& tick : x_->ticks())
      if (tick.labelled)
        picture_.number({x(tick.value), bottom() + 13}, tick.value, x_->labels_powers(), kText,
                        Anchor::middle);
    for (const auto& tick : y_->ticks())
      if (tick.labelled)
        picture_.number({kLeft - 5, y(tick.value) + 3.5}, tick.value, y_->labels_powers(), kText,
                        Anchor::end);
  }

  void draw_frame() {
    picture_.frame({kLeft, kTop}, {right(), bottom()}, kInk);
    const double middle = (kLeft + right()) / 2;
    picture_.text({middle, bottom() + 28}, plot_.x_label, kText, kInk, Anchor::middle);
    picture_.rotated_text({11, (kTop + bottom()) / 2}, plot_.y_label, kText, kInk, Anchor::middle);
    picture_.text({middle, 15}, plot_.title, kText, kInk, Anchor::middle);
  }

  /// Draws marks from left to right with labels beside the lines. If two labels are close, the right one is
  /// placed lower.
  void draw_marks() {
    std::vector<PlotMark> marks = plot_.marks;
    std::erase_if(marks, [&](const PlotMark& mark) { return !x_->has_place(mark.x); });
    std::sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    for (const auto& mark : marks)
      picture_.line({x(mark.x), kTop}, {x(mark.x), bottom()}, kMarkInk, 0.9, "5 3");
    double last = -kWidth, depth = 0;
    for (const auto& mark : marks) {
      const double at = x(mark.x) - kLeft < kSmall + 3 ? x(mark.x) + kSmall : x(mark.x) - 3;
      depth = at - last < kSmall + 4 ? depth : 0;
      picture_.rotated_text({at, kTop + 4 + depth}, mark.label, kSmall, kMarkInk, Anchor::end, true);
      last = at;
      depth += kLetter * kSmall * static_cast<double>(mark.label.size());
    }
  }

  void draw_band(std::size_t i) {
    std::vector<PicturePoint> outline;
    const auto has_place = [&](const PlotSeries::Span& s) {
      return x_->has_place(s.x) && y_->has_place(s.low) && y_->has_place(s.high);
    };
    const auto& band = plot_.series[i].band;
    for (const auto& span : band)
      if (has_place(span)) outline.push_back({x(span.x), y(span.high)});
    for (auto span = band.rbegin(); span != band.rend(); ++span)
      if (has_place(*span)) outline.push_back({x(span->x), y(span->low)});
    picture_.area(outline, colour(i), kShade);
  }

  std::vector<PicturePoint> places_of(const std::vector<PlotSeries::Point>& points) const {
    std::vector<PicturePoint> places;
    for (const auto& p : points)
      if (x_->has_place(p.x) && y_->has_place(p.y)) places.push_back({x(p.x), y(p.y)});
    return places;
  }

  void draw_series(std::size_t i) {
    const PlotSeries& series = plot_.series[i];
    if (series.is_line)
      picture_.path(places_of(series.curve.empty() ? series.points : series.curve), colour(i), 1.4);
    for (const auto& point : series.points)
      for (const auto& at : places_of({point})) picture_.marker(at, i, colour(i), point.is_hollow);
  }

  void draw_legend() {
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const double at = legend_top() + kLegendLine * (double(i) + 0.5);
      if (plot_.series[i].is_line) picture_.line({kLeft, at}, {kLeft + 22, at}, colour(i), 1.4);
      picture_.marker({kLeft + 11, at}, i, colour(i));
      picture_.text({kLeft + 28, at + 3.5}, plot_.series[i].name, kText, kInk, Anchor::start);
    }
    if (!has_hollow()) return;
    const double at = legend_top() + kLegendLine * (double(plot_.series.size()) + 0.5);
    picture_.marker({kLeft + 11, at}, 0, kInk, true);
    picture_.text({kLeft + 28, at + 3.5}, plot_.hollow, kText, kInk, Anchor::start);
  }

  const LinePlot& plot_;
  std::unique_ptr<Axis> x_, y_;
  SvgPicture picture_;
};

}  // namespace

std::string draw_svg(const LinePlot& plot) { return Drawing(plot).draw(); }

std::string draw_html(const LinePlot& plot) { return draw_html(plot.title, {plot}); }

std::string draw_html(const std::string& heading, const std::vector<LinePlot>& plots) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>" + escape_markup(heading) +
      "</title>\n<style>body { margin: 2em; background: #ffffff; font-family: sans-serif; } svg { width: "
      "100%; max-width: 42em; height: auto; }</style></head>\n<body>\n";
  if (plots.size() != 1) page += "<h1>" + escape_markup(heading) + "</h1>\n";
  for (const LinePlot& plot : plots) page += draw_svg(plot);
  return page + "</body>\n</html>\n";
}

}  // namespace netloft::formats
