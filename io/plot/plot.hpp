// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::io {

/// One line of a plot, with a marker at every point, in the order of the points.
struct PlotSeries {
  struct Point {
    double x, y;
  };
  std::string name;
  std::vector<Point> points;
};

/// A dashed vertical line with a label at its top, at a special value of x.
struct PlotMark {
  double x;
  std::string label;
};

/// Lines over two logarithmic axes. Values that are not positive and finite are left out.
struct LogLogPlot {
  std::string title, x_label, y_label;  // labels with their unit: "CPU time [s]"
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
};

/// The plot as a self-contained SVG: white ground, colours that colour-blind readers can distinguish (Okabe
/// and Ito), a marker of its own for each series. Drawn for a column of 8.5 cm, in which letters are 7 pt
/// high.
std::string draw_svg(const LogLogPlot& plot);

/// The plot as an HTML page that needs no other file.
std::string draw_html(const LogLogPlot& plot);

}  // namespace netloft::io
