// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/plane_predicates.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace netloft::gears {

/// The constrained Delaunay triangulation of points in the plane: the circumcircle of a triangle contains no
/// point that can be seen from the triangle. Some sides are *held*: they must exist, and nothing can be seen
/// through them. The result depends only on the points and the held sides (in_lifted_circle()), and all
/// decisions are exact.
///
/// Triangles are counter-clockwise. Side k of a triangle is opposite to its corner k. The plane outside the
/// convex hull consists of triangles with the corner kFar; each of them has a side of the hull.
class Delaunay {
 public:
  static constexpr std::uint32_t kFar = 0xffffffff;

  struct Triangle {
    std::array<std::uint32_t, 3> corners, across;  // `across`: the triangle beyond each side
    std::array<bool, 3> held;
    bool is_inside;  // see mark_inside()
  };

  /// Throws std::invalid_argument if two points coincide, or all lie on one line.
  explicit Delaunay(const std::vector<PlanePoint>& points);

  const std::vector<PlanePoint>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// Makes the line between two points a held side, or several held sides if other points are on the line.
  /// Throws std::invalid_argument if the line crosses a held side.
  void hold(std::uint32_t a, std::uint32_t b);

  /// Marks the triangles that cannot be reached from kFar without crossing a held side.
  void mark_inside();

  /// Moves a point without changing any triangle. No triangle may turn over. Call restore() after all moves.
  void move(std::uint32_t point, const PlanePoint& to) { points_[point] = to; }
  void restore();

  /// The triangle that contains `p`, found along the straight line from corner k of triangle t to p. The
  /// result is kFar if the line does not begin within triangle t, if it crosses a held side or the hull, or
  /// if p lies on a held side, on the hull or on another point.
  std::uint32_t seen_from(std::uint32_t t, int k, const PlanePoint& p) const;

  /// Adds a point within triangle t, or on one of its sides that is not held. Returns the triangles around
  /// the point.
  const std::vector<std::uint32_t>& add(const PlanePoint& p, std::uint32_t t);

 private:
  struct Side {
    std::uint32_t triangle;
    int k;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  static int after(int k) { return k == 2 ? 0 : k + 1; }
  static int before(int k) { return k == 0 ? 2 : k - 1; }
  int corner_of(std::uint32_t t, std::uint32_t point) const;
  std::uint32_t from_of(const Side& s) const { return triangles_[s.triangle].corners[after(s.k)]; }
  std::uint32_t to_of(const Side& s) const { return triangles_[s.triangle].corners[before(s.k)]; }
  bool is_far(std::uint32_t t) const;
  Side twin(const Side& s) const;
  void join(const Side& a, const Side& b);
  int turn_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  void start(const std::array<std::uint32_t, 3>& corners);
  std::uint32_t walk(std::uint32_t t, const PlanePoint& p) const;
  bool circles(std::uint32_t t, std::uint32_t point) const;
  void insert(std::uint32_t point, std::uint32_t t);
  void dig(std::uint32_t point, std::uint32_t t);
  void fill(std::uint32_t point);

  void flip(const Side& s);
  void restore(std::vector<Side> sides);
  std::pair<std::uint32_t, std::vector<Ends>> crossed_sides(std::uint32_t a, std::uint32_t b) const;
  Side first_crossed(std::uint32_t a, std::uint32_t b) const;
  std::vector<Ends> flip_away(const std::vector<Ends>& crossed, std::uint32_t a, std::uint32_t b);
  bool is_between(std::uint32_t point, std::uint32_t a, std::uint32_t b) const;
  bool crosses(const Ends& side, std::uint32_t a, std::uint32_t b) const;
  Side side_between(std::uint32_t a, std::uint32_t b) const;
  bool can_be_flipped(const Side& s) const;

  std::vector<PlanePoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> one_at_;  // a triangle at each point
  // During the insertion of a point: the triangles to be removed, the sides around them (seen from outside),
  // and the new triangles.
  std::vector<std::uint32_t> dug_, around_;
  std::vector<Side> rim_;
};

}  // namespace netloft::gears
