// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/geometry.hpp"

#include "io/scenes/reading/geometry_keys.hpp"

namespace netloft::scenes {

Layout layout_of(const ElementType& type) {
  switch (type.element.stencil) {
    case NETLOFT_BAR:
      return declares(type, datum::kParallel) ? Layout::panel_in_bars : Layout::line;
    case NETLOFT_TRIANGLE:
      return Layout::panel_in_triangles;
    case NETLOFT_BODY:
      return Layout::body;
    default:
      return Layout::point;
  }
}

Point along_line(const std::vector<Point>& line, double t) {
  double total = 0;
  for (std::size_t i = 1; i < line.size(); ++i) total += distance(line[i - 1], line[i]);
  double left = t * total;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double leg = distance(line[i - 1], line[i]);
    if (left <= leg && leg > 0) return between_points(line[i - 1], line[i], left / leg);
    left -= leg;
  }
  return line.back();
}

Geometry read_point(formats::TableReader& part) {
  Geometry out;
  const Point at = read_one_point(part, kAt);
  append(out.positions, at);
  out.elements = {0};
  out.data[datum::kPieces.name] = {1};
  out.data[datum::kLength.name] = {0};
  out.names.sets["point"] = {0};
  return out;
}

Geometry read_line(formats::TableReader& part) {
  Geometry out;
  const double length = read_real(part, kLength);
  const auto n = static_cast<std::uint32_t>(read_integers(part, kBars)[0]);
  const auto sketch = read_points(part, kLine);
  if (sketch.size() < 2 || n < 1) return out;
  for (std::uint32_t i = 0; i <= n; ++i) append(out.positions, along_line(sketch, double(i) / n));
  for (std::uint32_t i = 0; i < n; ++i) out.elements.insert(out.elements.end(), {i, i + 1});
  out.data[datum::kRestLength.name].assign(n, length / n);
  out.names.cells = {static_cast<int>(n)};
  out.names.sets["start"] = {0};
  out.names.sets["end"] = {n};
  if (n % 2 == 0) out.names.sets["middle"] = {n / 2};
  return out;
}

}  // namespace netloft::scenes
