// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/cloths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::gears {

namespace {

constexpr double kDrawnHalfAngle = std::numbers::pi / 6;  // angle between bars and the aft direction

PanelPoint between(PanelPoint a, PanelPoint b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// Divides panels into cloths, which have no symmetry; the member functions are steps in the order of
/// execution.
class Cutter {
 public:
  explicit Cutter(const Gear& gear) : gear_(gear) {}

  Cloths cut() {
    for (std::size_t p = 0; p < gear_.panels.size(); ++p) {
      const bool is_doubled =
          gear_.extent == Extent::whole && gear_.panels[p].panel->stands == Standing::middle;
      if (is_doubled) {
        add_half(p, 1);
        add_half(p, -1);
      } else
        add_panel(p);
    }
    return std::move(all_);
  }

 private:
  Cloth& begin(std::size_t panel, bool is_port, double sign) {
    all_.cloths.push_back({panel, is_port, sign, {}, {}});
    return all_.cloths.back();
  }

  void add_panel(std::size_t p) {
    begin(p, gear_.panels[p].is_mirrored, 1);
    const auto& edges = gear_.panels[p].outline.edges;
    for (std::size_t e = 0; e < edges.size(); ++e) add_side(side_of(p, e, 0, 1));
    name_corners();
  }

  /// Adds the half of a middle panel on the side of `sign` (1: starboard, -1: port), including the middle
  /// line between the halves.
  void add_half(std::size_t p, double sign) {
    begin(p, sign < 0, sign);
    std::vector<ClothSide> ring;
    const auto& edges = gear_.panels[p].outline.edges;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const double a = sign * edges[e].from.x, b = sign * edges[e].to.x;
      if (a <= 0 && b <= 0) continue;
      const double zero = a < 0 ? a / (a - b) : b < 0 ? a / (a - b) : 0;
      ring.push_back(side_of(p, e, a < 0 ? zero : 0, b < 0 ? zero : 1));
    }
    if (sign < 0) reverse(ring);
    begin_at_middle(ring);
    for (auto& side : ring) add_side(side);
    add_middle();
    name_corners();
  }

  ClothSide side_of(std::size_t p, std::size_t e, double from, double to) const {
    const GearPanel& panel = gear_.panels[p];
    const OutlineEdge& edge = panel.outline.edges[e];
    ClothSide side;
    side.edge = {p, e};
    side.kind = edge.kind;
    side.edge_from = from;
    side.edge_to = to;
    side.from = between(edge.from, edge.to, from);
    side.to = between(edge.from, edge.to, to);
    side.meshes = (to - from) * edge.meshes;
    side.stretched = (to - from) * edge.stretched * panel.panel->mesh;
    side.goes_aft = edge.kind == EdgeKind::outer;
    side.is_on_plane = gear_.extent == Extent::half && (edge.kind == EdgeKind::middle || edge.is_on_plane);
    return side;
  }

  /// Reverses the order of the sides of a port half, so that x points outwards.
  static void reverse(std::vector<ClothSide>& ring) {
    std::reverse(ring.begin(), ring.end());
    for (auto& side : ring) {
      std::swap(side.from, side.to);
      std::swap(side.edge_from, side.edge_to);
      side.from.x = -side.from.x;
      side.to.x = -side.to.x;
      side.is_reversed = true;
    }
  }

  /// Rotates the order of sides so that the first side starts in the middle and the last one ends there.
  static void begin_at_middle(std::vector<ClothSide>& ring) {
    const auto first = std::min_element(ring.begin(), ring.end(), [](const ClothSide& a, const ClothSide& b) {
      return a.from.x != b.from.x ? a.from.x < b.from.x : a.from.y < b.from.y;
    });
    std::rotate(ring.begin(), first, ring.end());
  }

  void add_middle() {
    const Cloth& cloth = all_.cloths.back();
    const PanelPoint from = all_.sides[cloth.sides.back()].to, to = all_.sides[cloth.sides.front()].from;
    if (std::hypot(from.x - to.x, from.y - to.y) < 1e-9) return;
    ClothSide side;
    side.is_inside = true;
    side.kind = EdgeKind::middle;
    side.edge.panel = cloth.panel;
    side.from = from;
    side.to = to;
    side.meshes = from.y - to.y;
    add_side(side);
  }

  void add_side(ClothSide side) {
    Cloth& cloth = all_.cloths.back();
    side.cloth = all_.cloths.size() - 1;
    const Panel& panel = *gear_.panels[cloth.panel].panel;
    const PanelPoint a = spread(panel, side.from), b = spread(panel, side.to);
    side.length = std::hypot(b.x - a.x, b.y - a.y);
    cloth.sides.push_back(all_.sides.size());
    all_.of_panel[cloth.panel].push_back(all_.sides.size());
    all_.sides.push_back(side);
  }

  /// Names the corners of a cloth. If a side has no extent, both its corners are the point where its
  /// neighbours meet.
  void name_corners() {
    Cloth& cloth = all_.cloths.back();
    const std::size_t n = cloth.sides.size();
    std::size_t fore = 0;
    while (fore < n && at(cloth, fore).kind == EdgeKind::fore) ++fore;
    std::size_t outer = fore;
    while (outer < n && at(cloth, outer).goes_aft) ++outer;
    std::size_t aft = outer;
    while (aft < n && at(cloth, aft).kind == EdgeKind::aft) ++aft;
    cloth.corners = {{"fore-inner", cloth.sides[0]},
                     {"fore-outer", cloth.sides[fore % n]},
                     {"aft-outer", cloth.sides[outer % n]},
                     {"aft-inner", cloth.sides[aft % n]}};
    for (std::size_t k = fore; k + 1 < outer; ++k)
      cloth.corners.emplace(own_name(cloth, k) + "-aft", cloth.sides[k + 1]);
    for (std::size_t k = aft; k + 1 < n; ++k)
      if (!at(cloth, k).is_inside) cloth.corners.emplace(own_name(cloth, k + 1) + "-aft", cloth.sides[k + 1]);
  }

  const ClothSide& at(const Cloth& cloth, std::size_t k) const { return all_.sides[cloth.sides[k]]; }

  /// The name of an edge in the plan, without the prefix for port or starboard.
  std::string own_name(const Cloth& cloth, std::size_t k) const {
    const std::string& name = gear_.panels[cloth.panel].outline.edges[at(cloth, k).edge.edge].name;
    const bool is_half = cloth.sign < 0 || (gear_.extent == Extent::whole &&
                                            gear_.panels[cloth.panel].panel->stands == Standing::middle);
    const std::string prefix = cloth.is_port ? "port-" : "starboard-";
    return is_half && name.starts_with(prefix) ? name.substr(prefix.size()) : name;
  }

  const Gear& gear_;
  Cloths all_;
};

}  // namespace

PanelPoint spread(const Panel& panel, PanelPoint point) {
  const double m = panel.mesh;
  if (panel.orientation == "square") return {m / 2 * point.x, m / 2 * point.y};
  if (panel.angle != 0) return {m / std::numbers::sqrt2 * point.x, m / std::numbers::sqrt2 * point.y};
  return {m * std::sin(kDrawnHalfAngle) * point.x, m * std::cos(kDrawnHalfAngle) * point.y};
}

Cloths cloths_of(const Gear& gear) { return Cutter(gear).cut(); }

}  // namespace netloft::gears
