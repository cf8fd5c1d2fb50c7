// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/gear_painter.hpp"

#include <netloft/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace netloft::pictures {

namespace {

// Least distance of twines [pixels]. If twines are closer, only every second, fourth … twine is drawn.
constexpr double kCloseness = 5;
constexpr double kLeastTwine = 0.5;  // least half width [pixels]
constexpr double kLeastRope = 1.3;
constexpr double kLeastBall = 3.2;
constexpr double kFill = 0.32;  // opacity of netting between the drawn twines
// Distance by which ropes and floats are drawn nearer to the eye than the netting [m].
constexpr double kNearer = 0.05;
constexpr double kInside = 0.02;  // distance by which the catch is drawn behind the netting [m]

Colour scaled(const Colour& colour, double by) {
  const auto f = static_cast<float>(by);
  return {f * colour[0], f * colour[1], f * colour[2]};
}

Vec3<double> vector(const Point3& p) { return {p[0], p[1], p[2]}; }

/// A linear function on the picture, defined by its values at three corners.
struct Plane {
  double at_first, dx, dy;
  Plane(const std::array<Point3, 3>& p, double f0, double f1, double f2) : at_first(f0) {
    const double ax = p[1][0] - p[0][0], ay = p[1][1] - p[0][1], bx = p[2][0] - p[0][0],
                 by = p[2][1] - p[0][1], twice = ax * by - ay * bx;
    dx = ((f1 - f0) * by - (f2 - f0) * ay) / twice;
    dy = ((f2 - f0) * ax - (f1 - f0) * bx) / twice;
  }
  double operator()(double x, double y) const { return at_first + dx * x + dy * y; }
  double slope() const { return std::hypot(dx, dy); }
};

/// The fraction of a pixel that twines cover. Twines lie at whole numbers of `u`; `slope` is the change of u
/// per pixel. If twines are too close, only every second, fourth … twine is drawn. Twines fade out before
/// they are left out.
double twine_cover(double u, double slope, double half_width) {
  const double per_pixel = std::max(slope, 1e-9), level = std::max(0.0, std::log2(per_pixel * kCloseness));
  const double spacing = std::exp2(std::floor(level)), n = std::round(u / spacing);
  const double fade = std::fmod(std::abs(n), 2.0) < 0.5 ? 1 : 1 - (level - std::floor(level));
  return fade * std::clamp(half_width + 0.5 - std::abs(u - spacing * n) / per_pixel, 0.0, 1.0);
}

/// A side on the boundary of a part: only one triangle of the part has it.
struct Side {
  std::array<std::uint32_t, 2> nodes;
  std::uint32_t cell;
};

/// The outlines of the panels, which stay visible even if gathered netting has no area.
std::vector<Side> outline_of(const results::StoredMesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, std::pair<Side, int>> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      const auto cell = mesh.triangle_cells[t];
      ++sides.try_emplace({mesh.cell_part[cell], a, b}, Side{{a, b}, cell}, 0).first->second.second;
    }
  std::vector<Side> outline;
  for (const auto& [key, side] : sides)
    if (side.second == 1) outline.push_back(side.first);
  return outline;
}

/// Paints one gear, with samples offset by (dx, dy) from the corners of the pixels.
class GearPainter {
 public:
  GearPainter(const GearShape& shape, const Projection& projection, Canvas& canvas)
      : shape_(shape),
        mesh_(shape.stored->mesh),
        outline_(outline_of(mesh_)),
        shows_contacts_(shape.shows_contacts()),
        projection_(projection),
        canvas_(canvas) {}

  void paint(double dx, double dy) {
    dx_ = dx;
    dy_ = dy;
    for (const double sign :
         shape_.stored->result.is_half() ? std::vector<double>{1, -1} : std::vector<double>{1}) {
      place(sign);
      paint_catch();
      paint_solids(sign);
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) paint_triangle(t);
      for (std::size_t b = 0; b < mesh_.bars.size(); ++b) paint_bar(b);
      for (const auto& side : outline_)
        paint_line(side.nodes[0], side.nodes[1], colour(results::CellKind::netting, side.cell), kLeastTwine);
      for (std::size_t d = 0; d < mesh_.dots.size(); ++d)
        if (part(mesh_.dot_cells[d]).is_contact == shows_contacts_ && !has_plate(d)) paint_dot(d);
    }
  }

 private:
  void place(double sign) {
    at_.clear();
    for (const auto& node : shape_.nodes) at_.push_back(projection_({node[0], sign * node[1], node[2]}));
  }

  /// Calls visit(column, row, x, y) for every sample in a box.
  template <class Visit>
  void for_samples(double left, double right, double top, double bottom, Visit&& visit) const {
    const auto first = [](double lo, double shift) { return std::max(0.0, std::ceil(lo - shift)); };
    for (double row = first(top, dy_); row + dy_ <= bottom && row < static_cast<double>(canvas_.height());
         ++row)
      for (double column = first(left, dx_);
           column + dx_ <= right && column < static_cast<double>(canvas_.width()); ++column)
        visit(static_cast<std::size_t>(column), static_cast<std::size_t>(row), column + dx_, row + dy_);
  }

  Colour colour(results::CellKind kind, std::uint32_t cell) const {
    return shape_.colour_of_cell(kind, cell);
  }
  const results::StoredPart& part(std::uint32_t cell) const {
    return shape_.stored->parts[mesh_.cell_part[cell]];
  }
  double half_pixels(std::uint32_t cell, double least) const {
    const double diameter = part(cell).diameter;
    return std::max(least, std::isfinite(diameter) ? diameter / 2 * projection_.pixels_per_metre : 0);
  }

  /// Calls visit(column, row, b, c, rx, ry) for every sample within a triangle: b and c are the weights of
  /// its second and third corner, and (rx, ry) is the sample's offset from the first corner [pixels].
  template <class Visit>
  void for_inside(const std::array<Point3, 3>& p, Visit&& visit) const {
    const Plane second(p, 0, 1, 0), third(p, 0, 0, 1);
    const auto [left, right] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [top, bottom] = std::minmax({p[0][1], p[1][1], p[2][1]});
    for_samples(left, right, top, bottom, [&](std::size_t column, std::size_t row, double x, double y) {
      const double rx = x - p[0][0], ry = y - p[0][1], b = second(rx, ry), c = third(rx, ry);
      if (b >= 0 && c >= 0 && b + c <= 1) visit(column, row, b, c, rx, ry);
    });
  }

  std::array<Point3, 3> corners_of(std::size_t t) const {
    const auto& nodes = mesh_.triangles[t];
    return {at_[nodes[0]], at_[nodes[1]], at_[nodes[2]]};
  }

  void paint_triangle(std::size_t t) {
    const auto p = corners_of(t);
    if (is_edge_on(p)) return;
    const auto cell = mesh_.triangle_cells[t];
    const Plane depth(p, p[0][2], p[1][2], p[2][2]);
    const auto twines = twines_of(t, p);
    const double half_width = half_pixels(cell, kLeastTwine), light = light_on(depth);
    const auto values = shape_.field ? shape_.at_corners[t] : std::array<double, 3>{};
    for_inside(p, [&](std::size_t column, std::size_t row, double b, double c, double rx, double ry) {
      double cover = 0;
      for (const auto& u : twines) cover = std::max(cover, twine_cover(u(rx, ry), u.slope(), half_width));
      const Colour seen = shape_.colour(results::CellKind::netting, cell,
                                        (1 - b - c) * values[0] + b * values[1] + c * values[2]);
      canvas_.add(column, row, depth(rx, ry), scaled(seen, light), kFill);
      canvas_.add(column, row, depth(rx, ry) + 1e-4, seen, cover);
    });
  }

  static bool is_edge_on(const std::array<Point3, 3>& p) {
    return !(std::abs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) >
             1e-9);
  }

  /// The brightness of a surface; it is larger if the surface faces the eye.
  double light_on(const Plane& depth) const {
    const double steepness = depth.slope() * projection_.pixels_per_metre;
    return light_at(1 / std::sqrt(1 + steepness * steepness));
  }

  static double light_at(double towards_the_eye) { return 0.62 + 0.38 * towards_the_eye; }

  /// Paints the catch as a body within the netting. Its front is closed by triangles from the rim to the
  /// middle of the rim. They are lit like one plane, because the rim follows the sides of netting triangles
  /// in a zigzag.
  void paint_catch() {
    const Solid catch_body{kCatchColour, kInside, {}};
    for (const auto t : shape_.fish.triangles) paint_solid(corners_of(t), catch_body);
    const Point3 middle = middle_of_rim();
    const double light = light_at(std::abs(dot(normal_of_front(middle), vector(projection_.eye))));
    for (const auto& [a, b] : shape_.fish.rim)
      paint_solid({at_[a], at_[b], projection_(middle)}, {kCatchColour, kInside, light});
  }

  Point3 middle_of_rim() const {
    Point3 middle{};
    for (const auto& side : shape_.fish.rim)
      for (const auto node : side)
        for (std::size_t k = 0; k < 3; ++k)
          middle[k] += shape_.nodes[node][k] / (2.0 * static_cast<double>(shape_.fish.rim.size()));
    if (shape_.stored->result.is_half()) middle[1] = 0;
    return middle;
  }

  /// The mean normal of the triangles of the front, whose orientations may differ.
  Vec3<double> normal_of_front(const Point3& middle) const {
    const Vec3<double> m = vector(middle);
    Vec3<double> sum;
    for (const auto& [a, b] : shape_.fish.rim) {
      const Vec3<double> n = cross(vector(shape_.nodes[a]) - m, vector(shape_.nodes[b]) - m);
      sum += dot(n, sum) < 0 ? -1.0 * n : n;
    }
    if (shape_.stored->result.is_half()) sum.y = 0;
    return norm(sum) > 0 ? (1 / norm(sum)) * sum : sum;
  }

  /// Paints boards and the ship.
  void paint_solids(double sign) {
    for (const auto& plate : shape_.plates)
      paint_triangles(plate.triangles, sign, shape_.colour_of_plate(plate));
    paint_triangles(shape_.hulls, sign, kShipColour);
  }

  void paint_triangles(const std::vector<Point3>& corners, double sign, const Colour& colour) {
    const auto at = [&](std::size_t i) {
      return projection_({corners[i][0], sign * corners[i][1], corners[i][2]});
    };
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      paint_solid({at(i), at(i + 1), at(i + 2)}, {colour, 0, {}});
  }

  bool has_plate(std::size_t dot) const {
    return std::any_of(shape_.plates.begin(), shape_.plates.end(),
                       [&](const results::BodyPlate& plate) { return plate.dot == dot; });
  }

  struct Solid {
    Colour colour;
    double behind;                // distance by which the triangle is moved away from the eye [m]
    std::optional<double> light;  // brightness; if empty, it depends on the orientation of the triangle
  };

  void paint_solid(const std::array<Point3, 3>& p, const Solid& solid) {
    if (is_edge_on(p)) return;
    const Plane depth(p, p[0][2], p[1][2], p[2][2]);
    const Colour lit = scaled(solid.colour, solid.light ? *solid.light : light_on(depth));
    for_inside(p, [&](std::size_t column, std::size_t row, double, double, double rx, double ry) {
      canvas_.add(column, row, depth(rx, ry) - solid.behind, lit, 1);
    });
  }

  /// The coordinates along both twine directions, as linear functions on the picture; empty if the
  /// coordinates are unknown.
  std::vector<Plane> twines_of(std::size_t t, const std::array<Point3, 3>& p) const {
    const auto& axes = part(mesh_.triangle_cells[t]).twine_axes;
    const auto& uv = mesh_.corners[t];
    std::vector<Plane> twines;
    for (const std::size_t k : {0u, 2u}) {
      std::array<double, 3> u;
      for (std::size_t c = 0; c < 3; ++c) u[c] = axes[k] * uv[2 * c] + axes[k + 1] * uv[2 * c + 1];
      if (std::isfinite(u[0] + u[1] + u[2])) twines.emplace_back(p, u[0], u[1], u[2]);
    }
    return twines;
  }

  void paint_bar(std::size_t i) {
    const auto cell = mesh_.bar_cells[i];
    paint_line(mesh_.bars[i][0], mesh_.bars[i][1], colour(results::CellKind::rope, cell),
               half_pixels(cell, kLeastRope));
  }

  /// Paints a line; `w` is half of its width in pixels.
  void paint_line(std::uint32_t from, std::uint32_t to, const Colour& colour, double w) {
    const Point3 &a = at_[from], &b = at_[to];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double length = dx * dx + dy * dy;
    for_samples(std::min(a[0], b[0]) - w, std::max(a[0], b[0]) + w, std::min(a[1], b[1]) - w,
                std::max(a[1], b[1]) + w, [&](std::size_t column, std::size_t row, double x, double y) {
                  const double s =
                      length > 0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length, 0.0, 1.0) : 0;
                  const double off = std::hypot(x - a[0] - s * dx, y - a[1] - s * dy) / w;
                  if (off > 1) return;
                  canvas_.add(column, row, a[2] + s * (b[2] - a[2]) + kNearer,
                              scaled(colour, 0.55 + 0.45 * std::sqrt(1 - off * off)), 1);
                });
  }

  void paint_dot(std::size_t i) {
    const Point3& at = at_[mesh_.dots[i]];
    const auto cell = mesh_.dot_cells[i];
    const double r = half_pixels(cell, kLeastBall);
    const Colour own = colour(results::CellKind::point, cell);
    for_samples(at[0] - r, at[0] + r, at[1] - r, at[1] + r,
                [&](std::size_t column, std::size_t row, double x, double y) {
                  const double off = std::hypot(x - at[0], y - at[1]) / r;
                  if (off > 1) return;
                  const double bulge = std::sqrt(1 - off * off);
                  canvas_.add(column, row, at[2] + 2 * kNearer, scaled(own, 0.45 + 0.55 * bulge), 1);
                });
  }

  const GearShape& shape_;
  const results::StoredMesh& mesh_;
  std::vector<Side> outline_;
  bool shows_contacts_;
  const Projection& projection_;
  Canvas& canvas_;
  std::vector<Point3> at_;
  double dx_ = 0, dy_ = 0;
};

/// Adds the colours of one sampling to the sums over all samplings.
void add_samples(const Canvas& canvas, const Colour& ground, std::vector<Colour>& sums) {
  for (std::size_t y = 0; y < canvas.height(); ++y)
    for (std::size_t x = 0; x < canvas.width(); ++x) {
      const Colour seen = canvas.resolve(x, y, ground);
      for (std::size_t k = 0; k < 3; ++k) sums[y * canvas.width() + x][k] += seen[k];
    }
}

}  // namespace

Image paint(const GearShape& shape, const Projection& projection, std::size_t width, std::size_t height,
            const Colour& ground) {
  // No two of these eight samples of a pixel are in the same row or column, like rooks on a chessboard that
  // do not attack each other.
  constexpr std::array<std::array<double, 2>, 8> kSamples = {{{0.0625, 0.4375},
                                                              {0.1875, 0.8125},
                                                              {0.3125, 0.1875},
                                                              {0.4375, 0.6875},
                                                              {0.5625, 0.0625},
                                                              {0.6875, 0.9375},
                                                              {0.8125, 0.3125},
                                                              {0.9375, 0.5625}}};
  Canvas canvas(width, height);
  std::vector<Colour> sums(width * height, Colour{0, 0, 0});
  GearPainter painter(shape, projection, canvas);
  for (const auto& [dx, dy] : kSamples) {
    canvas.clear();
    painter.paint(dx, dy);
    add_samples(canvas, ground, sums);
  }
  Image image(width, height, ground);
  for (std::size_t i = 0; i < sums.size(); ++i)
    image.set(i % width, i / width, scaled(sums[i], 1.0 / kSamples.size()));
  return image;
}

}  // namespace netloft::pictures
