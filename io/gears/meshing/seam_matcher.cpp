// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/seam_matcher.hpp"

#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace netloft::gears {

namespace {

/// A point on a row (one side of a seam), at a fraction of the total extent of the row.
struct Knot {
  double fraction = 0;
  std::size_t point = 0;
};

// Two sides are neighbours along a seam only if at least this fraction of the shorter side lies beside the
// other side.
constexpr double kBeside = 0.1;

/// The direction in which the rows of a seam run.
struct Way {
  bool to_starboard = false;  // whether sides of port halves are reversed
  bool sides_aft = true;      // whether sides of starboard halves run aft
};

/// Finds which points of sewn edges coincide; the member functions are steps in the order of execution.
class Sewer {
 public:
  Sewer(const Gear& gear, const Cloths& cloths, double snap)
      : gear_(gear), cloths_(cloths), snap_(snap), borders_{cloths, {}, {}, {}} {}

  Borders sew() {
    for (const auto& cloth : cloths_.cloths) add_corners(cloth);
    join_halves();
    add_seams();
    for (const auto& seam : borders_.seams) match(seam);
    match_layers();
    return std::move(borders_);
  }

 private:
  const ClothSide& side(const DirectedSide& s) const { return cloths_.sides[s.side]; }
  const Panel& panel_of(const DirectedSide& s) const {
    return *gear_.panels[cloths_.cloths[side(s).cloth].panel].panel;
  }

  void add_corners(const Cloth& cloth) {
    std::vector<std::size_t> corners;
    for (std::size_t k = 0; k < cloth.sides.size(); ++k) corners.push_back(borders_.points.add());
    for (std::size_t k = 0; k < cloth.sides.size(); ++k)
      borders_.breaks.push_back({{0, corners[k]}, {1, corners[(k + 1) % corners.size()]}});
  }

  /// Joins both halves of middle panels along the line between them.
  void join_halves() {
    std::map<std::size_t, std::size_t> first;  // the first half of each panel
    for (std::size_t s = 0; s < cloths_.sides.size(); ++s) {
      if (!cloths_.sides[s].is_inside) continue;
      const auto [half, is_first] = first.emplace(cloths_.sides[s].edge.panel, s);
      if (!is_first) borders_.seams.push_back({{Row{{half->second, true}}, Row{{s, true}}}, {}});
    }
    join_tips();
  }

  /// Joins both halves of a middle panel at the ends of its middle line, even if this line has no length.
  void join_tips() {
    for (std::size_t c = 0; c + 1 < cloths_.cloths.size(); ++c) {
      const auto &one = cloths_.cloths[c], &other = cloths_.cloths[c + 1];
      if (one.panel != other.panel) continue;
      for (const char* name : {"fore-inner", "aft-inner"})
        borders_.points.unite(borders_.breaks[one.corners.at(name)].front().point,
                              borders_.breaks[other.corners.at(name)].front().point);
    }
  }

  /// Adds all seams. Seams that can run in only one direction come first, because they determine the faces of
  /// the cloths for the other seams.
  void add_seams() {
    Faces faces(cloths_.cloths.size());
    for (const auto& halves : borders_.seams) state_faces(halves.rows, faces);
    std::vector<SewnRows> seams;
    for (const auto& seam : gear_.seams) seams.push_back({rows_of(seam, true), seam.join, seam.is_of_layer});
    for (const auto& seam : seams)
      if (!is_mixed(seam.rows)) state_faces(seam.rows, faces);
    for (std::size_t s = 0; s < seams.size(); ++s) {
      if (!is_mixed(seams[s].rows)) continue;
      if (!are_faces_possible(seams[s].rows, faces))
        if (auto other = rows_of(gear_.seams[s], false); are_faces_possible(other, faces))
          seams[s].rows = std::move(other);
      state_faces(seams[s].rows, faces);
    }
    for (auto& seam : seams)
      if (!seam.rows[0].empty() && !seam.rows[1].empty()) borders_.seams.push_back(std::move(seam));
  }

  /// Matches joins of more than two rows once more: their first row by now has the points of all rows, which
  /// the seams that were matched before are to have, too.
  void match_layers() {
    std::set<std::size_t> joins;
    for (const auto& seam : borders_.seams)
      if (seam.is_of_layer) joins.insert(*seam.join);
    for (const auto& seam : borders_.seams)
      if (seam.join && joins.contains(*seam.join)) match(seam);
  }

  std::array<Row, 2> rows_of(const Seam& seam, bool sides_aft) const {
    const Way way{!is_to_port(seam), sides_aft};
    std::array<Row, 2> rows{row_of(seam.edges[0], way), row_of(seam.edges[1], way)};
    if (seam.is_to_itself) fold(rows);
    return rows;
  }

  /// Whether a seam joins sides to fore or aft edges.
  bool is_mixed(const std::array<Row, 2>& rows) const {
    std::array<bool, 2> has{};
    for (const auto& row : rows)
      for (const auto& s : row) has[side(s).is_across()] = true;
    return has[0] && has[1];
  }

  /// Calls `visit` for every two cloths of a seam whose sides lie beside each other. Its last argument is
  /// whether the cloths show opposite faces outwards.
  template <class Visit>
  void visit_neighbours(const std::array<Row, 2>& rows, const Visit& visit) const {
    if (rows[0].empty() || rows[1].empty()) return;
    const bool counted = is_counted(rows);
    const auto a = fractions(rows[0], counted), b = fractions(rows[1], counted);
    for (std::size_t i = 0; i < rows[0].size(); ++i)
      for (std::size_t j = 0; j < rows[1].size(); ++j)
        if (std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]) >
            kBeside * std::min(a[i + 1] - a[i], b[j + 1] - b[j]))
          visit(side(rows[0][i]).cloth, side(rows[1][j]).cloth,
                rows[0][i].is_forward == rows[1][j].is_forward);
  }

  void state_faces(const std::array<Row, 2>& rows, Faces& faces) const {
    visit_neighbours(rows, [&](std::size_t a, std::size_t b, bool turned) { faces.state(a, b, turned); });
  }

  bool are_faces_possible(const std::array<Row, 2>& rows, const Faces& faces) const {
    bool all = true;
    Faces then = faces;
    visit_neighbours(
        rows, [&](std::size_t a, std::size_t b, bool turned) { all = then.state(a, b, turned) && all; });
    return all;
  }

  /// Divides edges that are sewn to their mirror image into a starboard row and a port row. Both rows then
  /// run in the same way.
  void fold(std::array<Row, 2>& rows) const {
    std::erase_if(rows[0], [&](const auto& s) { return is_port(s); });
    std::erase_if(rows[1], [&](const auto& s) { return !is_port(s); });
    std::reverse(rows[1].begin(), rows[1].end());
    for (auto& s : rows[1]) s.is_forward = !s.is_forward;
  }

  bool is_to_port(const Seam& seam) const {
    for (const auto& row : seam.edges)
      for (const auto& ref : row)
        for (const auto& s : sides_of(cloths_, ref))
          if (!cloths_.cloths[side(s).cloth].is_port) return false;
    return true;
  }

  Row row_of(const std::vector<EdgeRef>& edges, Way way) const {
    Row row;
    for (const auto& ref : edges)
      for (auto s : sides_of(cloths_, ref)) {
        s.is_forward = is_forward(s, way);
        row.push_back(s);
      }
    order_panel_by_panel(row, way);
    if (const auto last = gear_.last_of_ring(edges)) {
      turn_side_panels(row);
      close_ring(row, *last, way);
    }
    return row;
  }

  bool is_forward(const DirectedSide& s, Way way) const {
    const ClothSide& c = side(s);
    const bool runs = c.is_across() ? c.to.x > c.from.x : c.goes_aft == way.sides_aft;
    return runs != (way.to_starboard && is_port(s));
  }

  bool is_port(const DirectedSide& s) const { return cloths_.cloths[side(s).cloth].is_port; }

  std::size_t panel(const DirectedSide& s) const { return cloths_.cloths[side(s).cloth].panel; }

  /// Whether a seam joins a side of panel `from` to the outer side of panel `to`.
  bool begins_outside(std::size_t from, std::size_t to) const {
    const auto has = [&](const std::vector<EdgeRef>& row, std::size_t p, bool is_outer_only) {
      return std::any_of(row.begin(), row.end(), [&](const EdgeRef& ref) {
        const EdgeKind kind = gear_.panels[ref.panel].outline.edges[ref.edge].kind;
        return ref.panel == p && (kind == EdgeKind::outer || (kind == EdgeKind::inner && !is_outer_only));
      });
    };
    return std::any_of(gear_.seams.begin(), gear_.seams.end(), [&](const Seam& seam) {
      const auto& [a, b] = seam.edges;
      return (has(a, from, false) && has(b, to, true)) || (has(b, from, false) && has(a, to, true));
    });
  }

  /// In a row round the net, reverses the edges of every side panel whose outer side is sewn to the previous
  /// panel, so that these edges run inwards. Goes from the first panel across the middle in both directions.
  void turn_side_panels(Row& row) const {
    const auto first = std::find_if(row.begin(), row.end(),
                                    [&](const auto& s) { return panel_of(s).stands == Standing::middle; });
    const auto behind = [&](const auto& s) { return panel(s) != panel(*first); };
    const auto second = std::find_if(first, row.end(), behind);
    const auto turn = [&](auto begin, auto end, std::size_t from) {
      while (begin != end) {
        const std::size_t at = panel(*begin);
        const auto next = std::find_if(begin, end, [&](const auto& s) { return panel(s) != at; });
        if (panel_of(*begin).stands != Standing::middle && begins_outside(from, at)) {
          std::reverse(begin, next);
          std::for_each(begin, next, [](auto& s) { s.is_forward = !s.is_forward; });
        }
        from = at;
        begin = next;
      }
    };
    turn(second, row.end(), panel(*first));
    turn(std::make_reverse_iterator(first), row.rend(), panel(*first));
  }

  /// Reverses the last panel of a row round the net (Gear::last_of_ring), and moves its port half to the
  /// beginning of the row.
  void close_ring(Row& row, std::size_t last_panel, Way way) const {
    const auto last = std::stable_partition(row.begin(), row.end(), [&](const auto& s) {
      return cloths_.cloths[side(s).cloth].panel != last_panel;
    });
    std::stable_sort(last, row.end(),
                     [&](const auto& a, const auto& b) { return position(a, way) > position(b, way); });
    for (auto s = last; s != row.end(); ++s) s->is_forward = !s->is_forward;
    const auto starboard = std::stable_partition(last, row.end(), [&](const auto& s) { return is_port(s); });
    std::rotate(row.begin(), last, starboard);
  }

  /// Sorts consecutive edges of one panel in a row by their position on the panel.
  void order_panel_by_panel(Row& row, Way way) const {
    const auto panel = [&](const DirectedSide& s) { return cloths_.cloths[side(s).cloth].panel; };
    for (auto first = row.begin(); first != row.end();) {
      const auto last =
          std::find_if(first, row.end(), [&](const auto& s) { return panel(s) != panel(*first); });
      std::stable_sort(first, last,
                       [&](const auto& a, const auto& b) { return position(a, way) < position(b, way); });
      first = last;
    }
  }

  /// The sorting key of a side in a row: first the side of the gear, if the row runs to starboard (port comes
  /// first), then the position.
  std::pair<bool, double> position(const DirectedSide& s, Way way) const {
    const ClothSide& c = side(s);
    const double along = c.is_across() ? c.from.x + c.to.x : (way.sides_aft ? 1 : -1) * (c.from.y + c.to.y);
    const bool is_turned = way.to_starboard && is_port(s);
    return {!is_turned, is_turned ? -along : along};
  }

  /// Adds points to both rows of a seam, so that both rows have a point at every corner of either row.
  void match(const SewnRows& seam) {
    const auto& rows = seam.rows;
    const bool counted = is_counted(rows);
    for (const auto& row : rows) chain(row);
    const std::array<std::vector<double>, 2> ends{fractions(rows[0], counted), fractions(rows[1], counted)};
    std::array<std::vector<Knot>, 2> knots{knots_of(rows[0], ends[0]), knots_of(rows[1], ends[1])};
    unite_near(knots, snap_ / std::max(length_of(rows[0]), length_of(rows[1])));
    const auto common = common_knots(knots);
    for (std::size_t r = 0; r < 2; ++r) {
      std::set<std::size_t> own;
      for (const auto& knot : knots[r]) own.insert(borders_.points.root(knot.point));
      for (const auto& knot : knots[1 - r])
        if (!own.contains(borders_.points.root(knot.point)))
          insert(seam, r, ends[r], {moved(knot.fraction, common, 1 - r), knot.point});
    }
  }

  bool is_counted(const std::array<Row, 2>& rows) const {
    const double mesh = panel_of(rows[0][0]).mesh;
    bool is_across = true, is_along = true, is_one_mesh_size = true;
    for (const auto& row : rows)
      for (const auto& s : row) {
        (side(s).is_across() ? is_along : is_across) = false;
        is_one_mesh_size = is_one_mesh_size && panel_of(s).mesh == mesh;
        if (side(s).meshes <= 0) return false;
      }
    return is_across || (is_along && is_one_mesh_size);
  }

  void chain(const Row& row) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k)
      borders_.points.unite(borders_.end(row[k]), borders_.start(row[k + 1]));
  }

  double length_of(const Row& row) const {
    double sum = 0;
    for (const auto& s : row) sum += side(s).length;
    return sum;
  }

  /// The fractions of a row at which its sides begin and end.
  std::vector<double> fractions(const Row& row, bool counted) const {
    std::vector<double> ends{0};
    for (const auto& s : row) {
      const ClothSide& c = side(s);
      ends.push_back(ends.back() + (c.is_inside ? c.length : counted ? c.meshes : c.stretched));
    }
    for (auto& end : ends) end /= ends.back();
    return ends;
  }

  std::vector<Knot> knots_of(const Row& row, const std::vector<double>& ends) {
    std::vector<Knot> knots{{0, borders_.start(row[0])}};
    for (std::size_t k = 0; k < row.size(); ++k) {
      auto breaks = borders_.breaks[row[k].side];
      if (!row[k].is_forward) std::reverse(breaks.begin(), breaks.end());
      for (std::size_t b = 1; b < breaks.size(); ++b) {
        const double fraction = row[k].is_forward ? breaks[b].fraction : 1 - breaks[b].fraction;
        knots.push_back({ends[k] + fraction * (ends[k + 1] - ends[k]), breaks[b].point});
      }
    }
    return knots;
  }

  /// Merges the ends of both rows, and each pair of nearest corners on opposite rows that are close enough.
  void unite_near(std::array<std::vector<Knot>, 2>& knots, double near) {
    borders_.points.unite(knots[0].front().point, knots[1].front().point);
    borders_.points.unite(knots[0].back().point, knots[1].back().point);
    std::size_t next = 1;
    for (std::size_t i = 1; i + 1 < knots[0].size(); ++i)
      for (std::size_t j = next; j + 1 < knots[1].size(); ++j) {
        const double apart = std::abs(knots[1][j].fraction - knots[0][i].fraction);
        const bool is_nearest = std::abs(knots[1][j + 1].fraction - knots[0][i].fraction) >= apart &&
                                std::abs(knots[0][i + 1].fraction - knots[1][j].fraction) >= apart;
        if (apart > near || !is_nearest) continue;
        borders_.points.unite(knots[0][i].point, knots[1][j].point);
        next = j + 1;
        break;
      }
  }

  /// The fractions of both rows at the points that they have in common.
  std::vector<std::array<double, 2>> common_knots(const std::array<std::vector<Knot>, 2>& knots) {
    std::map<std::size_t, std::vector<double>> others;
    for (const auto& knot : knots[1]) others[borders_.points.root(knot.point)].push_back(knot.fraction);
    std::vector<std::array<double, 2>> common;
    for (const auto& knot : knots[0])
      if (const auto at = others.find(borders_.points.root(knot.point)); at != others.end())
        for (const double other : at->second) common.push_back({knot.fraction, other});
    return common;
  }

  /// Converts a fraction of row `from` to a fraction of the other row, linearly between common points.
  static double moved(double fraction, const std::vector<std::array<double, 2>>& common, std::size_t from) {
    double a = 0, b = 1, at_a = 0, at_b = 1;
    for (const auto& knot : common) {
      const double here = knot[from], there = knot[1 - from];
      if (here < fraction && here > a) {
        a = here;
        at_a = there;
      }
      if (here > fraction && here < b) {
        b = here;
        at_b = there;
      }
    }
    return at_a + (fraction - a) / (b - a) * (at_b - at_a);
  }

  void insert(const SewnRows& seam, std::size_t r, const std::vector<double>& ends, const Knot& knot) {
    if (!(knot.fraction > 0 && knot.fraction < 1)) refuse_seam(gear_, cloths_, seam);
    const Row& row = seam.rows[r];
    std::size_t k = 0;
    while (k + 1 < row.size() && ends[k + 1] < knot.fraction) ++k;
    double fraction = (knot.fraction - ends[k]) / (ends[k + 1] - ends[k]);
    if (!row[k].is_forward) fraction = 1 - fraction;
    auto& breaks = borders_.breaks[row[k].side];
    const auto after =
        std::find_if(breaks.begin(), breaks.end(), [&](const Break& b) { return b.fraction > fraction; });
    breaks.insert(after == breaks.end() ? after - 1 : after, {fraction, knot.point});
  }

  const Gear& gear_;
  const Cloths& cloths_;
  double snap_;
  Borders borders_;
};

}  // namespace

Borders sew(const Gear& gear, const Cloths& cloths, double snap) { return Sewer(gear, cloths, snap).sew(); }

std::string name_of(const Gear& gear, const Cloths& cloths, const Row& row) {
  return gear.name_of(cloths.sides[row.front().side].edge);
}

void refuse_seam(const Gear& gear, const Cloths& cloths, const SewnRows& seam) {
  if (!seam.join)
    throw CannotDivide::panel(gear.panels[cloths.sides[seam.rows[0].front().side].edge.panel].panel->name,
                              "points of its middle would be joined to each other",
                              "lead seams and ropes to other points of the panel");
  throw CannotDivide::seam(
      *seam.join,
      "the seam of " + name_of(gear, cloths, seam.rows[0]) + " and " + name_of(gear, cloths, seam.rows[1]) +
          " would join points of one edge to each other",
      "sew other edges to each other: other seams, or ropes, already join ends of these edges");
}

Row sides_of(const Cloths& cloths, const EdgeRef& edge) {
  Row row;
  for (const std::size_t s : cloths.of_panel.at(edge.panel))
    if (const auto& side = cloths.sides[s]; !side.is_inside && side.edge == edge)
      row.push_back({s, !side.is_reversed});
  const auto begins = [&](const DirectedSide& s) {
    return std::min(cloths.sides[s.side].edge_from, cloths.sides[s.side].edge_to);
  };
  std::sort(row.begin(), row.end(), [&](const auto& a, const auto& b) { return begins(a) < begins(b); });
  return row;
}

}  // namespace netloft::gears
