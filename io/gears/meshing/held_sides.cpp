// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/delaunay.hpp"

#include <cassert>
#include <deque>
#include <stdexcept>

namespace netloft::gears {

/// Replaces a side by the other diagonal of its two triangles.
///
///        a                a
///      / | \            /   \                                          .
///     c  |  d    to    c --- d      the side runs from b to a, c is opposite to it
///      \ | /            \   /                                          .
///        b                b
void Delaunay::flip(const Side& s) {
  const Side other = twin(s);
  const std::uint32_t t = s.triangle, u = other.triangle, a = to_of(s), b = from_of(s),
                      c = triangles_[t].corners[s.k], d = triangles_[u].corners[other.k];
  const Side ac{t, after(s.k)}, cb{t, before(s.k)}, bd{u, after(other.k)}, da{u, before(other.k)};
  const std::array<Side, 4> beyond{twin(cb), twin(bd), twin(da), twin(ac)};
  const std::array<bool, 4> held{triangles_[t].held[cb.k], triangles_[u].held[bd.k], triangles_[u].held[da.k],
                                 triangles_[t].held[ac.k]};
  const bool is_inside = triangles_[t].is_inside;
  triangles_[t] = {{c, b, d}, {}, {held[1], false, held[0]}, is_inside};
  triangles_[u] = {{d, a, c}, {}, {held[3], false, held[2]}, is_inside};
  join({t, 1}, {u, 1});
  join({t, 2}, beyond[0]);
  join({t, 0}, beyond[1]);
  join({u, 2}, beyond[2]);
  join({u, 0}, beyond[3]);
  one_at_[b] = one_at_[c] = t;
  one_at_[a] = one_at_[d] = u;
}

/// Whether the two triangles of a side lie within the hull and form a strictly convex quadrilateral.
bool Delaunay::can_be_flipped(const Side& s) const {
  const Side other = twin(s);
  if (is_far(s.triangle) || is_far(other.triangle)) return false;
  const std::uint32_t c = triangles_[s.triangle].corners[s.k],
                      d = triangles_[other.triangle].corners[other.k];
  return turn_of(c, from_of(s), d) > 0 && turn_of(d, to_of(s), c) > 0;
}

void Delaunay::restore() {
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (t < triangles_[t].across[k]) sides.push_back({t, k});
  restore(std::move(sides));
}

/// Flips sides, beginning with the given ones, until every side that is not held has the Delaunay property
/// (Lawson, 1977).
void Delaunay::restore(std::vector<Side> sides) {
  while (!sides.empty()) {
    const Side s = sides.back();
    sides.pop_back();
    if (triangles_[s.triangle].held[s.k] || is_far(s.triangle)) continue;
    const Side other = twin(s);
    if (is_far(other.triangle) || !circles(s.triangle, triangles_[other.triangle].corners[other.k])) continue;
    flip(s);
    for (const std::uint32_t t : {s.triangle, other.triangle})
      for (const int k : {0, 2}) sides.push_back({t, k});
  }
}

void Delaunay::hold(std::uint32_t a, std::uint32_t b) {
  while (a != b) {
    const auto [end, crossed] = crossed_sides(a, b);
    const std::vector<Ends> fresh = flip_away(crossed, a, end);
    const Side held = side_between(a, end);
    const Side other = twin(held);
    triangles_[held.triangle].held[held.k] = triangles_[other.triangle].held[other.k] = true;
    std::vector<Side> sides;
    for (const auto& [from, to] : fresh) sides.push_back(side_between(from, to));
    restore(std::move(sides));
    a = end;
  }
}

/// The first point on the line from a to b, and the sides that the line crosses before this point.
std::pair<std::uint32_t, std::vector<Delaunay::Ends>> Delaunay::crossed_sides(std::uint32_t a,
                                                                              std::uint32_t b) const {
  std::vector<Ends> crossed;
  Side ahead = first_crossed(a, b);
  if (from_of(ahead) == a) return {to_of(ahead), crossed};
  while (true) {
    if (triangles_[ahead.triangle].held[ahead.k]) throw std::invalid_argument("the border crosses itself");
    crossed.emplace_back(from_of(ahead), to_of(ahead));
    const Side beyond = twin(ahead);
    const std::uint32_t corner = triangles_[beyond.triangle].corners[beyond.k];
    const int side = turn_of(a, b, corner);
    if (side == 0) return {corner, crossed};
    ahead = {beyond.triangle, side > 0 ? after(beyond.k) : before(beyond.k)};
  }
}

/// The first side that the line from a to b crosses: the side opposite to a in a triangle at a. If the line
/// runs along a side that begins at a, the result is that side.
Delaunay::Side Delaunay::first_crossed(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t t = one_at_[a];
  do {
    const int k = corner_of(t, a);
    const Side opposite{t, k};
    const std::uint32_t right = from_of(opposite), left = to_of(opposite);
    if (right != kFar && is_between(right, a, b)) return {t, before(k)};
    if (!is_far(t) && turn_of(a, right, b) > 0 && turn_of(a, left, b) < 0) return opposite;
    t = triangles_[t].across[after(k)];
  } while (t != one_at_[a]);
  throw std::logic_error("no triangle at a point faces another point");
}

/// Whether a point is b or lies on the line between a and b.
bool Delaunay::is_between(std::uint32_t point, std::uint32_t a, std::uint32_t b) const {
  if (point == b) return true;
  const PlanePoint &p = points_[point], &from = points_[a], &to = points_[b];
  return turn(from, to, p) == 0 && (from < p) == (p < to);
}

/// Whether the line from a to b crosses a side, not counting the ends of either.
bool Delaunay::crosses(const Ends& side, std::uint32_t a, std::uint32_t b) const {
  const auto [from, to] = side;
  if (from == a || from == b || to == a || to == b) return false;
  return turn_of(a, b, from) * turn_of(a, b, to) < 0;
}

/// Flips the sides that cross the line from a to b until none does (Sloan, Comput. Struct. 47 (1993) 441).
/// Returns the new sides, without the line itself.
std::vector<Delaunay::Ends> Delaunay::flip_away(const std::vector<Ends>& crossed, std::uint32_t a,
                                                std::uint32_t b) {
  std::deque<Ends> open(crossed.begin(), crossed.end());
  std::vector<Ends> fresh;
  while (!open.empty()) {
    const Ends ends = open.front();
    open.pop_front();
    const Side s = side_between(ends.first, ends.second);
    if (!can_be_flipped(s)) {
      open.push_back(ends);
      continue;
    }
    const Side other = twin(s);
    const Ends come{triangles_[s.triangle].corners[s.k], triangles_[other.triangle].corners[other.k]};
    flip(s);
    if (crosses(come, a, b))
      open.push_back(come);
    else if (come != Ends{a, b} && come != Ends{b, a})
      fresh.push_back(come);
  }
  return fresh;
}

/// The side from a to b, which must exist.
Delaunay::Side Delaunay::side_between(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t t = one_at_[a];
  while (true) {
    const int k = corner_of(t, a);
    if (const Side s{t, before(k)}; to_of(s) == b) return s;
    t = triangles_[t].across[after(k)];
    assert(t != one_at_[a]);
  }
}

}  // namespace netloft::gears
