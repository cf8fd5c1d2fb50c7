// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/gear.hpp"

#include "io/gears/plan/names.hpp"

#include <algorithm>
#include <map>

namespace netloft::gears {

namespace {

enum class Side { none, starboard, port };

const char* prefix(Side side) {
  return side == Side::starboard ? "starboard-" : side == Side::port ? "port-" : "";
}

/// Whether `full` is `name` with the prefix of this side.
bool is_on(Side side, std::string_view name, std::string_view full) {
  return full.ends_with(name) && full.substr(0, full.size() - name.size()) == prefix(side);
}

OutlineEdge mirrored(OutlineEdge edge) {
  std::swap(edge.from, edge.to);
  edge.from.x = -edge.from.x;
  edge.to.x = -edge.to.x;
  return edge;
}

/// Whether an edge continues in its mirror image. Fore and aft edges do if they begin or end in the middle.
bool crosses_middle(const OutlineEdge& edge) {
  const bool lies_across = edge.kind == EdgeKind::fore || edge.kind == EdgeKind::aft;
  return lies_across && (edge.from.x == 0 || edge.to.x == 0);
}

/// The outline of both halves of a middle panel: along the fore edge from port to starboard, aft, and back.
Outline both_halves(const Outline& half) {
  std::vector<OutlineEdge> starboard, port;
  for (const auto& edge : half.edges) {
    if (edge.kind == EdgeKind::middle) continue;
    OutlineEdge right = edge, left = mirrored(edge);
    if (crosses_middle(edge)) {
      right.from.x = edge.kind == EdgeKind::fore ? -edge.to.x : edge.from.x;
      right.to.x = edge.kind == EdgeKind::fore ? edge.to.x : -edge.from.x;
      right.meshes *= 2;
      right.stretched *= 2;
      starboard.push_back(right);
      continue;
    }
    right.name = prefix(Side::starboard) + right.name;
    left.name = prefix(Side::port) + left.name;
    starboard.push_back(right);
    port.push_back(left);
  }
  starboard.insert(starboard.end(), port.rbegin(), port.rend());
  return {std::move(starboard)};
}

/// Makes a gear from a plan; the member functions are steps in the order of execution.
class GearMaker {
 public:
  GearMaker(const NetPlan& plan, Extent extent) : plan_(plan), hangings_(hangings_by_rope(plan)) {
    gear_.extent = extent;
  }

  Gear make() {
    for (const auto& panel : plan_.panels) add_panel(panel);
    for (std::size_t j = 0; j < plan_.joins.size(); ++j) add_seams(j);
    add_rigging();
    for (const auto& body : plan_.bodies)
      for (const Side side : sides_of(body.stands))
        gear_.bodies.push_back({prefix(side) + body.name, &body, side == Side::port});
    for (const auto& pieces : plan_.pieces) add_pieces(pieces);
    return std::move(gear_);
  }

  /// Makes only the ropes, without the edges hung on them, and the points.
  Gear make_rigging() {
    add_rigging();
    return std::move(gear_);
  }

 private:
  void add_rigging() {
    for (const auto& rope : plan_.ropes) add_rope(rope);
    for (const auto& point : plan_.points) add_point(point);
  }

  bool is_whole() const { return gear_.extent == Extent::whole; }

  std::vector<Side> sides_of(Standing stands) const {
    if (stands == Standing::pair && is_whole()) return {Side::starboard, Side::port};
    return {Side::none};
  }

  void add_panel(const Panel& panel) {
    const Outline& outline = panel.outline;
    const bool doubled = is_whole() && panel.stands == Standing::middle;
    for (const Side side : sides_of(panel.stands)) {
      pieces_[&panel].push_back(gear_.panels.size());
      gear_.panels.push_back(
          {prefix(side) + panel.name, &panel, side == Side::port, doubled ? both_halves(outline) : outline});
    }
  }

  /// The edges on one side of the gear that a name in the plan means. An edge that exists once belongs to
  /// both sides.
  std::vector<EdgeRef> edges_of(const std::string& name, Side side) const {
    formats::Diagnostics silent;
    const EdgeSet set = find_edge(plan_, name, {}, "", silent);
    std::vector<EdgeRef> refs;
    const auto pieces = pieces_.find(set.panel);
    if (pieces == pieces_.end()) return refs;
    for (const auto& edge : set.edges)
      for (const std::size_t p : pieces->second) append_edges(refs, p, edge, side);
    return refs;
  }

  void append_edges(std::vector<EdgeRef>& refs, std::size_t p, const OutlineEdge& sought, Side side) const {
    const GearPanel& panel = gear_.panels[p];
    if (side != Side::none && is_on(other(side), panel.panel->name, panel.name)) return;
    for (std::size_t e = 0; e < panel.outline.edges.size(); ++e) {
      const OutlineEdge& edge = panel.outline.edges[e];
      if (edge.kind == sought.kind && (edge.name == sought.name || is_on(side, sought.name, edge.name)))
        refs.push_back({p, e});
    }
  }

  static Side other(Side side) {
    return side == Side::port ? Side::starboard : side == Side::starboard ? Side::port : Side::none;
  }

  bool is_there_twice(const std::string& name) const {
    formats::Diagnostics silent;
    return is_whole() && find_edge(plan_, name, {}, "", silent).times() == 2;
  }

  /// The edges to port that do not also belong to starboard.
  std::vector<EdgeRef> edges_to_port(const std::string& name) const {
    auto port = edges_of(name, Side::port);
    const auto starboard = edges_of(name, Side::starboard);
    std::erase_if(port, [&](const EdgeRef& ref) {
      return std::find(starboard.begin(), starboard.end(), ref) != starboard.end();
    });
    return port;
  }

  std::vector<EdgeRef> row_of(const std::vector<std::string>& names, Side side) const {
    std::vector<EdgeRef> row;
    for (const auto& name : names) {
      const auto edges = edges_of(name, side);
      row.insert(row.end(), edges.begin(), edges.end());
    }
    return row;
  }

  /// The edges of a row from port to starboard: edges that exist twice are at both ends of the row, edges
  /// that exist once are in the middle.
  std::vector<EdgeRef> row_across(const std::vector<std::string>& names) const {
    std::vector<EdgeRef> row;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
      const auto port = edges_to_port(*name);
      row.insert(row.end(), port.rbegin(), port.rend());
    }
    for (const auto& name : names) append(row, edges_of(name, Side::starboard));
    return row;
  }

  static void append(std::vector<EdgeRef>& row, const std::vector<EdgeRef>& more) {
    row.insert(row.end(), more.begin(), more.end());
  }

  void add_seams(std::size_t j) {
    const Join& join = plan_.joins[j];
    if (join.is_to_itself() && !is_whole()) return put_on_plane(join);
    for (std::size_t row = 1; row < join.edges.size(); ++row)
      for (auto& rows : rows_of(join, row))
        gear_.seams.push_back({std::move(rows), join.is_to_itself(), row > 1, j});
  }

  using Rows = std::array<std::vector<EdgeRef>, 2>;
  /// The first row of a join with another one: twice if both are there to starboard and to port.
  std::vector<Rows> rows_of(const Join& join, std::size_t row) const {
    const auto &one = join.edges[0], &other = join.edges[row];
    const auto twice = [&](const std::vector<std::string>& names) {
      return std::all_of(names.begin(), names.end(), [&](const auto& n) { return is_there_twice(n); });
    };
    if (join.is_to_itself()) return {{row_of(one, Side::starboard), row_of(other, Side::port)}};
    if (!is_whole()) return {{row_of(one, Side::none), row_of(other, Side::none)}};
    if (!twice(one) || !twice(other)) return {{row_across(one), row_across(other)}};
    return {{row_of(one, Side::starboard), row_of(other, Side::starboard)},
            {row_of(one, Side::port), row_of(other, Side::port)}};
  }

  void put_on_plane(const Join& join) {
    for (const auto& ref : row_of(join.edges[0], Side::none))
      gear_.panels[ref.panel].outline.edges[ref.edge].is_on_plane = true;
  }

  void add_rope(const Rope& rope) {
    const bool is_halved = !is_whole() && rope.stands == Standing::middle;
    for (const Side side : sides_of(rope.stands)) {
      GearRope one{prefix(side) + rope.name,
                   &rope,
                   side == Side::port,
                   is_halved            ? rope.length / 2
                   : side == Side::port ? rope.length_port.value_or(rope.length)
                                        : rope.length,
                   {},
                   {},
                   ""};
      if (!gear_.panels.empty()) one.hung = hung_on(rope, side);
      tie(one, side);
      gear_.ropes.push_back(std::move(one));
    }
  }

  /// Sets the points to which a rope is tied. For a rope across the middle, the plan names the point of its
  /// middle and that of its end; in a whole gear, the point of the end exists on both sides.
  void tie(GearRope& one, Side side) const {
    const auto& [start, end] = one.rope->between;
    if (is_whole() && one.rope->stands == Standing::middle) {
      one.between = {point_on(end, Side::port), point_on(end, Side::starboard)};
      one.middle = point_on(start, Side::none);
    } else {
      one.between = {point_on(start, side), point_on(end, side)};
    }
  }

  std::vector<HungEdge> hung_on(const Rope& rope, Side side) const {
    const bool across = is_whole() && rope.stands == Standing::middle;
    std::vector<HungEdge> port, starboard;
    for (auto [at, last] = hangings_.equal_range(rope.name); at != last; ++at) {
      const Hanging& hanging = *at->second;
      append_hung(starboard, hanging, edges_of(hanging.edge, across ? Side::starboard : side));
      if (across) append_hung(port, hanging, edges_to_port(hanging.edge));
    }
    port = {port.rbegin(), port.rend()};
    port.insert(port.end(), starboard.begin(), starboard.end());
    return port;
  }

  /// Distributes the length of a hanging among its edges, in proportion to the length of their twines.
  void append_hung(std::vector<HungEdge>& hung, const Hanging& hanging,
                   const std::vector<EdgeRef>& edges) const {
    formats::Diagnostics silent;
    const EdgeSet set = find_edge(plan_, hanging.edge, {}, "", silent);
    const double ratio = hanging.length > 0 ? hanging.length / set.stretched() : hanging.ratio;
    for (const auto& ref : edges) hung.push_back({ref, ratio * edge(ref).stretched * set.panel->mesh});
  }

  const OutlineEdge& edge(const EdgeRef& ref) const {
    return gear_.panels[ref.panel].outline.edges[ref.edge];
  }

  void add_point(const Point& point) {
    for (const Side side : sides_of(point.stands)) {
      const bool is_mirrored = side == Side::port;
      gear_.points.push_back({prefix(side) + point.name, &point, is_mirrored, position(point, is_mirrored)});
    }
  }

  /// Adds pieces such as floats. The plan states numbers for the whole gear. A pair of ropes or edges gets
  /// half of the number on each side. Half a gear has half of the pieces that lie across the plane of
  /// symmetry.
  void add_pieces(const Pieces& pieces) {
    const Standing stands = standing_of(pieces);
    const bool is_shared = stands == Standing::pair || (stands == Standing::middle && !is_whole());
    for (const Side side : sides_of(stands)) {
      GearPieces one{prefix(side) + pieces.name, &pieces, pieces.number / (is_shared ? 2 : 1), "", {}, ""};
      if (pieces.is_along_edge())
        one.edges =
            side == Side::none && is_whole() ? row_across({pieces.along}) : row_of({pieces.along}, side);
      else if (!pieces.along.empty())
        one.rope = (standing_of(pieces.along) == Standing::pair ? prefix(side) : "") + pieces.along;
      else
        one.point = point_on(pieces.at, side);
      gear_.pieces.push_back(std::move(one));
    }
  }

  Standing standing_of(const Pieces& pieces) const {
    if (pieces.is_along_edge()) return standing_of_edge(pieces.along);
    return pieces.along.empty() ? standing_of_point(plan_, pieces.at) : standing_of(pieces.along);
  }

  Standing standing_of_edge(const std::string& name) const {
    formats::Diagnostics silent;
    const EdgeSet set = find_edge(plan_, name, {}, "", silent);
    return set.times() == 2 ? Standing::pair : set.panel->stands;
  }

  struct DottedName {
    std::string owner, rest;
  };
  static DottedName split(const std::string& name) {
    const auto dot = name.find('.');
    return {name.substr(0, dot), dot == std::string::npos ? "" : name.substr(dot + 1)};
  }

  /// The name that a point of the plan has in the gear, on one side. In the plan, a rope across the middle
  /// has an "end" on both sides; in a whole gear, these are its start (to port) and its end (to starboard).
  std::string point_on(const std::string& name, Side side) const {
    const auto [owner, rest] = split(name);
    const Standing stands = standing_of(owner);
    if (is_on_both_sides(plan_, name))
      return owner + "." + prefix(side == Side::port ? Side::port : Side::starboard) + rest;
    if (!is_whole()) return stands == Standing::middle && rest == "middle" ? owner + ".start" : name;
    if (name.empty() || stands == Standing::alone) return name;
    if (stands == Standing::pair) return prefix(side) + name;
    if (plan_.find_panel(owner)) return is_corner_in_middle(rest) ? name : owner + "." + prefix(side) + rest;
    if (plan_.find_rope(owner))
      return owner + (rest != "end" ? ".middle" : side == Side::port ? ".start" : ".end");
    return name;
  }

  Standing standing_of(const std::string& owner) const { return netloft::gears::standing_of(plan_, owner); }

  const NetPlan& plan_;
  const HangingsByRope hangings_;
  std::map<const Panel*, std::vector<std::size_t>> pieces_;  // the panels of the gear made from each panel of
                                                             // the plan
  Gear gear_;
};

}  // namespace

Gear make_gear(const NetPlan& plan, Extent extent) { return GearMaker(plan, extent).make(); }

std::optional<std::array<double, 3>> position(const Point& point, bool is_mirrored) {
  auto at = point.at;
  if (at && is_mirrored) (*at)[1] = -(*at)[1];
  return at;
}

Gear make_rigging(const NetPlan& plan) { return GearMaker(plan, Extent::whole).make_rigging(); }

const GearPanel* Gear::find_panel(const std::string& name) const {
  const auto at = panel_names_.find(name, panels, [](const GearPanel& panel) { return panel.name; });
  return at ? &panels[*at] : nullptr;
}

const GearRope* Gear::find_rope(const std::string& name) const {
  const auto at = rope_names_.find(name, ropes, [](const GearRope& rope) { return rope.name; });
  return at ? &ropes[*at] : nullptr;
}

std::optional<std::size_t> Gear::last_of_ring(const std::vector<EdgeRef>& row) const {
  std::optional<std::size_t> first, last;
  for (const auto& ref : row) {
    const OutlineEdge& edge = panels[ref.panel].outline.edges[ref.edge];
    const bool lies_across = edge.kind == EdgeKind::fore || edge.kind == EdgeKind::aft;
    if (panels[ref.panel].panel->stands != Standing::middle || !lies_across || edge.from.x * edge.to.x > 0)
      continue;
    if (!first) first = ref.panel;
    if (ref.panel != first) last = ref.panel;
  }
  return last;
}

std::string Gear::name_of(const EdgeRef& ref) const {
  return panels[ref.panel].name + "." + panels[ref.panel].outline.edges[ref.edge].name;
}

}  // namespace netloft::gears
