// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/gear.hpp"
#include "io/gears/plan/names.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <set>
#include <unordered_map>
#include <vector>

namespace netloft::gears {

namespace {

/// A graph for shortest paths along ropes. Its numbered vertices are points, and the start, middle and end of
/// each rope; its edges are halves of ropes.
class RopeWays {
 public:
  explicit RopeWays(const Gear& gear) {
    for (const auto& rope : gear.ropes) {
      const std::size_t start = vertex(rope.name + ".start"), middle = vertex(rope.name + ".middle"),
                        end = vertex(rope.name + ".end");
      connect(start, middle, rope.length / 2);
      connect(middle, end, rope.length / 2);
      tie(start, rope.between[0]);
      tie(end, rope.between[1]);
      tie(middle, rope.middle);
    }
  }

  /// The number of a vertex; nullopt if no rope leads to a point of this name.
  std::optional<std::size_t> find(const std::string& name) const {
    const auto at = numbers_.find(name);
    return at == numbers_.end() ? std::nullopt : std::optional(at->second);
  }

  /// Lengths of the shortest paths along ropes from one vertex to all vertices within the distance `most` [m]
  /// (E. W. Dijkstra 1959). The work is proportional to the number of these vertices.
  std::unordered_map<std::size_t, double> from(std::size_t start, double most = kFar) const {
    std::unordered_map<std::size_t, double> lengths;
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    for (next.push({0, start}); !next.empty() && next.top().first <= most;) {
      const auto [length, at] = next.top();
      next.pop();
      if (!lengths.emplace(at, length).second) continue;
      for (const Way& way : ways_[at]) next.push({length + way.length, way.to});
    }
    return lengths;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  struct Way {
    std::size_t to;
    double length;
  };

  std::size_t vertex(const std::string& name) {
    const auto [at, is_new] = numbers_.emplace(name, ways_.size());
    if (is_new) ways_.emplace_back();
    return at->second;
  }
  void tie(std::size_t vertex_of_rope, const std::string& point) {
    if (!point.empty()) connect(vertex_of_rope, vertex(point), 0);
  }
  void connect(std::size_t a, std::size_t b, double length) {
    ways_[a].push_back({b, length});
    ways_[b].push_back({a, length});
  }

  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<std::vector<Way>> ways_;
};

void say_too_short(const NetPlan& plan, const RopeSpan& span, double distance,
                   formats::Diagnostics& diagnostics) {
  diagnostics.error(
      plan.points[span.ends[1].point].place,
      fmt::format("{} and {} are {} m apart, but the ropes between them are only {} m long",
                  span.ends[0].name, span.ends[1].name, in_metres(distance), in_metres(span.length)),
      "give `at` in metres, x aft, y to starboard, z up, or lengthen the ropes");
}

}  // namespace

void check_loops(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  const Gear gear = make_rigging(plan);
  const RopeWays ways(gear);
  const HangingsByRope hangings = hangings_by_rope(plan);
  for (const auto& rope : gear.ropes) {
    if (hangings.contains(rope.rope->name) || rope.is_mirrored) continue;
    const bool is_across = !rope.middle.empty();
    const double length = is_across ? rope.length / 2 : rope.length;
    const auto reached = ways.from(*ways.find(rope.name + ".end"), length * 1e-6);
    if (!reached.contains(*ways.find(rope.name + (is_across ? ".middle" : ".start")))) continue;
    diagnostics.error(rope.rope->between_place,
                      fmt::format("ropes.{}.between: both ends of the rope are one point", rope.rope->name),
                      "a rope leads from one point to another");
  }
}

std::vector<RopeSpan> rope_spans(const NetPlan& plan) {
  const Gear gear = make_rigging(plan);
  const RopeWays ways(gear);
  const auto end_at = [&](const GearPoint& point) {
    return RopeSpan::End{static_cast<std::size_t>(point.point - plan.points.data()), point.is_mirrored,
                         point.name};
  };
  std::vector<RopeSpan> spans;
  for (std::size_t i = 0; i < gear.points.size(); ++i) {
    const auto start = ways.find(gear.points[i].name);
    if (!start) continue;
    const auto reached = ways.from(*start);
    for (std::size_t j = i + 1; j < gear.points.size(); ++j)
      if (const auto other = ways.find(gear.points[j].name); other && reached.contains(*other))
        spans.push_back({{end_at(gear.points[i]), end_at(gear.points[j])}, reached.at(*other)});
  }
  return spans;
}

void check_spans(const NetPlan& plan, const std::vector<RopeSpan>& spans, const CheckLimits& limits,
                 formats::Diagnostics& diagnostics) {
  std::set<std::pair<std::size_t, std::size_t>> said;  // the messages for port and starboard would be the
                                                       // same
  for (const RopeSpan& span : spans) {
    const auto a = position(plan.points[span.ends[0].point], span.ends[0].is_mirrored),
               b = position(plan.points[span.ends[1].point], span.ends[1].is_mirrored);
    if (!a || !b) continue;
    const double distance = std::hypot((*b)[0] - (*a)[0], (*b)[1] - (*a)[1], (*b)[2] - (*a)[2]);
    if (distance <= span.length * (1 + limits.short_rope)) continue;
    if (said.emplace(span.ends[0].point, span.ends[1].point).second)
      say_too_short(plan, span, distance, diagnostics);
  }
}

}  // namespace netloft::gears
