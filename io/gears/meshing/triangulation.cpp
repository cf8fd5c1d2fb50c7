// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/triangulation.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/formats/work/long_work.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_no_edge_refinement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netloft::gears {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Faces = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Faces>,
                                               CGAL::No_constraint_intersection_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_no_edge_refinement_2<Triangulation, Criteria>;

// sin² of the least angle after refinement (20.7°). With this bound, the mesher is proven to terminate.
constexpr double kShape = 0.125;
constexpr double kLongest = 1.35;  // longest side of a triangle, relative to the requested mean
constexpr int kRounds = 5;         // rounds of smoothing
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
    connect();
    refine();
    return finish();
  }

  /// Connects the points without moving them or adding others.
  PlaneMesh connect_all() {
    connect();
    collect();
    open_corners();
    return std::move(mesh_);
  }

  PlaneMesh add(const std::vector<std::array<std::uint32_t, 2>>& sides, Smoothing smoothing) {
    for (const auto& [a, b] : sides)
      mesh_.points.push_back(
          {(mesh_.points[a][0] + mesh_.points[b][0]) / 2, (mesh_.points[a][1] + mesh_.points[b][1]) / 2});
    if (smoothing == Smoothing::none) return connect_all();
    connect();
    collect();
    return finish();
  }

 private:
  PlaneMesh finish() {
    for (int round = 0; round < kRounds; ++round) {
      formats::hear_interruption();
      smooth();
      connect();
      collect();
    }
    open_corners();
    return std::move(mesh_);
  }

  /// Makes the Delaunay triangulation of all points with the border as constraint.
  void connect() {
    cdt_.clear();
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      points.emplace_back(Kernel::Point_2(mesh_.points[i][0], mesh_.points[i][1]),
                          static_cast<std::uint32_t>(i));
    cdt_.insert(points.begin(), points.end());
    if (cdt_.number_of_vertices() != points.size())
      throw std::invalid_argument("two points of the border coincide");
    std::vector<Triangulation::Vertex_handle> corners(border_);
    for (const auto v : cdt_.finite_vertex_handles())
      if (v->info() < border_) corners[v->info()] = v;
    try {
      for (std::size_t i = 0; i < border_; ++i)
        cdt_.insert_constraint(corners[i], corners[(i + 1) % border_]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw std::invalid_argument("the border crosses itself");
    }
  }

  void refine() {
    Mesher mesher(cdt_, Criteria(kShape, kLongest * size_));
    mesher.clear_seeds();  // sets a flag that CGAL 5.5 reads and sets nowhere else
    mesher.init();
    while (mesher.step_by_step_refine_mesh()) formats::hear_interruption();
    std::uint32_t next = static_cast<std::uint32_t>(border_);
    for (const auto v : cdt_.finite_vertex_handles()) {
      const PlanePoint point{v->point().x(), v->point().y()};
      const bool is_border = v->info() < border_ && mesh_.points[v->info()] == point;
      if (is_border) continue;
      v->info() = next++;
      mesh_.points.push_back(point);
    }
    collect();
  }

  void collect() {
    mesh_.triangles.clear();
    mark_inside();
    for (const auto f : cdt_.finite_face_handles())
      if (f->is_in_domain())
        mesh_.triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

  /// Marks the triangles inside the border, which cannot be reached from outside without crossing it.
  void mark_inside() {
    for (const auto f : cdt_.all_face_handles()) f->set_in_domain(true);
    std::vector<Triangulation::Face_handle> outside{cdt_.infinite_face()};
    outside[0]->set_in_domain(false);
    while (!outside.empty()) {
      const auto f = outside.back();
      outside.pop_back();
      for (int k = 0; k < 3; ++k) {
        const auto next = f->neighbor(k);
        if (!next->is_in_domain() || f->is_constrained(k)) continue;
        next->set_in_domain(false);
        outside.push_back(next);
      }
    }
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
  /// triangle gets a part of it.
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
  Triangulation cdt_;
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

/// (2) in triangulation.hpp, not yet divided by their sum, for a point inside the first points of a mesh.
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
