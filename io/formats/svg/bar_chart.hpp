// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::formats {

/// Groups of rows with a bar of each kind, from zero, and a whisker over its error.
struct BarChart {
  struct Bar {
    double value, error;
  };
  struct Row {
    std::string name;
    std::vector<Bar> bars;  // in the order of the kinds
  };
  struct Group {
    std::string title;
    std::vector<Row> rows;
  };
  std::string x_label;
  std::vector<std::string> kinds;
  std::vector<Group> groups;
};

/// The bars as a self-contained SVG of the width and the colours of a LinePlot (plot.hpp).
std::string draw_svg(const BarChart& chart);

}  // namespace netloft::formats
