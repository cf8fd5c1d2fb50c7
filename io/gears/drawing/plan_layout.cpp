// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/drawing/plan_layout.hpp"

#include "io/gears/plan/names.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace netloft::gears {

namespace {

constexpr double kHalfWidth = 0.5;  // width on the sheet as a fraction of the stretched width
constexpr double kGap = 0.25;       // gap between columns, relative to the width of the previous column
constexpr double kTouch = 1e-3;  // overlap of panels that only touch, relative to the depth of the later one

/// Length of a counted mesh along the gear [m]. Square netting is counted in bars, each half as long as a
/// stretched mesh.
double length_of_mesh(const Panel& panel) {
  return panel.orientation == "square" ? panel.mesh / 2 : panel.mesh;
}

PanelPoint middle_of(const EdgeSet& set) {
  const double left = std::min(set.edges.front().from.x, set.edges.back().to.x);
  const double right = std::max(set.edges.front().from.x, set.edges.back().to.x);
  return {set.is_across_middle() ? 0 : (left + right) / 2, set.edges.front().from.y};
}

/// The two edges of a seam that align two panels: the aft edge of one and a fore edge of the other.
struct Seam {
  EdgeSet aft, fore;
};

std::optional<Seam> seam_of(EdgeSet a, EdgeSet b) {
  if (a.edges.empty() || b.edges.empty() || a.panel == b.panel) return {};
  if (a.edges[0].kind != EdgeKind::aft) std::swap(a, b);
  if (a.edges[0].kind != EdgeKind::aft || b.edges[0].kind != EdgeKind::fore) return {};
  return Seam{std::move(a), std::move(b)};
}

/// The box around a panel on the sheet [m on the net]. It contains both halves of a middle panel, but only
/// the starboard panel of a pair.
struct PanelBox {
  double left = INFINITY, right = -INFINITY, fore = INFINITY, aft = -INFINITY;

  /// Whether two panels overlap in an area, not only touch.
  bool is_on(const PanelBox& other) const {
    const double across = std::min(right, other.right) - std::max(left, other.left);
    const double deep = std::min(aft, other.aft) - std::max(fore, other.fore);
    return across > kTouch * (right - left) && deep > kTouch * (aft - fore);
  }
};

PanelBox box_around(const PlacedPanel& panel) {
  PanelBox box;
  for (const auto& corner : panel.outline.corners()) {
    const PanelPoint at = panel.on_sheet(corner);
    box.left = std::min(box.left, at.x);
    box.right = std::max(box.right, at.x);
    box.fore = std::min(box.fore, at.y);
    box.aft = std::max(box.aft, at.y);
  }
  if (panel.panel->stands == Standing::middle) box.left = 2 * panel.x - box.right;
  return box;
}

/// Lays out one column after the other; the member functions are steps in the order of execution.
class Sheet {
 public:
  explicit Sheet(const NetPlan& plan) : plan_(plan) { find_seams(); }

  std::vector<PlacedPanel> lay_out() {
    for (const auto& panel : plan_.panels)
      if (panel.stands == Standing::middle && !is_behind_a_middle_one(panel)) begin_column(panel);
    for (const auto& panel : plan_.panels)
      if (!seen_.contains(&panel)) begin_column(panel);
    return std::move(placed_);
  }

 private:
  void find_seams() {
    formats::Diagnostics silent;
    for (const auto& join : plan_.joins)
      for (std::size_t row = 1; row < join.edges.size(); ++row) {
        const auto &first = join.edges[0], &other = join.edges[row];
        for (std::size_t i = 0; i < std::max(first.size(), other.size()); ++i) {
          if (first.empty() || other.empty()) break;
          const auto seam = seam_of(find_edge(plan_, first[std::min(i, first.size() - 1)], {}, "", silent),
                                    find_edge(plan_, other[std::min(i, other.size() - 1)], {}, "", silent));
          if (seam) seams_.push_back(*seam);
        }
      }
    for (const Seam& seam : seams_) {
      sewn_[seam.aft.panel].push_back({&seam.aft, &seam.fore});
      sewn_[seam.fore.panel].push_back({&seam.fore, &seam.aft});
    }
  }

  /// An edge of a panel, and the edge of another panel that is sewn to it.
  struct Neighbour {
    const EdgeSet *own, *other;
  };

  const std::vector<Neighbour>& neighbours_of(const Panel& panel) const {
    static const std::vector<Neighbour> none;
    const auto known = sewn_.find(&panel);
    return known == sewn_.end() ? none : known->second;
  }

  bool is_behind_a_middle_one(const Panel& panel) const {
    const auto& all = neighbours_of(panel);
    return std::any_of(all.begin(), all.end(), [](const Neighbour& n) {
      return n.own->edges[0].kind == EdgeKind::fore && n.other->panel->stands == Standing::middle;
    });
  }

  void begin_column(const Panel& panel) {
    const std::size_t first = placed_.size();
    taken_.clear();
    place(panel, 0, 0);
    double left = 0, right = 0;
    for (std::size_t i = first; i < placed_.size(); ++i)
      for (const auto& corner : placed_[i].outline.corners()) {
        const double x = placed_[i].on_sheet(corner).x;
        left = std::min(left, x);
        right = std::max(right, x);
      }
    for (std::size_t i = first; i < placed_.size(); ++i) placed_[i].x += next_ - left;
    next_ += (1 + kGap) * (right - left);
  }

  /// A panel to be placed if it has no place yet, its position, and, for a panel of a pair, the x of the
  /// origin of its mirror image.
  struct Next {
    const Panel* panel;
    double x, y, mirror_about;
  };

  /// Places a panel and all unplaced panels that are connected to it by seams of fore and aft edges. A list
  /// of waiting panels replaces recursion, because a plan may have very many panels in a row.
  void place(const Panel& first, double x, double y) {
    std::vector<Next> next{{&first, x, y, mirror_about_}};
    while (!next.empty()) {
      const Next now = next.back();
      next.pop_back();
      mirror_about_ = now.mirror_about;
      if (seen_.contains(now.panel) || !takes_its_place(now)) continue;
      seen_.insert(now.panel);
      const PlacedPanel own = place_one(now);
      const auto& all = neighbours_of(*now.panel);
      for (auto n = all.rbegin(); n != all.rend(); ++n)
        next.push_back(place_of(*n->other, middle_of(*n->own), own));
    }
  }

  /// Stores the place of a panel and returns true, unless the panel would overlap a panel that is already in
  /// the column. A panel that would overlap begins a new column: for example, the lower panel that is sewn to
  /// the same tube as the upper panel.
  bool takes_its_place(const Next& now) {
    const PanelBox own = box_around({now.panel, now.panel->outline, now.x, now.y, false});
    for (const PanelBox& other : taken_)
      if (own.is_on(other)) return false;
    taken_.push_back(own);
    return true;
  }

  PlacedPanel place_one(const Next& now) {
    const Panel& panel = *now.panel;
    const PlacedPanel own{&panel, panel.outline, now.x, now.y, false};
    placed_.push_back(own);
    if (panel.stands != Standing::alone)
      placed_.push_back({&panel, own.outline, now.mirror_about, now.y, true});
    if (panel.stands == Standing::middle) placed_.back().x = now.x;
    return own;
  }

  /// Returns the position of the panel of `edge` such that this edge meets the point `at` of a placed panel.
  static Next place_of(const EdgeSet& edge, PanelPoint at, const PlacedPanel& there) {
    const PanelPoint target = there.on_sheet(at), own = middle_of(edge);
    const double across = kHalfWidth * edge.panel->mesh, aft = length_of_mesh(*edge.panel);
    const double x = edge.panel->stands == Standing::middle ? there.x : target.x - across * own.x;
    return {edge.panel, x, target.y - aft * own.y, 2 * there.x - x};
  }

  const NetPlan& plan_;
  std::vector<Seam> seams_;
  std::map<const Panel*, std::vector<Neighbour>> sewn_;
  std::vector<PlacedPanel> placed_;
  std::set<const Panel*> seen_;
  std::vector<PanelBox> taken_;  // places of the panels in the column
  double next_ = 0, mirror_about_ = 0;
};

}  // namespace

PanelPoint PlacedPanel::on_sheet(PanelPoint p) const {
  const double across = kHalfWidth * panel->mesh * p.x;
  return {x + (is_mirrored ? -across : across), y + length_of_mesh(*panel) * p.y};
}

std::vector<PlacedPanel> lay_out(const NetPlan& plan) { return Sheet(plan).lay_out(); }

}  // namespace netloft::gears
