// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

/// A chart of groups of rows. Each row has one bar per kind; a bar begins at zero and has a whisker for its
/// error.
struct BarChart {
  struct Bar {
    double value, error;
  };
  struct Row {
    std::string name;
    std::vector<Bar> bars;  // bars in the order of the kinds
  };
  struct Group {
    std::string title;
    std::vector<Row> rows;
  };
  std::string x_label;
  std::vector<std::string> kinds;
  std::vector<Group> groups;
};

/// Draws the chart as a self-contained SVG with the width and the colours of a LinePlot (plot.hpp).
std::string draw_svg(const BarChart& chart);

}  // namespace netloft::formats
