// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/gear.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace netloft::gears {

namespace {

/// A graph of points and ends of ropes, with ropes as connections, for shortest paths.
class RopeWays {
 public:
  explicit RopeWays(const Gear& gear) {
    for (const auto& rope : gear.ropes) {
      add(rope.name + ".start", rope.name + ".middle", rope.length / 2);
      add(rope.name + ".middle", rope.name + ".end", rope.length / 2);
      add(rope.name + ".start", rope.between[0], 0);
      add(rope.name + ".end", rope.between[1], 0);
      add(rope.name + ".middle", rope.middle, 0);
    }
  }

  /// Lengths of the shortest paths along ropes from one point to all points that are at most `most` [m] away
  /// (E. W. Dijkstra 1959).
  std::map<std::string, double> from(const std::string& start,
                                     double most = std::numeric_limits<double>::infinity()) const {
    std::map<std::string, double> reached;
    std::set<std::pair<double, std::string>> next = {{0, start}};
    while (!next.empty()) {
      const auto [length, at] = *next.begin();
      next.erase(next.begin());
      if (length > most) break;
      if (!reached.emplace(at, length).second) continue;
      for (auto [way, end] = ways_.equal_range(at); way != end; ++way)
        next.emplace(length + way->second.length, way->second.to);
    }
    return reached;
  }

 private:
  struct Way {
    std::string to;
    double length;
  };
  void add(const std::string& a, const std::string& b, double length) {
    if (b.empty()) return;
    ways_.emplace(a, Way{b, length});
    ways_.emplace(b, Way{a, length});
  }
  std::multimap<std::string, Way> ways_;
};

double distance(const GearPoint& a, const GearPoint& b) {
  return std::hypot((*b.at)[0] - (*a.at)[0], (*b.at)[1] - (*a.at)[1], (*b.at)[2] - (*a.at)[2]);
}

void say_too_short(const GearPoint& a, const GearPoint& b, double length, formats::Diagnostics& diagnostics) {
  diagnostics.error(b.point->place,
                    fmt::format("{} and {} are {} m apart, but the ropes between them are only {} m long",
                                a.name, b.name, in_metres(distance(a, b)), in_metres(length)),
                    "give `at` in metres, x aft, y to starboard, z up, or lengthen the ropes");
}

}  // namespace

namespace {

/// Refuses a rope that begins and ends at the same point and has no edge hung on it: it would be a loose
/// loop.
void check_loops(const Gear& gear, const RopeWays& ways, formats::Diagnostics& diagnostics) {
  for (const auto& rope : gear.ropes) {
    if (!rope.hung.empty() || rope.is_mirrored) continue;
    const bool is_across = !rope.middle.empty();
    const double length = is_across ? rope.length / 2 : rope.length;
    const auto reached = ways.from(rope.name + ".end", length * 1e-6);
    if (!reached.contains(rope.name + (is_across ? ".middle" : ".start"))) continue;
    diagnostics.error(rope.rope->between_place,
                      fmt::format("ropes.{}.between: both ends of the rope are one point", rope.rope->name),
                      "a rope leads from one point to another");
  }
}

}  // namespace

void check_spans(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const Gear gear = make_gear(plan, Extent::whole);
  const RopeWays ways(gear);
  check_loops(gear, ways, diagnostics);
  std::set<std::pair<const Point*, const Point*>> said;  // port and starboard would give the same message
  for (std::size_t i = 0; i < gear.points.size(); ++i) {
    const GearPoint& a = gear.points[i];
    if (!a.at) continue;
    const auto reached = ways.from(a.name);
    for (std::size_t j = i + 1; j < gear.points.size(); ++j) {
      const GearPoint& b = gear.points[j];
      const auto way = reached.find(b.name);
      if (!b.at || way == reached.end() || distance(a, b) <= way->second * (1 + limits.short_rope)) continue;
      if (said.emplace(a.point, b.point).second) say_too_short(a, b, way->second, diagnostics);
    }
  }
}

}  // namespace netloft::gears
