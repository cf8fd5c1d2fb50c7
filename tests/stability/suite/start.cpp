// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/start.hpp"

#include "io/scenes/water/dice.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;

namespace {

using Point = std::array<double, 3>;

constexpr std::array<const char*, 5> kKinds{"noise", "scale", "turn", "shift", "shuffle"};

Point read_point(TableReader& table, const char* key, const char* unit, const char* doc, Point fallback) {
  const auto v = table.reals(key, {.unit = unit,
                                   .doc = doc,
                                   .range = between(-1e6, 1e6),
                                   .count = exactly(3),
                                   .fallback = std::vector<double>(fallback.begin(), fallback.end())});
  return v.size() == 3 ? Point{v[0], v[1], v[2]} : fallback;
}

Point read_factor(TableReader& table) {
  if (table.kind("scale") == formats::Kind::array)
    return read_point(table, "scale", "1", "factors along x, y and z", {1, 1, 1});
  const double all =
      table.real("scale", {.doc = "factor, or factors along x, y and z", .range = between(-1e6, 1e6)});
  return {all, all, all};
}

int read_axis(TableReader& table) {
  const std::string axis =
      table.choice("axis", {.allowed = {"x", "y", "z"}, .doc = "axis that it turns about"});
  return axis.empty() ? 0 : axis[0] - 'x';
}

/// Finds which of the keys noise, scale, turn, shift and shuffle a step has; it must have exactly one of
/// them.
int find_kind(TableReader& table) {
  int found = -1, count = 0;
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (table.has(kKinds[k])) found = static_cast<int>(k), ++count;
  if (count == 1) return found;
  table.diagnostics().error(table.place(),
                            table.path() + ": one of noise, scale, turn, shift and shuffle is expected");
  return -1;
}

StartStep read_step(TableReader& table, std::uint64_t seed) {
  StartStep s;
  const int kind = find_kind(table);
  if (kind < 0) return s;
  s.kind = static_cast<StartStep::Kind>(kind);
  s.seed = static_cast<std::uint64_t>(table.integer(
      "seed", {.doc = "of the random numbers", .lo = 0, .fallback = static_cast<std::int64_t>(seed)}));
  switch (s.kind) {
    case StartStep::Kind::noise:
      s.amplitude = table.real(
          "noise", {.unit = "m", .doc = "farthest move along each axis", .range = between(0, 1e6)});
      break;
    case StartStep::Kind::scale:
      s.factor = read_factor(table), s.about = read_point(table, "about", "m", "what stays in place", {});
      break;
    case StartStep::Kind::turn:
      s.angle = table.real("turn", {.unit = "rad", .doc = "angle, such as \"90 deg\""});
      s.axis = read_axis(table), s.about = read_point(table, "about", "m", "what stays in place", {});
      break;
    case StartStep::Kind::shift:
      s.shift = read_point(table, "shift", "m", "how far all moves", {});
      break;
    case StartStep::Kind::shuffle:
      table.boolean("shuffle", {.doc = "nodes change places"});
      break;
  }
  return s;
}

Point position(const Scene& scene, std::size_t node) {
  return {scene.positions[3 * node], scene.positions[3 * node + 1], scene.positions[3 * node + 2]};
}

/// Nodes that do not belong to a rigid body and are free along some axis.
std::vector<std::uint32_t> movable_nodes(const Scene& scene) {
  std::vector<bool> rigid(scene.node_count(), false);
  for (const auto& body : scene.bodies) {
    rigid[body.origin] = true;
    for (const auto& point : body.points) rigid[point.node] = true;
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n < scene.node_count(); ++n)
    if (!rigid[n] && scene.held[n] != kAllAxes) nodes.push_back(n);
  return nodes;
}

/// Adds to a node the part of a move that its hold allows.
void move(Scene& scene, std::uint32_t node, const Point& by) {
  const auto frame = scene.frames.find(node);
  for (std::size_t own = 0; own < 3; ++own) {
    if (scene.held[node] & (1 << own)) continue;
    if (frame == scene.frames.end()) {
      scene.positions[3 * node + own] += by[own];
      continue;
    }
    const auto& column = frame->second;
    const double along = column[own] * by[0] + column[3 + own] * by[1] + column[6 + own] * by[2];
    for (std::size_t axis = 0; axis < 3; ++axis)
      scene.positions[3 * node + axis] += along * column[3 * axis + own];
  }
}

Point turned(const Point& x, int axis, double angle) {
  const auto a = static_cast<std::size_t>((axis + 1) % 3), b = static_cast<std::size_t>((axis + 2) % 3);
  Point y = x;
  y[a] = std::cos(angle) * x[a] - std::sin(angle) * x[b];
  y[b] = std::sin(angle) * x[a] + std::cos(angle) * x[b];
  return y;
}

/// Returns where a step moves a node if the node is not held.
Point target(const StartStep& s, const Point& x, scenes::Dice& dice) {
  Point y = x;
  for (std::size_t i = 0; i < 3; ++i) y[i] -= s.about[i];
  if (s.kind == StartStep::Kind::turn) y = turned(y, s.axis, s.angle);
  for (std::size_t i = 0; i < 3; ++i) {
    if (s.kind == StartStep::Kind::scale) y[i] *= s.factor[i];
    if (s.kind == StartStep::Kind::shift) y[i] += s.shift[i];
    if (s.kind == StartStep::Kind::noise) y[i] += dice.uniform(-s.amplitude, s.amplitude);
    y[i] += s.about[i];
  }
  return y;
}

/// Shuffles by the algorithm of Fisher and Yates.
std::vector<std::uint32_t> shuffled(std::vector<std::uint32_t> nodes, scenes::Dice& dice) {
  for (std::size_t i = nodes.size(); i > 1; --i) std::swap(nodes[i - 1], nodes[dice.index(i)]);
  return nodes;
}

}  // namespace

std::vector<StartStep> read_start(TableReader& table, std::uint64_t seed) {
  std::vector<StartStep> steps;
  for (auto& step : table.tables("start", Presence::optional, "how the start is spoilt"))
    steps.push_back(read_step(step, seed + steps.size()));
  return steps;
}

void spoil(Scene& scene, const std::vector<StartStep>& steps) {
  const auto nodes = movable_nodes(scene);
  for (const StartStep& s : steps) {
    scenes::Dice dice(s.seed);
    std::vector<Point> to;
    if (s.kind == StartStep::Kind::shuffle)
      for (const auto other : shuffled(nodes, dice)) to.push_back(position(scene, other));
    else
      for (const auto node : nodes) to.push_back(target(s, position(scene, node), dice));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Point from = position(scene, nodes[i]);
      move(scene, nodes[i], {to[i][0] - from[0], to[i][1] - from[1], to[i][2] - from[2]});
    }
  }
}

}  // namespace netloft::hard_cases
