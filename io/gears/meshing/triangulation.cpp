// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/triangulation.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/meshing/delaunay.hpp"
#include "io/gears/meshing/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netloft::gears {

namespace {

constexpr double kLongestSide = 1.35;  // longest side of a triangle, relative to the requested mean
constexpr int kRounds = 5;             // rounds of smoothing
// Corners of at least this angle are divided between triangles.
constexpr double kSharp = formats::in_radians(50);

double twice_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double angle_at(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double along = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
  return std::atan2(std::abs(twice_area(a, b, c)), along);
}

/// Fills one border; the member functions are steps in the order of execution.
class Filler {
 public:
  Filler(const std::vector<PlanePoint>& border, double size) : border_(border.size()), size_(size) {
    mesh_.points = border;
  }

  Filler(PlaneMesh mesh, std::size_t border, double size)
      : border_(border), size_(size), mesh_(std::move(mesh)) {}

  PlaneMesh fill() {
    Delaunay mesh = connected();
    refine(mesh, kLongestSide * size_);
    mesh_.points = mesh.points();
    return smoothed(std::move(mesh));
  }

  /// Connects the points without moving them or adding others.
  PlaneMesh connect_all() {
    collect(connected());
    open_corners();
    return std::move(mesh_);
  }

  PlaneMesh add(const std::vector<std::array<std::uint32_t, 2>>& sides, Smoothing smoothing) {
    for (const auto& [a, b] : sides)
      mesh_.points.push_back(
          {(mesh_.points[a][0] + mesh_.points[b][0]) / 2, (mesh_.points[a][1] + mesh_.points[b][1]) / 2});
    return smoothing == Smoothing::none ? connect_all() : smoothed(connected());
  }

 private:
  PlaneMesh smoothed(Delaunay mesh) {
    collect(mesh);
    for (int round = 0; round < kRounds; ++round) {
      formats::hear_interruption();
      smooth();
      for (std::size_t v = border_; v < mesh_.points.size(); ++v)
        mesh.move(static_cast<std::uint32_t>(v), mesh_.points[v]);
      mesh.restore();
      collect(mesh);
    }
    open_corners();
    return std::move(mesh_);
  }

  /// The Delaunay triangulation of all points, in which the sides of the border are held.
  Delaunay connected() const {
    Delaunay mesh(mesh_.points);
    for (std::size_t i = 0; i < border_; ++i)
      mesh.hold(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>((i + 1) % border_));
    mesh.mark_inside();
    return mesh;
  }

  void collect(const Delaunay& mesh) {
    mesh_.triangles.clear();
    for (const Delaunay::Triangle& t : mesh.triangles())
      if (t.is_inside) mesh_.triangles.push_back(t.corners);
  }

  /// Moves inner points to the mean of their neighbours, unless a triangle would turn over.
  void smooth() {
    std::vector<std::vector<std::uint32_t>> around(mesh_.points.size());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const auto v : mesh_.triangles[t]) around[v].push_back(t);
    for (int sweep = 0; sweep < 2; ++sweep)
      for (std::size_t v = border_; v < mesh_.points.size(); ++v) move_to_middle(v, around[v]);
  }

  void move_to_middle(std::size_t v, const std::vector<std::uint32_t>& around) {
    const PlanePoint before = mesh_.points[v];
    PlanePoint sum{0, 0};
    for (const auto t : around)
      for (const auto w : mesh_.triangles[t])
        if (w != v)
          for (const std::size_t k : {0u, 1u}) sum[k] += mesh_.points[w][k];
    const double n = 2 * static_cast<double>(around.size());
    mesh_.points[v] = {sum[0] / n, sum[1] / n};
    const double least = 1e-3 * size_ * size_;
    if (std::any_of(around.begin(), around.end(), [&](std::uint32_t t) { return area_of(t) < least; }))
      mesh_.points[v] = before;
  }

  double area_of(std::uint32_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return twice_area(mesh_.points[a], mesh_.points[b], mesh_.points[c]) / 2;
  }

  /// If two sides of a triangle lie on the border, divides the corner between them, so that a neighbouring
  /// triangle gets a part of the corner.
  void open_corners() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        auto& tri = mesh_.triangles[t];
        std::rotate(tri.begin(), tri.begin() + 1, tri.end());
        if (is_corner(tri)) open(t);
      }
  }

  bool follows(std::uint32_t a, std::uint32_t b) const {
    return a < border_ && b < border_ && (a + 1) % border_ == b;
  }

  /// Whether the first node is a corner of the border between two sides of the triangle.
  bool is_corner(const std::array<std::uint32_t, 3>& t) const {
    return follows(t[0], t[1]) && follows(t[2], t[0]) && mesh_.triangles.size() > 1 &&
           angle_at(mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]) > kSharp;
  }

  void open(std::uint32_t t) {
    const auto [a, b, c] = mesh_.triangles[t];
    for (auto& other : mesh_.triangles)
      for (int k = 0; k < 3; ++k) {
        std::rotate(other.begin(), other.begin() + 1, other.end());
        if (other[0] != c || other[1] != b) continue;
        const std::uint32_t d = other[2];
        const auto& p = mesh_.points;
        const double least = 1e-2 * std::abs(twice_area(p[a], p[b], p[c]));
        if (twice_area(p[a], p[b], p[d]) < least || twice_area(p[a], p[d], p[c]) < least) return;
        mesh_.triangles[t] = {a, b, d};
        other = {a, d, c};
        return;
      }
  }

  std::size_t border_;
  double size_;
  PlaneMesh mesh_;
};

}  // namespace

PlaneMesh triangulate(const std::vector<PlanePoint>& border, double size) {
  return Filler(border, size).fill();
}

PlaneMesh connect_points(const std::vector<PlanePoint>& border, const std::vector<PlanePoint>& inside) {
  PlaneMesh mesh{border, {}};
  mesh.points.insert(mesh.points.end(), inside.begin(), inside.end());
  return Filler(std::move(mesh), border.size(), 0).connect_all();
}

PlaneMesh split_sides(const PlaneMesh& mesh, std::size_t border, double size,
                      const std::vector<std::array<std::uint32_t, 2>>& sides, Smoothing smoothing) {
  return Filler(mesh, border, size).add(sides, smoothing);
}

namespace {

PlanePoint difference(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// The weights (2) in triangulation.hpp for a point inside a border, not yet divided by their sum. The border
/// consists of the first points of a mesh.
std::vector<double> mean_value_weights(const PlaneMesh& mesh, std::size_t border, const PlanePoint& x) {
  std::vector<PlanePoint> rays(border);
  std::vector<double> lengths(border), halves(border), weights(border);
  for (std::size_t i = 0; i < border; ++i) {
    rays[i] = difference(mesh.points[i], x);
    lengths[i] = std::hypot(rays[i][0], rays[i][1]);
  }
  for (std::size_t i = 0; i < border; ++i) {
    const PlanePoint &a = rays[i], &b = rays[(i + 1) % border];
    const double along = a[0] * b[0] + a[1] * b[1], across = a[0] * b[1] - a[1] * b[0];
    halves[i] = across / (lengths[i] * lengths[(i + 1) % border] + along);
  }
  for (std::size_t i = 0; i < border; ++i)
    weights[i] = (halves[(i + border - 1) % border] + halves[i]) / lengths[i];
  return weights;
}

}  // namespace

PlaneMesh moved_with_border(const PlaneMesh& mesh, const std::vector<PlanePoint>& border) {
  const std::size_t n = border.size();
  if (std::equal(border.begin(), border.end(), mesh.points.begin())) return mesh;
  PlaneMesh moved = mesh;
  std::copy(border.begin(), border.end(), moved.points.begin());
  for (std::size_t p = n; p < mesh.points.size(); ++p) {
    const std::vector<double> weights = mean_value_weights(mesh, n, mesh.points[p]);
    PlanePoint shift{};
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const PlanePoint d = difference(border[i], mesh.points[i]);
      shift = {shift[0] + weights[i] * d[0], shift[1] + weights[i] * d[1]};
      sum += weights[i];
    }
    moved.points[p] = {mesh.points[p][0] + shift[0] / sum, mesh.points[p][1] + shift[1] / sum};
  }
  for (const auto& [a, b, c] : moved.triangles)
    if (!(twice_area(moved.points[a], moved.points[b], moved.points[c]) > 0))
      throw std::invalid_argument("a triangle of its mesh would be turned over");
  return moved;
}

std::array<double, 3> angles_of(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return {angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)};
}

}  // namespace netloft::gears
