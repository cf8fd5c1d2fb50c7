// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/twine_coordinates.hpp"
#include "io/scenes/reading/geometry_keys.hpp"

#include <netloft/vec3.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>

namespace netloft::scenes {

namespace {

// Limit of the elements of one part. So many elements have 3·10⁷ unknowns, three times as many as the largest
// solved scene; a matrix may have 10⁸ unknowns.
constexpr std::int64_t kMostElements = 20000000;

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

/// The initial surface of a panel, as a function of the fractions s across and t along the panel.
using SurfacePoint = std::function<Point(double s, double t)>;

/// The bilinear surface through the four corners.
SurfacePoint through_corners(std::vector<Point> corner) {
  return [corner = std::move(corner)](double s, double t) {
    return between_points(between_points(corner[0], corner[1], s), between_points(corner[3], corner[2], s),
                          t);
  };
}

Vec3<double> vector(const Point& p) { return {p[0], p[1], p[2]}; }

/// The surface of a tube: c(t) + r(t) (cos 2πs e₁ + sin 2πs e₂). c(t) is the axis from one point to another,
/// r(t) the radius. e₁ and e₂ are unit vectors across, with e₁ × e₂ along the tube and e₁ as far upwards as
/// possible.
SurfacePoint round_an_axis(const Point& from, const Point& to, double radius, double radius_aft) {
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

void place_nodes(const Grid& g, const SurfacePoint& surface, double meshes_across, double meshes_along,
                 Geometry& out) {
  for (std::size_t j = 0; j <= g.along; ++j)
    for (std::size_t i = 0; i <= g.across; ++i) {
      const double s = double(i) / double(g.across), t = double(j) / double(g.along);
      append(out.positions, surface(s, t));
      out.names.panel.push_back({meshes_across * s, meshes_along * t});
    }
}

std::optional<SurfacePoint> read_tube(formats::TableReader& part) {
  formats::TableReader tube =
      part.table("tube", formats::Presence::required, "a tube along which the panel starts");
  const Point from = read_one_point(tube, kFrom), to = read_one_point(tube, kTo);
  const double radius = read_real(tube, kRadius), radius_aft = read_real(tube, kRadiusAft, radius);
  if (distance(from, to) == 0) {
    tube.error("to", "is where the tube begins; a tube must have a length");
    return {};
  }
  return round_an_axis(from, to, radius, radius_aft);
}

/// Reads the initial surface from `sketch` or `tube`; returns nullopt after an error.
std::optional<SurfacePoint> read_surface(formats::TableReader& part) {
  if (part.has("tube") && part.has("sketch"))
    part.error("tube", "is given beside sketch, and each of them says where the panel starts",
               "leave one of them out");
  if (part.has("tube")) return read_tube(part);
  const auto sketch = read_points(part, kCorners);
  if (sketch.size() != 4) return {};
  return through_corners(sketch);
}

/// The values of the keys of a panel: its size, its cells and its initial surface.
struct Panel {
  double across, along, bar;  // [meshes], [m]
  Grid cells;
  SurfacePoint surface;
};

/// Reads the keys of a panel. `elements` is the number of elements in a cell; `kind` is what messages call
/// them. Returns nullopt after an error.
std::optional<Panel> read_panel_keys(formats::TableReader& part, const GeometryKey& key,
                                     std::int64_t elements, const char* kind) {
  formats::TableReader panel =
      part.table("panel", formats::Presence::required, "size of the panel in meshes");
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

/// The length of a cell divided by its width, both in meshes. If it is 1, bars from a corner to the centre
/// run along the twines.
double slant(const Panel& p, double across, double along) { return p.along * across / (p.across * along); }

bool is_square(double slant) { return std::abs(slant - 1) < 1e-9; }

/// The numbers of cells across and along, such as "[36, 36]", that make cells square in meshes and are
/// nearest to the given numbers; empty if there are none.
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

/// Whether the cells have the same number of meshes across and along; if not, reports an error.
bool check_square_cells(const Panel& p, formats::TableReader& part) {
  const double across = double(p.cells.across), along = double(p.cells.along);
  if (is_square(slant(p, across, along))) return true;
  std::ostringstream size;
  size << p.across / across << " x " << p.along / along;
  const std::string cells = nearest_square_cells(p);
  part.error("cells",
             "makes cells of " + size.str() +
                 " meshes; bars run along the twines only if a cell is as "
                 "many meshes wide as long",
             cells.empty() ? "no cells fit this panel: change its meshes"
                           : "use the nearest cells that fit: cells = " + cells);
  return false;
}

/// Appends the centres of the cells to the nodes, after the corners.
void place_centres(const Panel& p, Geometry& out) {
  for (std::size_t j = 0; j < p.cells.along; ++j)
    for (std::size_t i = 0; i < p.cells.across; ++i) {
      const double s = (double(i) + 0.5) / double(p.cells.across),
                   t = (double(j) + 0.5) / double(p.cells.along);
      append(out.positions, p.surface(s, t));
      out.names.panel.push_back({p.across * s, p.along * t});
    }
}

/// Nodes of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Cell (i, j) of a panel: its corners, counter-clockwise seen from outside from the fore left one on, and
/// the number of the node at its centre, which only crossed cells have.
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

/// Adds a triangle of netting; `netting` is its orientation, such as "diamond".
void add_triangle(const Panel& p, const Triangle& corners, const std::string& netting, Geometry& out) {
  for (const auto node : corners) {
    const auto [U, V] = out.names.panel[node];
    const auto [u, v] = gears::twine_coordinates(netting, 0, U, V);
    out.elements.push_back(node);
    out.data[datum::kU.name].push_back(u);
    out.data[datum::kV.name].push_back(v);
    out.data[datum::kToAft.name].push_back(p.along - V);
  }
  out.data[datum::kBarLength.name].push_back(p.bar);
  out.data[datum::kOutward.name].push_back(1);
}

void add_face(const Panel& p, const Triangle& corners, Geometry& out) {
  for (const auto node : corners) {
    out.faces.nodes.push_back(node);
    out.faces.data[datum::kToAft.name].push_back(p.along - out.names.panel[node][1]);
  }
}

void add_star(const Panel& p, const Cell& cell, Geometry& out) {
  const double meshes = p.across / double(p.cells.across);
  for (const Triangle& quarter : cell.quarters()) add_face(p, quarter, out);
  for (const auto corner : cell.corners) {
    out.elements.insert(out.elements.end(), {cell.centre, corner});
    out.data[datum::kRestLength.name].push_back(meshes * p.bar);  // (1)
    out.data[datum::kParallel.name].push_back(meshes);
  }
}

}  // namespace

Geometry read_panel(formats::TableReader& part) {
  Geometry out;
  formats::TableReader size = part.table("panel", formats::Presence::optional);
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

Geometry read_panel_in_bars(formats::TableReader& part) {
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

}  // namespace netloft::scenes
