// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/plan_sketch.hpp"

#include "io/formats/svg/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::pictures {

namespace {

constexpr double kTall = 420, kSketchMargin = 20, kNames = 150;  // [pixels]; kNames: room for names
constexpr const char *kInk = "#222", *kPale = "#555";

using Grid = std::array<long, 2>;  // a position in tenths of millimetres, so that equal corners compare equal
using GridSide = std::array<Grid, 2>;

/// The sides of a panel's triangles, with the number of triangles that have each side.
using GridSides = std::map<GridSide, int>;

Grid grid_of(const scenes::SheetPlace& s, double U, double V) {
  return {std::lround(1e4 * (s.x + U * s.x_across + V * s.x_deep)),
          std::lround(1e4 * (s.y + U * s.y_across + V * s.y_deep))};
}

std::map<std::uint32_t, GridSides> sides_of(const results::StoredShape& stored) {
  std::map<std::uint32_t, GridSides> all;
  const results::StoredMesh& mesh = stored.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto part = mesh.cell_part[mesh.triangle_cells[t]];
    const scenes::SheetPlace& sheet = stored.parts[part].sheet;
    const auto& uv = mesh.corners[t];
    if (!std::isfinite(sheet.x + uv[0] + uv[2] + uv[4])) continue;
    std::array<Grid, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = grid_of(sheet, uv[2 * k], uv[2 * k + 1]);
    for (std::size_t k = 0; k < 3; ++k) {
      GridSide side = {corner[k], corner[(k + 1) % 3]};
      std::sort(side.begin(), side.end());
      ++all[part][side];
    }
  }
  return all;
}

/// The bounding box of the sheet's content.
struct SketchBox {
  long left = 1L << 60, right = -(1L << 60), top = 1L << 60, bottom = -(1L << 60);
  void take(const Grid& p) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
    top = std::min(top, p[1]);
    bottom = std::max(bottom, p[1]);
  }
};

}  // namespace

std::string plan_sketch(const results::StoredShape& stored) {
  const auto sides = sides_of(stored);
  SketchBox whole;
  for (const auto& [part, all] : sides)
    for (const auto& [side, times] : all) {
      whole.take(side[0]);
      whole.take(side[1]);
    }
  if (sides.empty() || whole.bottom <= whole.top) return "";
  const double scale = kTall / static_cast<double>(whole.bottom - whole.top);
  const auto place = [&](const Grid& p) {
    return formats::PicturePoint{kSketchMargin + scale * static_cast<double>(p[0] - whole.left),
                                 kSketchMargin + scale * static_cast<double>(p[1] - whole.top)};
  };
  formats::SvgPicture picture;
  for (const auto& [part, all] : sides) {
    SketchBox box;
    for (const auto& [side, times] : all) {
      box.take(side[0]);
      box.take(side[1]);
      if (times == 1) picture.line(place(side[0]), place(side[1]), kInk, 1.2);
    }
    const formats::PicturePoint right = place({box.right, (box.top + box.bottom) / 2});
    picture.text({right.x + 6, right.y + 4}, stored.parts[part].name, 11, kPale, formats::Anchor::start);
  }
  const double width = place({whole.right, 0}).x + kNames;
  return picture.finish(width, kTall + 2 * kSketchMargin);
}

}  // namespace netloft::pictures
