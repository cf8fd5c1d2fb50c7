// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/rope_course.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netloft::gears {

namespace {

constexpr double kRounding = 0.02;  // no free part if the excess is a smaller fraction of the rope
constexpr double kLikely = 0.1;     // score of an edge in its usual direction; two ends that meet score 1

bool crosses(const Gear& gear, const GearRope& rope) {
  return gear.extent == Extent::whole && rope.rope->stands == Standing::middle;
}

/// A hung edge as sides in the direction of its outline, and the length of rope that the edge takes.
struct HungRow {
  Row row;
  double length = 0;
};

/// Finds the courses of the ropes of one gear; the member functions are steps in the order of execution.
class Rigger {
 public:
  Rigger(const Gear& gear, Borders& borders) : gear_(gear), borders_(borders) {}

  RopeCourses run() {
    name_corners();
    for (const auto& point : gear_.points) all_.points.emplace(point.name, borders_.points.add());
    for (const auto& rope : gear_.ropes) name_ends(rope);
    for (const auto& rope : gear_.ropes) tie(rope);
    all_.courses.resize(gear_.ropes.size());
    for (const bool in_middle : {true, false})
      for (std::size_t r = 0; r < gear_.ropes.size(); ++r)
        if ((gear_.ropes[r].rope->stands == Standing::middle) == in_middle) run(r);
    return std::move(all_);
  }

 private:
  std::size_t& point(const std::string& name) { return all_.points.at(name); }

  void name_corners() {
    for (const auto& cloth : borders_.cloths.cloths)
      for (const auto& [name, side] : cloth.corners)
        all_.points.emplace(corner_name(cloth, name), borders_.breaks[side].front().point);
  }

  /// The name of a corner. Corners of middle panels of a whole gear begin with port or starboard, except
  /// those on the plane of symmetry.
  std::string corner_name(const Cloth& cloth, const std::string& name) const {
    const GearPanel& panel = gear_.panels[cloth.panel];
    const bool is_half = gear_.extent == Extent::whole && panel.panel->stands == Standing::middle;
    const bool is_aside = is_half && name != "fore-inner" && name != "aft-inner";
    return panel.name + "." + (is_aside ? (cloth.is_port ? "port-" : "starboard-") : "") + name;
  }

  void name_ends(const GearRope& rope) {
    for (const char* end : {".start", ".end"}) all_.points.emplace(rope.name + end, borders_.points.add());
    if (crosses(gear_, rope)) all_.points.emplace(rope.name + ".middle", borders_.points.add());
  }

  void tie(const GearRope& rope) {
    tie(rope.name + ".start", rope.between[0]);
    tie(rope.name + ".end", rope.between[1]);
    if (crosses(gear_, rope)) tie(rope.name + ".middle", rope.middle);
  }

  void tie(const std::string& end, const std::string& to) {
    if (const auto at = all_.points.find(to); at != all_.points.end())
      borders_.points.unite(point(end), at->second);
  }

  bool is_start(const std::string& name, std::size_t p) { return borders_.points.are_one(point(name), p); }

  void run(std::size_t r) {
    const GearRope& rope = gear_.ropes[r];
    auto rows = hung_rows(rope);
    direct(rope, rows);
    RopeCourse course;
    for (const auto& hung : rows) append(course, hung);
    spread_out(rope, course);
    put_middle(rope, course);
    all_.courses[r] = std::move(course);
  }

  std::vector<HungRow> hung_rows(const GearRope& rope) const {
    std::vector<HungRow> rows;
    for (const auto& hung : rope.hung)
      if (auto row = sides_of(borders_.cloths, hung.edge); !row.empty())
        rows.push_back({std::move(row), hung.length});
    return rows;
  }

  static Row reversed(Row row) {
    std::reverse(row.begin(), row.end());
    for (auto& s : row) s.is_forward = !s.is_forward;
    return row;
  }

  std::size_t start(const Row& row) const { return borders_.start(row.front()); }
  std::size_t end(const Row& row) const { return borders_.end(row.back()); }

  /// Chooses the direction of each edge so that as many ends of edges as possible meet, by dynamic
  /// programming over both directions of each edge.
  void direct(const GearRope& rope, std::vector<HungRow>& rows) {
    if (rows.empty()) return;
    std::vector<std::array<double, 2>> best(rows.size());
    std::vector<std::array<std::size_t, 2>> before(rows.size());
    const auto way = [&](std::size_t k, std::size_t d) { return d ? reversed(rows[k].row) : rows[k].row; };
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (const std::size_t d : {0u, 1u}) {
        const Row row = way(k, d);
        double score = kLikely * likelihood(rope, row);
        if (k == 0) score += is_start(rope.name + ".start", start(row));
        if (k + 1 == rows.size()) score += is_start(rope.name + ".end", end(row));
        if (k > 0) {
          std::array<double, 2> met{};
          for (const std::size_t e : {0u, 1u})
            met[e] = best[k - 1][e] + borders_.points.are_one(end(way(k - 1, e)), start(row));
          before[k][d] = met[1] > met[0];
          score += std::max(met[0], met[1]);
        }
        best[k][d] = score;
      }
    std::size_t d = best.back()[1] > best.back()[0];
    for (std::size_t k = rows.size(); k-- > 0;) {
      const std::size_t earlier = before[k][d];
      rows[k].row = way(k, d);
      d = earlier;
    }
  }

  /// Returns 1 if an edge runs in its usual direction along a rope, otherwise 0. Along a rope across the
  /// middle, edges usually run forward on the starboard side and aft on the port side; along other ropes,
  /// they run outwards or aft.
  double likelihood(const GearRope& rope, const Row& row) const {
    const ClothSide& side = borders_.cloths.sides[row[0].side];
    const bool is_port = borders_.cloths.cloths[side.cloth].is_port;
    const bool in_middle = rope.rope->stands == Standing::middle;
    const bool forward = row[0].is_forward;
    if (side.is_across()) return ((side.to.x > side.from.x) == forward) == !(in_middle && is_port);
    const bool aft = side.goes_aft == forward;
    return aft == (!in_middle || is_port);
  }

  void append(RopeCourse& course, const HungRow& hung) const {
    double whole = 0;
    for (const auto& s : hung.row) whole += fraction(s);
    for (const auto& s : hung.row)
      course.push_back({s, false, borders_.start(s), borders_.end(s), hung.length * fraction(s) / whole});
  }

  double fraction(const DirectedSide& s) const {
    return std::abs(borders_.cloths.sides[s.side].edge_to - borders_.cloths.sides[s.side].edge_from);
  }

  static double length_of(const RopeCourse& course) {
    return std::accumulate(course.begin(), course.end(), 0.0,
                           [](double sum, const RopeStretch& s) { return sum + s.length; });
  }

  /// A place before, between or after the hung edges of a rope, where a part of the rope may be free.
  struct Gap {
    std::size_t before = 0;  // index of the stretch that follows the gap
    std::size_t from = 0, to = 0;
    double weight = 1;
  };

  void spread_out(const GearRope& rope, RopeCourse& course) {
    const double left = rope.length - length_of(course);
    const auto gaps = left > kRounding * rope.length ? gaps_of(rope, course) : std::vector<Gap>{};
    double weights = 0;
    for (const auto& gap : gaps) weights += gap.weight;
    for (auto gap = gaps.rbegin(); gap != gaps.rend(); ++gap)
      course.insert(course.begin() + static_cast<std::ptrdiff_t>(gap->before),
                    {{}, true, gap->from, gap->to, left * gap->weight / weights});
    close(rope, course);
    const double scale = rope.length / length_of(course);
    for (auto& stretch : course) stretch.length *= scale;
  }

  std::vector<Gap> gaps_of(const GearRope& rope, const RopeCourse& course) {
    const std::size_t start = point(rope.name + ".start"), end = point(rope.name + ".end");
    if (course.empty()) return {{0, start, end, 1}};
    std::vector<Gap> gaps;
    for (std::size_t k = 1; k < course.size(); ++k)
      if (!borders_.points.are_one(course[k - 1].to, course[k].from))
        gaps.push_back({k, course[k - 1].to, course[k].from, 1});
    const Gap first{0, start, course.front().from, 1}, last{course.size(), course.back().to, end, 1};
    if (begins_off_the_middle(rope, course)) gaps.push_back(first);
    if (gaps.empty()) gaps = gaps_at_ends(rope, first, last);
    std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.before < b.before; });
    return gaps;
  }

  /// Whether, in half a gear, the first edge of a rope across the middle begins beside the plane of symmetry.
  bool begins_off_the_middle(const GearRope& rope, const RopeCourse& course) {
    if (gear_.extent != Extent::half || rope.rope->stands != Standing::middle) return false;
    for (std::size_t s = 0; s < borders_.cloths.sides.size(); ++s)
      if (borders_.cloths.sides[s].is_on_plane)
        for (const auto& b : borders_.breaks[s])
          if (borders_.points.are_one(b.point, course.front().from)) return false;
    return true;
  }

  std::vector<Gap> gaps_at_ends(const GearRope& rope, const Gap& first, const Gap& last) {
    const bool is_tied_first = borders_.points.are_one(first.from, first.to),
               is_tied_last = borders_.points.are_one(last.from, last.to);
    if (is_tied_first && is_tied_last) return {};
    if (is_tied_first) return {last};
    if (is_tied_last) return {first};
    if (crosses(gear_, rope)) return {first, last};
    if (gear_.extent == Extent::half && rope.rope->stands == Standing::middle) return {last};
    const bool leads_to = !rope.between[0].empty(), leads_from = !rope.between[1].empty();
    if (leads_to && leads_from) return {first, last};
    return leads_to ? std::vector<Gap>{first} : std::vector<Gap>{last};
  }

  /// Connects consecutive stretches, and the first and the last stretch with the ends of the rope.
  void close(const GearRope& rope, RopeCourse& course) {
    const std::size_t start = point(rope.name + ".start"), end = point(rope.name + ".end");
    if (course.empty()) course.push_back({{}, true, start, end, rope.length});
    borders_.points.unite(course.front().from, start);
    borders_.points.unite(course.back().to, end);
    for (std::size_t k = 1; k < course.size(); ++k) borders_.points.unite(course[k - 1].to, course[k].from);
  }

  /// Puts the middle of a rope of a whole gear at half its length if the rope is free there, otherwise at an
  /// end of an edge.
  void put_middle(const GearRope& rope, RopeCourse& course) {
    if (!crosses(gear_, rope)) return;
    const std::size_t middle = point(rope.name + ".middle");
    double at = 0;
    for (std::size_t k = 0; k < course.size(); ++k) {
      const double before = rope.length / 2 - at, after = at + course[k].length - rope.length / 2;
      at += course[k].length;
      if (after < -1e-6 * rope.length) continue;
      if (before < 1e-6 * rope.length || after < 1e-6 * rope.length || !course[k].is_free) {
        borders_.points.unite(middle, before < after ? course[k].from : course[k].to);
      } else {
        const RopeStretch whole = course[k];
        course[k].to = middle;
        course[k].length = before;
        course.insert(course.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                      {{}, true, middle, whole.to, after});
      }
      return;
    }
  }

  const Gear& gear_;
  Borders& borders_;
  RopeCourses all_;
};

}  // namespace

RopeCourses run_ropes(const Gear& gear, Borders& borders) { return Rigger(gear, borders).run(); }

}  // namespace netloft::gears
