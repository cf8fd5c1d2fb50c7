// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

/// A bar chart, whose rows form groups. A row has one bar for each kind of value. Bars begin at zero; a
/// whisker shows the error of a value.
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
