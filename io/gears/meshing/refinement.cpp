// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/refinement.hpp"

#include "io/formats/work/long_work.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace netloft::gears {

namespace {

constexpr double kSharpest = 0.125;  // sin² of the least angle; see refine()

PlanePoint minus(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
double dot(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }

/// A triangle to be refined. Triangles are ordered such that the worst one is the greatest.
struct BadTriangle {
  double excess;      // square of the longest side over the allowed one; 0 if the side is short enough
  double sharpness;   // minus sin² of the least angle
  std::uint64_t age;  // decreases from each new triangle to the next
  std::uint32_t triangle;
  std::array<std::uint32_t, 3> corners;
  int blunt;  // the corner with the largest angle

  friend bool operator<(const BadTriangle& a, const BadTriangle& b) {
    return std::tie(a.excess, a.sharpness, a.age) < std::tie(b.excess, b.sharpness, b.age);
  }
};

class Refiner {
 public:
  Refiner(Delaunay& mesh, double longest) : mesh_(mesh), longest_(longest) {
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) rate_triangle(t);
  }

  void run() {
    while (!bad_.empty()) {
      formats::hear_interruption();
      const BadTriangle worst = bad_.top();
      bad_.pop();
      if (mesh_.triangles()[worst.triangle].corners == worst.corners) split(worst);
    }
  }

 private:
  void rate_triangle(std::uint32_t t) {
    const auto& [corners, across, held, is_inside] = mesh_.triangles()[t];
    if (!is_inside) return;
    const auto [a, b, c] = points_of(corners);
    const std::array<PlanePoint, 3> sides{minus(c, b), minus(a, c), minus(b, a)};
    std::array<double, 3> squares{};
    for (std::size_t k = 0; k < 3; ++k) squares[k] = dot(sides[k], sides[k]);
    const auto [least, most] = std::ranges::minmax_element(squares);
    const double twice_area = cross(sides[0], sides[1]);
    const double sine = twice_area * twice_area * *least / (squares[0] * squares[1] * squares[2]),
                 excess = *most / (longest_ * longest_);
    if (excess <= 1 && sine >= kSharpest) return;
    bad_.push({excess > 1 ? excess : 0, -sine, --age_, t, corners, static_cast<int>(most - squares.begin())});
  }

  std::array<PlanePoint, 3> points_of(const std::array<std::uint32_t, 3>& corners) const {
    const auto& points = mesh_.points();
    return {points[corners[0]], points[corners[1]], points[corners[2]]};
  }

  void split(const BadTriangle& bad) {
    const PlanePoint centre = centre_of(bad.corners);
    const std::uint32_t there = mesh_.seen_from(bad.triangle, bad.blunt, centre);
    if (there == Delaunay::kFar) return;
    for (const std::uint32_t t : mesh_.add(centre, there)) rate_triangle(t);
  }

  PlanePoint centre_of(const std::array<std::uint32_t, 3>& corners) const {
    const auto [a, b, c] = points_of(corners);
    const PlanePoint u = minus(b, a), v = minus(c, a);
    const double uu = dot(u, u), vv = dot(v, v), area = 2 * cross(u, v);
    return {a[0] + (v[1] * uu - u[1] * vv) / area, a[1] + (u[0] * vv - v[0] * uu) / area};
  }

  Delaunay& mesh_;
  double longest_;
  std::uint64_t age_ = ~std::uint64_t{0};
  std::priority_queue<BadTriangle> bad_;
};

}  // namespace

void refine(Delaunay& mesh, double longest) { Refiner(mesh, longest).run(); }

}  // namespace netloft::gears
