// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

/// One line of a plot, with a marker at every point; the line connects the points in their order.
struct PlotSeries {
  struct Point {
    double x, y;
    bool is_hollow = false;  // whether its marker is hollow, as LinePlot::hollow explains
  };
  /// Two values at one x, between which the plot is shaded.
  struct Span {
    double x, low, high;
  };
  std::string name;
  std::vector<Point> points;
  std::vector<Span> band = {};    // spans in ascending order of x
  bool is_line = true;            // whether there is a line, or only markers
  std::vector<Point> curve = {};  // the line, if it is not straight between the points
};

/// A dashed vertical line with a label at its top, at a special value of x.
struct PlotMark {
  double x;
  std::string label;
};

enum class AxisScale { linear, logarithmic };

/// A plot of lines over two axes. Values that an axis cannot show are left out: values that are not finite,
/// and on a logarithmic axis values that are not positive.
struct LinePlot {
  std::string title, x_label, y_label;  // labels include the unit: "CPU time [s]"
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks = {};
  AxisScale x_scale = AxisScale::logarithmic, y_scale = AxisScale::logarithmic;
  std::string hollow = {};  // meaning of hollow markers, for the last line of the legend
};

/// Draws the plot as a self-contained SVG on white ground, in colours that colour-blind readers can
/// distinguish (Okabe and Ito), with a different marker for each series. At a width of 8.5 cm, letters are 7
/// pt high.
std::string draw_svg(const LinePlot& plot);

/// Draws one plot, or several below a heading, as an HTML page that needs no other file.
std::string draw_html(const LinePlot& plot);
std::string draw_html(const std::string& heading, const std::vector<LinePlot>& plots);

}  // namespace netloft::formats
