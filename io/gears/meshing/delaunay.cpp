// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/delaunay.hpp"

#include "io/gears/meshing/insertion_order.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace netloft::gears {

Delaunay::Delaunay(const std::vector<PlanePoint>& points) : points_(points), one_at_(points.size(), kFar) {
  std::vector<PlanePoint> sorted = points;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end())
    throw std::invalid_argument("two points of the border coincide");
  if (points.size() < 3) throw std::invalid_argument("the border has less than three points");
  std::vector<std::uint32_t> order = hilbert_order(points);
  const auto third = std::find_if(order.begin() + 2, order.end(),
                                  [&](std::uint32_t c) { return turn_of(order[0], order[1], c) != 0; });
  if (third == order.end()) throw std::invalid_argument("all points of the border lie on one line");
  std::rotate(order.begin() + 2, third, third + 1);
  start({order[0], order[1], order[2]});
  std::uint32_t last = 0;
  for (std::size_t i = 3; i < order.size(); ++i) {
    insert(order[i], walk(last, points_[order[i]]));
    last = around_.front();
  }
}

int Delaunay::corner_of(std::uint32_t t, std::uint32_t point) const {
  const auto& corners = triangles_[t].corners;
  assert(corners[0] == point || corners[1] == point || corners[2] == point);
  return corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
}

bool Delaunay::is_far(std::uint32_t t) const {
  const auto& corners = triangles_[t].corners;
  return corners[0] == kFar || corners[1] == kFar || corners[2] == kFar;
}

/// The same side as a side of the neighbouring triangle.
Delaunay::Side Delaunay::twin(const Side& s) const {
  const std::uint32_t beyond = triangles_[s.triangle].across[s.k];
  return {beyond, after(corner_of(beyond, from_of(s)))};
}

/// Joins two triangles along sides with the same ends.
void Delaunay::join(const Side& a, const Side& b) {
  triangles_[a.triangle].across[a.k] = b.triangle;
  triangles_[b.triangle].across[b.k] = a.triangle;
}

int Delaunay::turn_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return turn(points_[a], points_[b], points_[c]);
}

/// Makes the first triangle, and the three triangles outside its sides.
void Delaunay::start(const std::array<std::uint32_t, 3>& corners) {
  auto [a, b, c] = corners;
  if (turn_of(a, b, c) < 0) std::swap(b, c);
  constexpr std::array<bool, 3> kFree{false, false, false};
  triangles_ = {{{a, b, c}, {1, 2, 3}, kFree, false},
                {{kFar, c, b}, {0, 3, 2}, kFree, false},
                {{kFar, a, c}, {0, 1, 3}, kFree, false},
                {{kFar, b, a}, {0, 2, 1}, kFree, false}};
  for (const std::uint32_t v : {a, b, c}) one_at_[v] = 0;
}

/// The triangle that contains p, or, if p is outside the hull, an outer triangle whose hull side is visible
/// from p. Requires that no side is held. The walk crosses any side that has p beyond it; in a Delaunay
/// triangulation, such a walk always reaches p.
std::uint32_t Delaunay::walk(std::uint32_t t, const PlanePoint& p) const {
  if (is_far(t)) t = triangles_[t].across[corner_of(t, kFar)];
  for (int k = 0; k < 3 && !is_far(t);) {
    const Side s{t, k};
    if (turn(points_[from_of(s)], points_[to_of(s)], p) < 0) {
      t = triangles_[t].across[k];
      k = 0;
    } else {
      ++k;
    }
  }
  return t;
}

/// Whether the circumcircle of a triangle contains a point. For a triangle outside the hull, the circle is
/// the half plane beyond its side of the hull, including this side.
bool Delaunay::circles(std::uint32_t t, std::uint32_t point) const {
  const auto& corners = triangles_[t].corners;
  if (!is_far(t))
    return in_lifted_circle(points_[corners[0]], points_[corners[1]], points_[corners[2]], points_[point]) >
           0;
  const Side hull{t, corner_of(t, kFar)};
  const PlanePoint &a = points_[from_of(hull)], &b = points_[to_of(hull)], &p = points_[point];
  const int side = turn(a, b, p);
  return side > 0 || (side == 0 && (a < p) == (p < b));
}

/// Inserts a point by the method of Bowyer (Comput. J. 24 (1981) 162) and Watson: the triangles whose circles
/// contain the point are replaced by triangles with the point. The search for these triangles begins at t.
void Delaunay::insert(std::uint32_t point, std::uint32_t t) {
  dig(point, t);
  fill(point);
}

/// Finds the triangles to be removed, and the sides around them in their order around the point.
void Delaunay::dig(std::uint32_t point, std::uint32_t t) {
  dug_ = {t};
  rim_.clear();
  std::vector<Side> open{{t, 2}, {t, 1}, {t, 0}};
  while (!open.empty()) {
    const Side s = open.back();
    open.pop_back();
    const Side beyond = twin(s);
    if (triangles_[s.triangle].held[s.k] || !circles(beyond.triangle, point)) {
      rim_.push_back(beyond);
      continue;
    }
    dug_.push_back(beyond.triangle);
    open.push_back({beyond.triangle, before(beyond.k)});
    open.push_back({beyond.triangle, after(beyond.k)});
  }
}

/// Connects the point with the sides that dig() found; n sides enclose n - 2 triangles.
void Delaunay::fill(std::uint32_t point) {
  assert(rim_.size() == dug_.size() + 2);
  const bool is_inside = triangles_[dug_.front()].is_inside;
  around_ = dug_;
  for (int more = 0; more < 2; ++more) {
    around_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    triangles_.emplace_back();
  }
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const Side& outer = rim_[i];
    const std::uint32_t t = around_[i];
    const bool is_held = triangles_[outer.triangle].held[outer.k];
    triangles_[t] = {{point, to_of(outer), from_of(outer)}, {}, {is_held, false, false}, is_inside};
    join({t, 0}, outer);
    for (const std::uint32_t v : triangles_[t].corners)
      if (v != kFar) one_at_[v] = t;
  }
  for (std::size_t i = 0; i < around_.size(); ++i)
    join({around_[i], 1}, {around_[(i + 1) % around_.size()], 2});
}

const std::vector<std::uint32_t>& Delaunay::add(const PlanePoint& p, std::uint32_t t) {
  points_.push_back(p);
  one_at_.push_back(kFar);
  insert(static_cast<std::uint32_t>(points_.size() - 1), t);
  return around_;
}

void Delaunay::mark_inside() {
  for (Triangle& t : triangles_) t.is_inside = true;
  std::vector<std::uint32_t> outside;
  const auto leave = [&](std::uint32_t t) {
    if (!triangles_[t].is_inside) return;
    triangles_[t].is_inside = false;
    outside.push_back(t);
  };
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    if (is_far(t)) leave(t);
  while (!outside.empty()) {
    const Triangle& t = triangles_[outside.back()];
    outside.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!t.held[k]) leave(t.across[k]);
  }
}

std::uint32_t Delaunay::seen_from(std::uint32_t t, int k, const PlanePoint& p) const {
  const PlanePoint& eye = points_[triangles_[t].corners[k]];
  Side ahead{t, k};  // the line begins at the corner opposite to this side
  if (turn(eye, points_[from_of(ahead)], p) <= 0 || turn(eye, points_[to_of(ahead)], p) >= 0) return kFar;
  while (true) {
    const int side = turn(points_[from_of(ahead)], points_[to_of(ahead)], p);
    if (side > 0) return ahead.triangle;
    if (triangles_[ahead.triangle].held[ahead.k]) return kFar;
    const Side beyond = twin(ahead);
    const std::uint32_t corner = triangles_[beyond.triangle].corners[beyond.k];
    if (corner == kFar) return kFar;
    if (side == 0) return points_[from_of(ahead)] == p || points_[to_of(ahead)] == p ? kFar : ahead.triangle;
    ahead = {beyond.triangle, turn(eye, p, points_[corner]) > 0 ? after(beyond.k) : before(beyond.k)};
  }
}

}  // namespace netloft::gears
