// SPDX-License-Identifier: BSD-3-Clause
//
// Divides a gear of FEMNET that has no mesh into elements. The nodes of a panel are the knots of a coarser
// net, whose mesh side is the meshing step. The nodes agree with those of FEMNET. Triangles may differ where
// both diagonals of a square of nodes are equally good.
//   u = U + V,  v = V − U                 a panel in mesh sides along its twines                      (1)
//   parts of a side = max(|Δu|, |Δv|) l₀/step, rounded, at least one                                  (2)
//   inner nodes at u, v = whole multiples of step/l₀                                                   (3)
// U, V are the panel coordinates in meshes, Δu and Δv the differences between the ends of a side, l₀ [m] the
// mesh side, step [m] the meshing step. A Delaunay triangulation connects the nodes in a plane whose
// coordinates are U l₀ and √3 V l₀. In this plane, meshes are half open, and the nodes (3) form a lattice of
// equilateral triangles.
#include "io/formats/mesh/mesh.hpp"
#include "io/gears/meshing/border_sides.hpp"
#include "io/gears/meshing/triangulation.hpp"
#include "io/scenes/import/gear_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace netloft::scenes::femnet {

namespace {

constexpr double kMostParts = 1e5;    // limit of parts along one side of a panel
constexpr double kLongestSide = 100;  // limit of the mesh side [m]
// Least distance of inner nodes from the border, as a fraction of the meshing step, so that no triangle is
// flat. FEMNET has some nodes at 0.24.
constexpr double kNearest = 0.2;
// A triangle is flat and has no netting if twice its area is less than this [meshes²].
constexpr double kFlat = 1e-9;

Triple between(const Triple& a, const Triple& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double along(const Triple& a, const Triple& b, const Triple& c, const Triple& d) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += (b[axis] - a[axis]) * (d[axis] - c[axis]);
  return sum;
}

/// A line between two points of the gear. It is divided only once, for all panels and cables that are sewn
/// together along it.
struct Line {
  std::vector<std::uint32_t> nodes;  // nodes in order from one end to the other
  Triple from{}, to{};               // positions of its ends in the drawing
};

/// The panel coordinates of a point, in meshes.
struct Meshes {
  double U = 0, V = 0;
};

/// The plane in which the netting of one panel is triangulated.
class PanelPlane {
 public:
  explicit PanelPlane(const Panel& p) : panel_(p), step_(p.step / p.side) {}

  gears::PlanePoint plane(const Meshes& m) const { return {m.U * panel_.side, kOpen * m.V * panel_.side}; }

  double sides_between(const Corner& a, const Corner& b) const {
    const double U = b.U - a.U, V = b.V - a.V;
    return std::max(std::abs(U + V), std::abs(V - U));  // (1)
  }
  double parts_between(const Corner& a, const Corner& b) const {
    return std::max(1.0, std::round(sides_between(a, b) / step_));  // (2)
  }
  bool is_too_fine(double most_nodes) const {
    const auto [low, high] = extent();
    const double u = (high.U - low.U) / step_ + 1, v = (high.V - low.V) / step_ + 1;
    return !(u * v < 2 * most_nodes && std::max(u, v) < kMostParts);
  }

  /// The inner nodes, equation (3) at the top of this file. `low` and `high` are limits of u and v, which are
  /// stored in members named U and V.
  std::vector<Meshes> inside(const std::vector<gears::PlanePoint>& border) const {
    const auto [low, high] = extent();
    const gears::BorderSides sides(border, kNearest * panel_.step);
    std::vector<Meshes> nodes;
    for (double i = std::ceil(low.U / step_); i * step_ <= high.U; ++i)
      for (double k = std::ceil(low.V / step_); k * step_ <= high.V; ++k) {
        const Meshes m{(i - k) * step_ / 2, (i + k) * step_ / 2};
        if (sides.holds(plane(m))) nodes.push_back(m);
      }
    return nodes;
  }

 private:
  static constexpr double kOpen = std::numbers::sqrt3;

  /// The least coordinates u, v of the corners (first), and the greatest ones (second). They are stored in
  /// members named U and V.
  std::pair<Meshes, Meshes> extent() const {
    Meshes low{1e300, 1e300}, high{-1e300, -1e300};
    for (const auto& c : panel_.corners) {
      low = {std::min(low.U, c.U + c.V), std::min(low.V, c.V - c.U)};
      high = {std::max(high.U, c.U + c.V), std::max(high.V, c.V - c.U)};
    }
    return {low, high};
  }

  const Panel& panel_;
  double step_;  // [mesh sides]
};

double twice_area(const Meshes& a, const Meshes& b, const Meshes& c) {
  return (b.U - a.U) * (c.V - a.V) - (b.V - a.V) * (c.U - a.U);
}

/// The initial shape of a panel in the drawing: its corners are connected to triangles, in which positions of
/// inner nodes are interpolated.
class DrawnPanel {
 public:
  /// `corners` must be counter-clockwise.
  DrawnPanel(std::vector<Corner> corners, const PanelPlane& plane) : corners_(std::move(corners)) {
    std::vector<gears::PlanePoint> border;
    for (const auto& c : corners_) border.push_back(plane.plane({c.U, c.V}));
    triangles_ = gears::connect_points(border, {}).triangles;
  }

  /// The position at a point of the panel, interpolated in the triangle that contains the point or is nearest
  /// to it.
  Triple at(const Meshes& m) const {
    double best = -1e300;
    Triple place{};
    for (const auto& t : triangles_) {
      const Corner &a = corners_[t[0]], &b = corners_[t[1]], &c = corners_[t[2]];
      const double whole = twice_area({a.U, a.V}, {b.U, b.V}, {c.U, c.V});
      if (whole < kFlat) continue;
      const double of_b = twice_area({a.U, a.V}, m, {c.U, c.V}) / whole,
                   of_c = twice_area({a.U, a.V}, {b.U, b.V}, m) / whole;
      const double inside = std::min({of_b, of_c, 1 - of_b - of_c});
      if (inside <= best) continue;
      best = inside;
      for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] = a.at[axis] + of_b * (b.at[axis] - a.at[axis]) + of_c * (c.at[axis] - a.at[axis]);
    }
    return place;
  }

 private:
  std::vector<Corner> corners_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

/// Divides one gear. The member functions are the steps, in the order of execution.
class Divider {
 public:
  Divider(const GearFile& gear, formats::Diagnostics& diagnostics, double most_nodes)
      : gear_(gear),
        most_nodes_(most_nodes),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.errors()),
        links_(gear, diagnostics) {}

  MeshFile divide() {
    for (const auto& object : order())
      if (is_fine()) object.is_panel ? add_panel(object.object) : add_cable(object.object);
    for (const auto& box : gear_.type_boxes) give_type(box);
    return std::move(mesh_);
  }

 private:
  bool is_fine() const { return diagnostics_.errors() == errors_before_; }
  void error(const formats::Place& place, const std::string& message, const std::string& hint = {}) {
    diagnostics_.error(place, message, hint);
  }

  /// All panels and cables in the order in which they are divided: first those in the meshing order of the
  /// file, then the others.
  std::vector<LinkPoint> order() const {
    std::vector<LinkPoint> all;
    std::vector<bool> has_panel(gear_.panels.size()), has_cable(gear_.cables.size());
    const auto add = [&](bool is_panel, int object) {
      auto& has = is_panel ? has_panel : has_cable;
      const auto i = static_cast<std::size_t>(object);
      if (object < 0 || i >= has.size() || has[i]) return;
      has[i] = true;
      all.push_back({is_panel, object, 0});
    };
    for (const auto& o : gear_.order) add(o.is_panel, o.object);
    for (std::size_t p = 0; p < gear_.panels.size(); ++p) add(true, static_cast<int>(p));
    for (std::size_t c = 0; c < gear_.cables.size(); ++c) add(false, static_cast<int>(c));
    return all;
  }

  std::uint32_t add_node(const Triple& at, int type, const formats::Place& place) {
    const auto types = static_cast<int>(gear_.types.size());
    if (type < 1 || type > types)
      error(place, fmt::format("nodes of type {} are needed here, but there is no such type", type),
            types ? fmt::format("they are numbered 1 to {}", types) : "there are none");
    if (static_cast<double>(mesh_.nodes.size()) >= most_nodes_)
      error(place, fmt::format("the gear would have more than {:g} nodes", most_nodes_),
            "the meshing step is too small");
    if (std::any_of(at.begin(), at.end(), [](double x) { return !(std::abs(x) < formats::kFarthest); }))
      error(place, "its drawing reaches beyond a million metres");
    mesh_.nodes.push_back({at, type - 1});
    return static_cast<std::uint32_t>(mesh_.nodes.size() - 1);
  }

  /// The node at a corner of a panel or at an end of a cable. It gets the type `type` of the panel or cable
  /// that is divided first.
  std::uint32_t node_of(const LinkPoint& point, const Triple& at, int type, const formats::Place& place) {
    const auto [known, is_new] = node_of_point_.try_emplace(links_.point(point), 0);
    if (is_new) known->second = add_node(at, type, place);
    const int own = mesh_.nodes[known->second].type + 1;
    if (own != type)
      diagnostics_.warning(
          place,
          fmt::format(
              "corner {} is of type {}, but linked to a corner of type {}, and the node gets that type",
              point.corner + 1, type, own),
          "the object that is divided first decides; give linked corners the same type");
    return known->second;
  }

  /// The nodes of the line from `a` to `b`, both ends included. The line is divided if it has not been
  /// divided for another panel or cable.
  std::vector<std::uint32_t> line(std::uint32_t a, std::uint32_t b, const Triple& from, const Triple& to,
                                  double parts, int type, const formats::Place& place) {
    const auto [known, is_new] = lines_.try_emplace(std::minmax({a, b}));
    Line& line = known->second;
    if (is_new) {
      line.from = from;
      line.to = to;
      line.nodes.push_back(a);
      for (double i = 1; i < parts && is_fine(); ++i)
        line.nodes.push_back(add_node(between(from, to, i / parts), type, place));
      line.nodes.push_back(b);
      return line.nodes;
    }
    auto nodes = line.nodes;
    const bool turns = a == b ? along(line.from, line.to, from, to) < 0 : line.nodes.front() != a;
    if (turns) std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  void add_cable(int number) {
    const Cable& c = gear_.cables[static_cast<std::size_t>(number)];
    const auto end = [&](int k) {
      const auto& e = c.ends[static_cast<std::size_t>(k)];
      return node_of({false, number, k}, e.at, e.type, c.place);
    };
    const std::uint32_t a = end(0), b = end(1);
    const auto nodes = line(a, b, c.ends[0].at, c.ends[1].at, std::max(c.bars, 1), c.inner_type, c.place);
    if (a == b && nodes.size() < 4)
      return error(c.place, "the cable ends where it begins: it needs three bars or more",
                   "the .don has the number of bars");
    const auto bars = static_cast<double>(nodes.size() - 1);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      mesh_.bars.push_back({{nodes[i], nodes[i + 1]},
                            {static_cast<double>(i) / bars, static_cast<double>(i + 1) / bars},
                            number + 1});
  }

  /// The border of a panel, counter-clockwise.
  struct Border {
    std::vector<std::uint32_t> nodes;
    std::vector<Meshes> meshes;
  };

  void add_panel(int number) {
    const Panel& p = gear_.panels[static_cast<std::size_t>(number)];
    if (!can_be_divided(p)) return;
    const PanelPlane plane(p);
    Border border = border_of(number, plane);
    if (!is_fine()) return;
    std::vector<gears::PlanePoint> points;
    for (const auto& m : border.meshes) points.push_back(plane.plane(m));
    const auto inner = plane.inside(points);
    std::vector<gears::PlanePoint> inner_points;
    for (const auto& m : inner) inner_points.push_back(plane.plane(m));
    try {
      const gears::PlaneMesh filled = gears::connect_points(points, inner_points);
      add_inner_nodes(p, plane, inner, border);
      add_triangles(number, filled, border);
    } catch (const std::invalid_argument& e) {
      error(p.place, std::string("the border of the panel encloses no netting: ") + e.what());
    }
  }

  bool can_be_divided(const Panel& p) {
    if (!(p.side > 0 && p.side < kLongestSide))
      error(p.place,
            fmt::format("the mesh side of the panel is {:g} m: it cannot be divided into elements", p.side));
    if (!(p.step > 0))
      error(
          p.place,
          fmt::format("the meshing step of the panel is {:g} m: it cannot be divided into elements", p.step),
          "give the mesh with --mesh, or a step above zero");
    if (std::any_of(p.corners.begin(), p.corners.end(), [](auto& c) {
          return !(std::abs(c.U) < formats::kFarthest && std::abs(c.V) < formats::kFarthest);
        }))
      error(p.place, "a corner of the panel is beyond a million meshes");
    if (is_fine() && PanelPlane(p).is_too_fine(most_nodes_))
      error(p.place, fmt::format("the panel would have more than {:g} nodes", most_nodes_),
            "the meshing step is too small");
    if (is_fine() && !(std::abs(area(p)) > kFlat))
      error(p.place, "the corners of the panel enclose no netting");
    return is_fine();
  }

  /// Twice the signed area of a panel [meshes²].
  static double area(const Panel& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.corners.size(); ++i) {
      const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.corners.size()];
      sum += a.U * b.V - b.U * a.V;
    }
    return sum;
  }

  Border border_of(int number, const PanelPlane& plane) {
    const Panel& p = gear_.panels[static_cast<std::size_t>(number)];
    const auto count = static_cast<int>(p.corners.size());
    const auto corner = [&](int k) { return p.corners[static_cast<std::size_t>(k % count)]; };
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < count; ++k)
      corners.push_back(node_of({true, number, k}, corner(k).at, corner(k).type, p.place));
    Border border;
    for (int k = 0; k < count && is_fine(); ++k) {
      const Corner a = corner(k), b = corner(k + 1);
      const auto i = static_cast<std::size_t>(k);
      const auto nodes = line(corners[i], corners[(i + 1) % corners.size()], a.at, b.at,
                              plane.parts_between(a, b), a.side_type, p.place);
      for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
        const double t = static_cast<double>(n) / static_cast<double>(nodes.size() - 1);
        border.nodes.push_back(nodes[n]);
        border.meshes.push_back({a.U + t * (b.U - a.U), a.V + t * (b.V - a.V)});
      }
    }
    if (area(p) < 0) {
      std::reverse(border.nodes.begin(), border.nodes.end());
      std::reverse(border.meshes.begin(), border.meshes.end());
    }
    return border;
  }

  /// Adds the inner nodes of a panel after the nodes of its border.
  void add_inner_nodes(const Panel& p, const PanelPlane& plane, const std::vector<Meshes>& inner,
                       Border& all) {
    auto corners = p.corners;
    if (area(p) < 0) std::reverse(corners.begin(), corners.end());
    const DrawnPanel drawn(corners, plane);
    for (const auto& m : inner) {
      all.nodes.push_back(add_node(drawn.at(m), p.inner_type, p.place));
      all.meshes.push_back(m);
    }
  }

  /// Adds the triangles of a panel. A triangle between two sides that are sewn together has only two distinct
  /// nodes and no extent in space; it is omitted, with a warning.
  void add_triangles(int number, const gears::PlaneMesh& filled, const Border& all) {
    double lost = 0;
    for (const auto& t : filled.triangles) {
      MeshFile::Triangle triangle;
      triangle.panel = number;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.nodes[k] = all.nodes[t[k]];
        triangle.UV[2 * k] = all.meshes[t[k]].U;
        triangle.UV[2 * k + 1] = all.meshes[t[k]].V;
      }
      const double d = twice_area(all.meshes[t[0]], all.meshes[t[1]], all.meshes[t[2]]);
      const auto& [a, b, c] = triangle.nodes;
      if (a == b || b == c || a == c)
        lost += d;
      else if (d > kFlat)
        mesh_.triangles.push_back(triangle);
    }
    const formats::Place& place = gear_.panels[static_cast<std::size_t>(number)].place;
    if (lost > 0)
      diagnostics_.warning(place,
                           fmt::format("netting of {:.3g} meshes lies between sides that are sewn to one "
                                       "another, and is left out",
                                       lost / 2),
                           "a smaller meshing step leaves out less");
  }

  void give_type(const TypeBox& box) {
    for (auto& n : mesh_.nodes) {
      bool is_inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_inside = is_inside && n.at[axis] > box.low[axis] && n.at[axis] < box.high[axis];
      if (is_inside) n.type = box.type;
    }
  }

  const GearFile& gear_;
  double most_nodes_;
  formats::Diagnostics& diagnostics_;
  int errors_before_;
  GearLinks links_;
  std::map<std::size_t, std::uint32_t> node_of_point_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Line> lines_;  // lines by the two nodes at their ends
  MeshFile mesh_;
};

}  // namespace

MeshFile divide_gear(const GearFile& gear, formats::Diagnostics& diagnostics, double most_nodes) {
  return Divider(gear, diagnostics, most_nodes).divide();
}

}  // namespace netloft::scenes::femnet
