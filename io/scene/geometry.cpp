// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/geometry.hpp"

#include "io/gear/twine_coordinates.hpp"

#include <netloft/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>

namespace netloft::io {

namespace {

constexpr std::int64_t kMostCells = 100000;      // along one direction
constexpr std::int64_t kMostElements = 4000000;  // of one part

using Point = std::array<double, 3>;

using Shape = GeometryKey::Shape;
const Range kCoordinates = between(-1e6, 1e6);
const Range kMeshes{.lo = 0, .hi = 1e6, .lo_open = true};

const GeometryKey kAt{"at", "m", "where the point starts", Shape::points, kCoordinates, exactly(1)};
const GeometryKey kLength{
    "length", "m", "unstretched length of the rope", Shape::real, {.lo = 0, .hi = 1e6, .lo_open = true}, {}};
const GeometryKey kBars{"cells", "1", "bars the rope is divided into", Shape::integer, between(1, kMostCells),
                        {}};
const GeometryKey kLine{"sketch",      "m",          "points of the line along which the rope starts",
                        Shape::points, kCoordinates, {.least = 2}};
const GeometryKey kAcross{"panel.across", "1", "meshes across the panel", Shape::real, kMeshes, {}};
const GeometryKey kAlong{"panel.along", "1", "meshes along the panel", Shape::real, kMeshes, {}};
const GeometryKey kBar{"panel.bar",
                       "m",
                       "unstretched bar, from knot to knot: half the mesh size",
                       Shape::real,
                       {.lo = 0, .hi = 100, .lo_open = true},
                       {}};
const GeometryKey kNetting{
    "panel.netting",
    "1",
    "how the netting hangs: diamond, meshes along; t90, the same turned by a right angle; "
    "square, one twine direction along",
    Shape::word,
    {},
    {},
    false,
    {"diamond", "t90", "square"}};
const GeometryKey kCells{
    "cells",   "1", "cells across and along, divided into triangles", Shape::integers, between(1, kMostCells),
    exactly(2)};
const GeometryKey kDivision{
    "division",
    "1",
    "triangles of a cell: alternating, two, the diagonal changing from cell to cell; crossed, four about a "
    "node in the middle",
    Shape::word,
    {},
    {},
    false,
    {"alternating", "crossed"}};
const GeometryKey kSquareCells{"cells",
                               "1",
                               "cells across and along, as many meshes wide as long, four bars each",
                               Shape::integers,
                               between(1, kMostCells),
                               exactly(2)};
const GeometryKey kCorners{
    "sketch",      "m",          "corners: fore left, fore right, aft right, aft left; need not be accurate",
    Shape::points, kCoordinates, exactly(4),
    false};
const Range kRadii = between(0, 1e4);
const GeometryKey kFrom{"tube.from",   "m",          "middle of the fore edge, of a panel sketched as a tube",
                        Shape::points, kCoordinates, exactly(1),
                        false};
const GeometryKey kTo{"tube.to",  "m",  "middle of the aft edge of the tube", Shape::points, kCoordinates,
                      exactly(1), false};
const GeometryKey kRadius{"tube.radius", "m", "radius of the tube", Shape::real, kRadii, {}, false};
const GeometryKey kRadiusAft{
    "tube.radius_aft", "m", "radius at the aft edge, if it is another one", Shape::real, kRadii, {}, false};

/// The last word of a dotted name.
std::string leaf(const GeometryKey& key) { return key.name.substr(key.name.find('.') + 1); }

double read_real(TableReader& table, const GeometryKey& key, std::optional<double> fallback = {}) {
  return table.real(leaf(key), {.unit = key.unit, .doc = key.doc, .range = key.range, .fallback = fallback});
}

std::string read_word(TableReader& table, const GeometryKey& key) {
  return table.choice(leaf(key), {.allowed = key.words, .doc = key.doc, .fallback = key.words[0]});
}

/// A point that is needed; the origin if something is wrong with it.
Point read_one_point(TableReader& table, const GeometryKey& key) {
  const auto at =
      table.reals(leaf(key), {.unit = key.unit, .doc = key.doc, .range = key.range, .count = exactly(3)});
  return at.size() == 3 ? Point{at[0], at[1], at[2]} : Point{};
}

std::vector<std::int64_t> read_integers(TableReader& table, const GeometryKey& key) {
  const auto lo = static_cast<std::int64_t>(key.range.lo), hi = static_cast<std::int64_t>(key.range.hi);
  if (key.shape == Shape::integer) return {table.integer(leaf(key), {.doc = key.doc, .lo = lo, .hi = hi})};
  return table.integers(leaf(key), {.doc = key.doc, .lo = lo, .hi = hi, .count = key.count});
}

std::vector<Point> read_points(TableReader& table, const GeometryKey& key) {
  std::vector<Point> points;
  for (const auto& row : table.rows(
           leaf(key),
           {.unit = key.unit, .doc = key.doc, .range = key.range, .rows = key.count, .columns = exactly(3)}))
    if (row.size() == 3) points.push_back({row[0], row[1], row[2]});
  return points;
}

double distance(const Point& a, const Point& b) { return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]); }

Point between_points(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

void append(std::vector<double>& positions, const Point& p) {
  positions.insert(positions.end(), p.begin(), p.end());
}

/// Rows and columns of a structured panel.
struct Grid {
  std::size_t across, along;
  std::size_t columns() const { return across + 1; }
  std::uint32_t node(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(j * columns() + i);
  }
};

void name_edges(const Grid& g, PartGeometry& names) {
  names.cells = {static_cast<int>(g.across), static_cast<int>(g.along)};
  for (std::size_t i = 0; i <= g.across; ++i) {
    names.sets["fore"].push_back(g.node(i, 0));
    names.sets["aft"].push_back(g.node(i, g.along));
  }
  for (std::size_t j = 0; j <= g.along; ++j) {
    names.sets["left"].push_back(g.node(0, j));
    names.sets["right"].push_back(g.node(g.across, j));
  }
  names.sets["fore-left"] = {g.node(0, 0)};
  names.sets["fore-right"] = {g.node(g.across, 0)};
  names.sets["aft-left"] = {g.node(0, g.along)};
  names.sets["aft-right"] = {g.node(g.across, g.along)};
}

/// Where a panel starts: the point a share s of the way across and t of the way along.
using Surface = std::function<Point(double s, double t)>;

/// The bilinear surface through the four corners.
Surface through_corners(std::vector<Point> corner) {
  return [corner = std::move(corner)](double s, double t) {
    return between_points(between_points(corner[0], corner[1], s), between_points(corner[3], corner[2], s),
                          t);
  };
}

Vec3<double> vector(const Point& p) { return {p[0], p[1], p[2]}; }

/// c(t) + r(t) (cos 2πs e₁ + sin 2πs e₂) about the axis a, e₁ × e₂ = a; e₁ is as much upwards as can be.
Surface round_an_axis(const Point& from, const Point& to, double radius, double radius_aft) {
  const Vec3<double> way = vector(to) - vector(from), a = (1 / norm(way)) * way;
  const Vec3<double> up = std::abs(a.z) > 0.999 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 0, 1};
  const Vec3<double> across = up - dot(up, a) * a, e1 = (1 / norm(across)) * across, e2 = cross(a, e1);
  return [=](double s, double t) {
    const double r = radius + t * (radius_aft - radius), angle = 2 * std::numbers::pi * s;
    const Vec3<double> x =
        vector(between_points(from, to, t)) + r * (std::cos(angle) * e1 + std::sin(angle) * e2);
    return Point{x.x, x.y, x.z};
  };
}

void place_nodes(const Grid& g, const Surface& surface, double meshes_across, double meshes_along,
                 Geometry& out) {
  for (std::size_t j = 0; j <= g.along; ++j)
    for (std::size_t i = 0; i <= g.across; ++i) {
      const double s = double(i) / double(g.across), t = double(j) / double(g.along);
      append(out.positions, surface(s, t));
      out.names.panel.push_back({meshes_across * s, meshes_along * t});
    }
}

}  // namespace

Layout layout_of(const ElementType& type) {
  const bool bundles = std::any_of(type.data.begin(), type.data.end(),
                                   [](const auto& d) { return std::string_view(d.name) == "parallel"; });
  switch (type.element.stencil) {
    case NETLOFT_BAR:
      return bundles ? Layout::panel_in_bars : Layout::line;
    case NETLOFT_TRIANGLE:
      return Layout::panel_in_triangles;
    default:
      return Layout::point;
  }
}

const std::vector<GeometryKey>& geometry_keys(Layout layout) {
  static const std::vector<GeometryKey> point{kAt}, line{kLength, kBars, kLine},
      triangles{kAcross,  kAlong, kBar, kNetting, kCells,    kDivision,
                kCorners, kFrom,  kTo,  kRadius,  kRadiusAft},
      bars{kAcross, kAlong, kBar, kSquareCells, kCorners, kFrom, kTo, kRadius, kRadiusAft};
  switch (layout) {
    case Layout::line:
      return line;
    case Layout::panel_in_triangles:
      return triangles;
    case Layout::panel_in_bars:
      return bars;
    default:
      return point;
  }
}

const std::vector<std::string>& geometry_data(Layout layout) {
  static const std::vector<std::string> point{"share", "length"}, line{"rest_length"},
      triangles{"u", "v", "bar_length", "to_aft"}, bars{"rest_length", "parallel"};
  switch (layout) {
    case Layout::line:
      return line;
    case Layout::panel_in_triangles:
      return triangles;
    case Layout::panel_in_bars:
      return bars;
    default:
      return point;
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

Geometry read_point(TableReader& part) {
  Geometry out;
  const auto at =
      part.reals(leaf(kAt), {.unit = kAt.unit, .doc = kAt.doc, .range = kAt.range, .count = exactly(3)});
  if (at.size() != 3) return out;
  out.positions = at;
  out.elements = {0};
  out.data["share"] = {1}, out.data["length"] = {0};
  out.names.sets["point"] = {0};
  return out;
}

Geometry read_line(TableReader& part) {
  Geometry out;
  const double length = read_real(part, kLength);
  const auto n = static_cast<std::uint32_t>(read_integers(part, kBars)[0]);
  const auto sketch = read_points(part, kLine);
  if (sketch.size() < 2 || n < 1) return out;
  for (std::uint32_t i = 0; i <= n; ++i) append(out.positions, along_line(sketch, double(i) / n));
  for (std::uint32_t i = 0; i < n; ++i) out.elements.insert(out.elements.end(), {i, i + 1});
  out.data["rest_length"].assign(n, length / n);
  out.names.cells = {static_cast<int>(n)};
  out.names.sets["start"] = {0};
  out.names.sets["end"] = {n};
  if (n % 2 == 0) out.names.sets["middle"] = {n / 2};
  return out;
}

namespace {

std::optional<Surface> read_tube(TableReader& part) {
  TableReader tube = part.table("tube", Presence::required, "a tube along which the panel starts");
  const Point from = read_one_point(tube, kFrom), to = read_one_point(tube, kTo);
  const double radius = read_real(tube, kRadius), radius_aft = read_real(tube, kRadiusAft, radius);
  if (distance(from, to) == 0) {
    tube.error("to", "is where the tube begins; a tube must have a length");
    return {};
  }
  return round_an_axis(from, to, radius, radius_aft);
}

/// `sketch` or `tube`; nothing when there is something wrong with it.
std::optional<Surface> read_surface(TableReader& part) {
  if (part.has("tube") && part.has("sketch"))
    part.error("tube", "stands beside a sketch; a panel starts in one place", "leave one of them out");
  if (part.has("tube")) return read_tube(part);
  const auto sketch = read_points(part, kCorners);
  if (sketch.size() != 4) return {};
  return through_corners(sketch);
}

/// What the keys of a panel say, before it is divided.
struct Panel {
  double across, along, bar;  // [meshes], [m]
  Grid cells;
  Surface surface;
};

/// `elements` in a cell, of a kind.
std::optional<Panel> read_panel_keys(TableReader& part, const GeometryKey& key, std::int64_t elements,
                                     const char* kind) {
  TableReader panel = part.table("panel", Presence::required, "size of the panel in meshes");
  const double across = read_real(panel, kAcross), along = read_real(panel, kAlong),
               bar = read_real(panel, kBar);
  const auto cells = read_integers(part, key);
  const auto surface = read_surface(part);
  if (cells.size() != 2 || !surface) return {};
  if (cells[0] * cells[1] * elements > kMostElements) {
    part.error("cells", "makes " + std::to_string(cells[0] * cells[1] * elements) + " " + kind +
                            "; at most " + std::to_string(kMostElements) + " are taken in one part");
    return {};
  }
  return Panel{
      across, along, bar, {static_cast<std::size_t>(cells[0]), static_cast<std::size_t>(cells[1])}, *surface};
}

/// Meshes of a cell along, over those across; 1 if its bars run along the twines.
double slant(const Panel& p, double across, double along) { return p.along * across / (p.across * along); }

bool is_square(double slant) { return std::abs(slant - 1) < 1e-9; }

/// "[36, 36]": the square cells nearest to those of a panel; empty if there are none.
std::string nearest_square_cells(const Panel& p) {
  double best = std::numeric_limits<double>::infinity();
  std::string cells;
  for (std::int64_t i = 1; i <= kMostCells; ++i) {
    const double across = static_cast<double>(i), along = std::round(p.along / p.across * across);
    const double away = std::hypot(across - double(p.cells.across), along - double(p.cells.along));
    if (along < 1 || along > double(kMostCells) || away >= best || !is_square(slant(p, across, along)))
      continue;
    best = away;
    cells = "[" + std::to_string(i) + ", " + std::to_string(std::llround(along)) + "]";
  }
  return cells;
}

/// Whether the cells are as many meshes wide as long.
bool check_square_cells(const Panel& p, TableReader& part) {
  const double across = double(p.cells.across), along = double(p.cells.along);
  if (is_square(slant(p, across, along))) return true;
  std::ostringstream size;
  size << p.across / across << " x " << p.along / along;
  const std::string cells = nearest_square_cells(p);
  part.error(
      "cells",
      "makes cells of " + size.str() +
          " meshes; bars run along the twines only if a cell is as "
          "many meshes wide as long",
      cells.empty() ? "no cells fit this panel: change its meshes" : "nearest that fit: cells = " + cells);
  return false;
}

/// Centres behind the corners.
void place_centres(const Panel& p, Geometry& out) {
  for (std::size_t j = 0; j < p.cells.along; ++j)
    for (std::size_t i = 0; i < p.cells.across; ++i) {
      const double s = (double(i) + 0.5) / double(p.cells.across),
                   t = (double(j) + 0.5) / double(p.cells.along);
      append(out.positions, p.surface(s, t));
      out.names.panel.push_back({p.across * s, p.along * t});
    }
}

/// Nodes of a triangle, outer face counter-clockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// Cell (i, j) of a panel: corners from the fore left on, counter-clockwise seen from outside, and the node
/// in the middle, if there is one.
struct Cell {
  Cell(const Grid& g, std::size_t i, std::size_t j)
      : corners{g.node(i, j), g.node(i + 1, j), g.node(i + 1, j + 1), g.node(i, j + 1)},
        centre(static_cast<std::uint32_t>(g.columns() * (g.along + 1) + j * g.across + i)),
        is_even((i + j) % 2 == 0) {}

  std::array<Triangle, 2> halves() const {
    const auto [a, b, c, d] = corners;
    if (is_even) return {{{a, b, c}, {a, c, d}}};
    return {{{a, b, d}, {b, c, d}}};
  }
  std::array<Triangle, 4> quarters() const {
    const auto [a, b, c, d] = corners;
    return {{{a, b, centre}, {b, c, centre}, {c, d, centre}, {d, a, centre}}};
  }

  std::array<std::uint32_t, 4> corners;
  std::uint32_t centre;
  bool is_even;
};

template <class Visit>
void for_each_cell(const Grid& g, Visit&& visit) {
  for (std::size_t j = 0; j < g.along; ++j)
    for (std::size_t i = 0; i < g.across; ++i) visit(Cell(g, i, j));
}

/// A triangle of netting that hangs as `netting` says.
void add_triangle(const Panel& p, const Triangle& corners, const std::string& netting, Geometry& out) {
  for (const auto node : corners) {
    const auto [U, V] = out.names.panel[node];
    const auto [u, v] = twine_coordinates(netting, 0, U, V);
    out.elements.push_back(node);
    out.data["u"].push_back(u);
    out.data["v"].push_back(v);
    out.data["to_aft"].push_back(p.along - V);
  }
  out.data["bar_length"].push_back(p.bar);
}

void add_face(const Panel& p, const Triangle& corners, Geometry& out) {
  for (const auto node : corners) {
    out.faces.nodes.push_back(node);
    out.faces.data["to_aft"].push_back(p.along - out.names.panel[node][1]);
  }
}

void add_star(const Panel& p, const Cell& cell, Geometry& out) {
  const double meshes = p.across / double(p.cells.across);
  for (const Triangle& quarter : cell.quarters()) add_face(p, quarter, out);
  for (const auto corner : cell.corners) {
    out.elements.insert(out.elements.end(), {cell.centre, corner});
    out.data["rest_length"].push_back(meshes * p.bar);  // (1)
    out.data["parallel"].push_back(meshes);
  }
}

}  // namespace

Geometry read_panel(TableReader& part) {
  Geometry out;
  TableReader size = part.table("panel", Presence::optional);
  const std::string netting = read_word(size, kNetting);
  const bool crossed = read_word(part, kDivision) == "crossed";
  const auto panel = read_panel_keys(part, kCells, crossed ? 4 : 2, "triangles");
  if (!panel) return out;
  const Grid& g = panel->cells;
  place_nodes(g, panel->surface, panel->across, panel->along, out);
  if (crossed) place_centres(*panel, out);
  name_edges(g, out.names);
  const auto add = [&](const Triangle& t) { add_triangle(*panel, t, netting, out); };
  for_each_cell(g, [&](const Cell& cell) {
    if (crossed)
      std::ranges::for_each(cell.quarters(), add);
    else
      std::ranges::for_each(cell.halves(), add);
  });
  return out;
}

Geometry read_panel_in_bars(TableReader& part) {
  Geometry out;
  const auto panel = read_panel_keys(part, kSquareCells, 4, "bars");
  if (!panel || !check_square_cells(*panel, part)) return out;
  const Grid& g = panel->cells;
  place_nodes(g, panel->surface, panel->across, panel->along, out);
  place_centres(*panel, out);
  name_edges(g, out.names);
  for_each_cell(g, [&](const Cell& cell) { add_star(*panel, cell, out); });
  return out;
}

}  // namespace netloft::io
