// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/outline.hpp"

#include "io/gears/plan/twine_coordinates.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

double gain_of(const std::vector<Cut>& side) {
  double gain = 0;
  for (const auto& cut : side) gain += cut.goes * cut.across;
  return gain;
}

double depth_of(const std::vector<Cut>& side) {
  double depth = 0;
  for (const auto& cut : side) depth += cut.deep;
  return depth;
}

bool is_middle(const Panel& panel) { return panel.stands == Standing::middle; }

/// The counts of the drawn half of a middle panel, with half of the first count.
std::vector<MeshCount> drawn_counts(const Panel& panel, const std::vector<MeshCount>& edge) {
  auto counts = edge;
  if (is_middle(panel) && !counts.empty()) counts.front().meshes /= 2;
  return counts;
}

double total(const std::vector<MeshCount>& counts) {
  double meshes = 0;
  for (const auto& count : counts) meshes += count.meshes;
  return meshes;
}

/// Collects edges one after another, as a pen that moves along the border.
class Pen {
 public:
  explicit Pen(PanelPoint start) : at_(start) {}

  /// Draws an edge to a point. A point within rounding of the middle is put on the middle; an edge without
  /// extent is left out.
  void draw(OutlineEdge edge, PanelPoint to) {
    if (std::abs(to.x) < 1e-9) to.x = 0;
    edge.from = at_;
    edge.to = to;
    at_ = to;
    if (std::hypot(edge.to.x - edge.from.x, edge.to.y - edge.from.y) > 1e-9)
      edges_.push_back(std::move(edge));
  }
  PanelPoint at() const { return at_; }
  std::vector<OutlineEdge>& edges() { return edges_; }

 private:
  PanelPoint at_;
  std::vector<OutlineEdge> edges_;
};

double stretched_length(const Panel& panel, double across, double deep) {
  return stretched_meshes(panel.twines_at(across, deep));
}

void draw_counts(Pen& pen, const Panel& panel, const std::vector<MeshCount>& counts, EdgeKind kind,
                 double direction) {
  for (const auto& count : counts)
    pen.draw({count.name, kind, {}, {}, count.meshes, stretched_length(panel, count.meshes, 0)},
             {pen.at().x + direction * count.meshes, pen.at().y});
}

/// Meshes that seams gather at the corner before cut k of a side. If k is the number of cuts, this is the
/// last corner.
double selvedge_at(const std::vector<Cut>& side, std::size_t k) {
  return std::max(k > 0 ? side[k - 1].selvedge : 0.0, k < side.size() ? side[k].selvedge : 0.0);
}

/// Takes up to `wanted` meshes from a count; returns the meshes taken.
double take(double wanted, MeshCount* count) {
  const double taken = count ? std::min(wanted, count->meshes) : 0;
  if (count) count->meshes -= taken;
  return taken;
}

MeshCount* first(std::vector<MeshCount>& counts) { return counts.empty() ? nullptr : &counts.front(); }
MeshCount* last(std::vector<MeshCount>& counts) { return counts.empty() ? nullptr : &counts.back(); }

/// Moves the corners of a side inwards by the meshes that seams gather. The first corner moves at most by the
/// meshes of the fore edge, the last one by those of the aft edge.
void gather(std::vector<PanelPoint>& corners, const std::vector<Cut>& side, double inwards, MeshCount* fore,
            MeshCount* aft) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double wanted = selvedge_at(side, k);
    corners[k].x += inwards * (k == 0                    ? take(wanted, fore)
                               : k + 1 == corners.size() ? take(wanted, aft)
                                                         : wanted);
  }
}

/// The corners of a side that starts at x0. From corner to corner, x changes by `sign` times the meshes of
/// the cut; `shift` is added in proportion to the depth. Depths are scaled to the depth of the panel.
std::vector<PanelPoint> side_corners(const std::vector<Cut>& side, double x0, double sign, double depth,
                                     double shift) {
  const double scale = depth_of(side) > 0 ? depth / depth_of(side) : 1;
  std::vector<PanelPoint> corners = {{x0, 0}};
  double x = x0, y = 0;
  for (const auto& cut : side) {
    x += sign * cut.goes * cut.across;
    y += scale * cut.deep;
    corners.push_back({x + shift * y / depth, y});
  }
  return corners;
}

/// Draws a side. The length of an edge is the stated length of its cut, not the length of the line between
/// the corners.
void draw_side(Pen& pen, const Panel& panel, const std::vector<PanelPoint>& corners, EdgeKind kind) {
  const bool forward = kind == EdgeKind::inner;
  const auto& side = forward ? panel.inner : panel.outer;
  for (std::size_t k = 0; k < side.size(); ++k) {
    const std::size_t i = forward ? side.size() - 1 - k : k;
    const double outwards = (forward ? -1 : 1) * side[i].goes * side[i].across;
    pen.draw({side[i].name, kind, {}, {}, side[i].deep, stretched_length(panel, outwards, side[i].deep)},
             corners[forward ? i : i + 1]);
  }
}

}  // namespace

void settle(std::vector<Cut>& side, double depth) {
  double said = 0;
  Cut* open = nullptr;
  for (auto& cut : side) {
    const bool goes_deep = cut.is_known && cut.rate.half_meshes_deep() > 0;
    const bool goes_across = cut.is_known && cut.rate.half_meshes_across() > 0;
    cut.across = cut.said_across              ? *cut.said_across
                 : cut.said_deep && goes_deep ? cut.rate.across(*cut.said_deep)
                                              : 0;
    cut.deep = cut.said_deep                                 ? *cut.said_deep
               : cut.said_across && goes_deep && goes_across ? cut.rate.deep(*cut.said_across)
                                                             : 0;
    said += cut.deep;
    if (!cut.said_across && !cut.said_deep) open = &cut;
  }
  if (!open) return;
  open->deep = std::max(0.0, depth - said);
  if (open->is_known && open->rate.half_meshes_deep() > 0) open->across = open->rate.across(open->deep);
}

double aft_by_cuttings(const Panel& panel) {
  const double sides = is_middle(panel) ? 2 : 1;
  return panel.count(panel.fore) + sides * gain_of(panel.outer) + gain_of(panel.inner);
}

std::vector<PanelPoint> Outline::corners() const {
  std::vector<PanelPoint> points;
  for (const auto& edge : edges) points.push_back(edge.from);
  return points;
}

Outline outline_of(const Panel& panel) {
  auto fore = drawn_counts(panel, panel.fore), aft = drawn_counts(panel, panel.aft);
  const double shift = (panel.count(panel.aft) - aft_by_cuttings(panel)) / 2;
  auto outer = side_corners(panel.outer, total(fore), 1, panel.depth, shift);
  auto inner = side_corners(panel.inner, 0, -1, panel.depth, is_middle(panel) ? 0 : -shift);
  gather(outer, panel.outer, -1, last(fore), last(aft));
  gather(inner, panel.inner, 1, first(fore), first(aft));
  Pen pen(inner.front());
  draw_counts(pen, panel, fore, EdgeKind::fore, 1);
  draw_side(pen, panel, outer, EdgeKind::outer);
  auto inwards = aft;
  std::reverse(inwards.begin(), inwards.end());
  draw_counts(pen, panel, inwards, EdgeKind::aft, -1);
  if (is_middle(panel))
    pen.draw({"middle", EdgeKind::middle, {}, {}, panel.depth, stretched_length(panel, 0, panel.depth)},
             {0, 0});
  else
    draw_side(pen, panel, inner, EdgeKind::inner);
  return {std::move(pen.edges())};
}

double Panel::count(const std::vector<MeshCount>& edge) const {
  if (edge.empty()) return 0;
  return stands == Standing::middle ? 2 * total(edge) - edge.front().meshes : total(edge);
}

std::array<double, 2> Panel::twines_at(double across, double deep) const {
  return twine_coordinates(orientation, angle, across, deep);
}

}  // namespace netloft::gears
