// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

/// One line of a plot, with a marker at every point, in the order of the points.
struct PlotSeries {
  struct Point {
    double x, y;
    bool is_hollow = false;  // of its marker, with the meaning of LinePlot::hollow
  };
  /// Two ends above one x, between which the plot is shaded.
  struct Span {
    double x, low, high;
  };
  std::string name;
  std::vector<Point> points;
  std::vector<Span> band = {};    // in the order of x
  bool is_line = true;            // else markers alone
  std::vector<Point> curve = {};  // the line, where it does not lead straight from point to point
};

/// A dashed vertical line with a label at its top, at a special value of x.
struct PlotMark {
  double x;
  std::string label;
};

enum class AxisScale { linear, logarithmic };

/// Lines over two axes. Values that an axis has no place for are left out: those that are not finite, and on
/// a logarithmic one those that are not positive.
struct LinePlot {
  std::string title, x_label, y_label;  // labels with their unit: "CPU time [s]"
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks = {};
  AxisScale x_scale = AxisScale::logarithmic, y_scale = AxisScale::logarithmic;
  std::string hollow = {};  // meaning of hollow markers, in the last line of the legend if there are any
};

/// The plot as a self-contained SVG: white ground, colours that colour-blind readers can distinguish (Okabe
/// and Ito), a marker of its own for each series. Drawn for a column of 8.5 cm, in which letters are 7 pt
/// high.
std::string draw_svg(const LinePlot& plot);

/// The plot as an HTML page that needs no other file; several, one after the other under a heading.
std::string draw_html(const LinePlot& plot);
std::string draw_html(const std::string& heading, const std::vector<LinePlot>& plots);

}  // namespace netloft::formats
