// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/start_shape.hpp"

#include "io/formats/work/long_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <set>
#include <unordered_map>

namespace netloft::gears {

namespace {

constexpr double kAspect = 0.4;  // k of (3): height of a section divided by its width

std::size_t at(std::uint32_t node, int axis) {
  return 3 * std::size_t{node} + static_cast<std::size_t>(axis);
}

/// The half width w of (3) in start_shape.hpp: that of an ellipse with the perimeter 2 S (formula of
/// Ramanujan 1914, whose perimeter is accurate to 1e-3 or better).
double half_width(double half_girth) {
  const double q = (1 - kAspect) / (1 + kAspect), lambda = q * q;
  const double shape = (1 + kAspect) * (1 + 3 * lambda / (10 + std::sqrt(4 - 3 * lambda)));
  return 2 * half_girth / (std::numbers::pi * shape);
}

/// For each node, the indices of the ropes to which it belongs.
std::vector<std::vector<std::size_t>> ropes_at_nodes(const GearMesh& mesh) {
  std::vector<std::vector<std::size_t>> ropes(mesh.nodes);
  for (std::size_t r = 0; r < mesh.ropes.size(); ++r)
    for (const auto node : mesh.ropes[r].nodes) ropes[node].push_back(r);
  return ropes;
}

void collect_sketch(const GearPanel& panel, const PanelMesh& mesh, std::vector<KnownCoordinate>& known) {
  for (std::size_t own = 0; own < mesh.nodes.size(); ++own) {
    const auto point = panel.sketched({mesh.meshes[own][0], mesh.meshes[own][1]});
    for (int axis = 0; axis < 3; ++axis)
      known.push_back({mesh.nodes[own], axis, point[static_cast<std::size_t>(axis)]});
  }
}

/// All known coordinates, each once, sorted by node and axis. If there are several for one node and axis, the
/// order of priority is: coordinates from the caller, points of the plan, the plane of symmetry, sketches.
std::vector<KnownCoordinate> collect_known(const Gear& gear, const GearMesh& mesh,
                                           std::vector<KnownCoordinate> known) {
  for (const auto& point : gear.points)
    if (const auto node = mesh.points.find(point.name); point.at && node != mesh.points.end())
      for (int axis = 0; axis < 3; ++axis)
        known.push_back({node->second, axis, (*point.at)[static_cast<std::size_t>(axis)]});
  for (const auto node : mesh.middle) known.push_back({node, 1, 0.0});
  for (std::size_t p = 0; p < mesh.panels.size(); ++p)
    if (gear.panels[p].has_sketch()) collect_sketch(gear.panels[p], mesh.panels[p], known);
  std::vector<bool> is_known(3 * mesh.nodes);
  std::erase_if(known, [&](const auto& k) {
    const bool again = is_known[at(k.node, k.axis)];
    is_known[at(k.node, k.axis)] = true;
    return again;
  });
  std::ranges::sort(known, {}, [](const auto& k) { return at(k.node, k.axis); });
  return known;
}

/// Positions of the nodes of the netting on rings (3), and zeros for all other nodes.
std::vector<double> on_rings(const GearMesh& mesh, const Girth& girth) {
  std::vector<double> positions(3 * mesh.nodes);
  for (std::uint32_t node = 0; node < mesh.nodes; ++node) {
    if (!girth.covers(node)) continue;
    const double half = girth.half_girth(node), w = half_width(half);
    const double angle =
        std::clamp(std::numbers::pi * girth.around(node) / half, 0.0, std::numbers::pi);  // (3)
    positions[at(node, 0)] = girth.aft(node);
    positions[at(node, 1)] = girth.side(node) * w * std::sin(angle);
    positions[at(node, 2)] = girth.is_closed(node) ? 0 : kAspect * w * std::cos(angle);
  }
  return positions;
}

void append_leads(std::uint32_t from, const Neighbours& neighbours, const Girth& girth,
                  std::vector<Lead>& leads) {
  std::unordered_map<std::uint32_t, double> best;
  std::unordered_map<std::uint32_t, std::uint32_t> before;
  using Reached = std::pair<double, std::uint32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  best[from] = 0;
  for (queue.push({0, from}); !queue.empty();) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > best[node]) continue;
    if (girth.covers(node)) {
      leads.push_back({from, node, length, {}});
      for (auto k = before[node]; k != from; k = before[k]) leads.back().between.push_back({k, best[k]});
      continue;  // paths end at the netting
    }
    for (const auto& [next, step] : neighbours[node])
      if (const auto known = best.find(next); known == best.end() || length + step < known->second) {
        before[next] = node;
        queue.push({best[next] = length + step, next});
      }
  }
}

/// Finds the shortest paths along ropes from nodes beside the netting to the netting (Dijkstra 1959).
std::vector<Lead> find_leads(const std::vector<std::uint32_t>& nodes, const GearMesh& mesh,
                             const Girth& girth) {
  const auto neighbours = rope_neighbours(mesh);
  std::vector<Lead> leads;
  for (const auto node : nodes) append_leads(node, neighbours, girth, leads);
  return leads;
}

/// Makes one shape; the member functions are steps in the order of execution.
class Shaper {
 public:
  Shaper(const Gear& gear, const GearMesh& mesh, const Girth& girth, HarmonicFields& fields,
         StoredRopes& ropes, std::vector<double> rings, const std::vector<KnownCoordinate>& known)
      : mesh_(mesh),
        girth_(girth),
        fields_(fields),
        ropes_(ropes),
        known_(known),
        positions_(std::move(rings)),
        placed_(mesh.nodes, false) {
    for (std::uint32_t node = 0; node < mesh.nodes; ++node) placed_[node] = girth.covers(node);
    for (const auto& k : known) known_at_.emplace(at(k.node, k.axis), k.value);
    for (const auto& point : gear.points)
      if (const auto node = mesh.points.find(point.name);
          node != mesh.points.end() && point.point->name.find('.') != std::string::npos)
        of_bodies_.insert(node->second);
  }

  std::vector<double> make() {
    formats::report({"placing", "the gear", mesh_.nodes, "nodes"});
    leads_ = ropes_.leads.of(points_of_leads(), [&](const auto& nodes) {
      return std::make_shared<const std::vector<Lead>>(find_leads(nodes, mesh_, girth_));
    });
    stand_as_a_whole();
    put_ropes();
    follow_known();
    straighten_ropes();
    return std::move(positions_);
  }

 private:
  double& x(std::uint32_t node, int axis) { return positions_[at(node, axis)]; }

  /// Shifts the whole netting aft and vertically to the known coordinates of its nodes. If there are none,
  /// ropes from known points determine the shift aft, such that they reach the netting, and the lowest point
  /// of the netting becomes as deep as the lowest known point.
  void stand_as_a_whole() {
    const double aft = shift_along(0, true);
    for (std::uint32_t node = 0; node < mesh_.nodes; ++node)
      if (placed_[node]) x(node, 0) += aft;
    const double up = shift_along(2, false);
    for (std::uint32_t node = 0; node < mesh_.nodes; ++node)
      if (placed_[node]) x(node, 2) += up;
  }

  double shift_along(int axis, bool by_ropes) {
    double sum = 0, count = 0;
    for (const auto& k : known_)
      if (k.axis == axis && placed_[k.node]) {
        sum += k.value - x(k.node, axis);
        ++count;
      }
    if (count > 0) return sum / count;
    return by_ropes ? shift_by_leads() : shift_to_lowest();
  }

  std::optional<double> known_at(std::uint32_t node, int axis) const {
    const auto known = known_at_.find(at(node, axis));
    return known == known_at_.end() ? std::nullopt : std::optional(known->second);
  }

  /// The shift aft [m] with which the ropes from known points to the netting are straight, on average.
  double shift_by_leads() {
    double sum = 0, count = 0;
    for (const Lead& lead : *leads_) {
      const double aside = known_at(lead.to, 1).value_or(x(lead.to, 1)) - *known_at(lead.from, 1);
      const double along =
          std::sqrt(std::max(lead.length * lead.length - aside * aside, 0.25 * lead.length * lead.length));
      sum += *known_at(lead.from, 0) + along - x(lead.to, 0);
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }

  double shift_to_lowest() {
    double known = std::numeric_limits<double>::infinity(), lowest = known;
    for (const auto& k : known_)
      if (k.axis == 2) known = std::min(known, k.value);
    for (std::uint32_t node = 0; node < mesh_.nodes; ++node)
      if (placed_[node]) lowest = std::min(lowest, x(node, 2));
    return std::isfinite(known) && std::isfinite(lowest) ? known - lowest : 0;
  }

  /// The known points off the netting from which ropes may lead to it.
  std::vector<std::uint32_t> points_of_leads() const {
    std::vector<std::uint32_t> nodes;
    for (const auto& k : known_)
      if (k.axis == 0 && !placed_[k.node] && known_at(k.node, 1)) nodes.push_back(k.node);
    return nodes;
  }

  /// Places ropes that are not on the netting: straight between two placed nodes, or straight forward from
  /// one placed node.
  void put_ropes() {
    for (const auto& k : known_) complete(k.node);
    put_on_leads();
    put_stretches();
  }

  /// Places stretches of ropes one by one: the first one between two placed nodes or, if there is none, the
  /// first one with one placed node. A rope is tried again only after one of its nodes has been placed.
  void put_stretches() {
    // Ropes that may have a stretch between two placed nodes, or from one placed node.
    std::set<std::size_t> between, from_one;
    for (std::size_t r = 0; r < mesh_.ropes.size(); ++r) {
      between.insert(r);
      from_one.insert(r);
    }
    while (!between.empty() || !from_one.empty()) {
      const bool is_between = !between.empty();
      auto& candidates = is_between ? between : from_one;
      fresh_.clear();
      if (!put_stretch(mesh_.ropes[*candidates.begin()], is_between)) candidates.erase(candidates.begin());
      for (const auto node : fresh_)
        for (const auto rope : ropes_.at_nodes[node]) {
          between.insert(rope);
          from_one.insert(rope);
        }
    }
  }

  /// Places the ropes on each path from a board to the netting along a straight line.
  void put_on_leads() {
    for (const Lead& lead : *leads_) {
      if (!is_of_body(lead.from) || !placed_[lead.from]) continue;
      for (const auto& [node, distance] : lead.between) {
        if (placed_[node]) continue;
        const double t = distance / lead.length;
        for (int axis = 0; axis < 3; ++axis)
          x(node, axis) = (1 - t) * x(lead.from, axis) + t * x(lead.to, axis);
        placed_[node] = true;
      }
    }
  }

  bool is_of_body(std::uint32_t node) const { return of_bodies_.contains(node); }

  /// Marks a node that is not on the netting as placed, once all coordinates of the node are known.
  void complete(std::uint32_t node) {
    if (placed_[node]) return;
    std::array<std::optional<double>, 3> p{known_at(node, 0), known_at(node, 1), known_at(node, 2)};
    if (!p[0] || !p[1] || !p[2]) return;
    for (int axis = 0; axis < 3; ++axis) x(node, axis) = *p[static_cast<std::size_t>(axis)];
    placed_[node] = true;
  }

  /// Places one stretch of a rope: between two placed nodes if `between`, else from one placed node. Returns
  /// false if there is no such stretch.
  bool put_stretch(const RopeMesh& rope, bool between) {
    for (std::size_t i = 0; i < rope.nodes.size(); ++i) {
      if (placed_[rope.nodes[i]]) continue;
      std::size_t end = i;
      while (end < rope.nodes.size() && !placed_[rope.nodes[end]]) ++end;
      const bool has_before = i > 0, has_after = end < rope.nodes.size();
      if (between && has_before && has_after) return put_between(rope, i - 1, end), true;
      if (!between && has_before) return put_forward(rope, i - 1, end - 1), true;
      if (!between && has_after) return put_forward(rope, end, i), true;
      i = end;
    }
    return false;
  }

  void put_between(const RopeMesh& rope, std::size_t first, std::size_t last) {
    double whole = 0, length = 0;
    for (std::size_t i = first; i < last; ++i) whole += rope.rest_lengths[i];
    for (std::size_t i = first + 1; i < last; ++i) {
      length += rope.rest_lengths[i - 1];
      const double t = length / whole;
      for (int axis = 0; axis < 3; ++axis)
        x(rope.nodes[i], axis) = (1 - t) * x(rope.nodes[first], axis) + t * x(rope.nodes[last], axis);
      put(rope.nodes[i]);
    }
  }

  /// Places the nodes of a rope from `from` to `to` straight forward of a placed node.
  void put_forward(const RopeMesh& rope, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i != to;) {
      const std::size_t next = i < to ? i + 1 : i - 1;
      const auto here = rope.nodes[i], there = rope.nodes[next];
      x(there, 0) = x(here, 0) - rope.rest_lengths[std::min(i, next)];
      x(there, 1) = x(here, 1);
      x(there, 2) = x(here, 2);
      put(there);
      i = next;
    }
  }

  void put(std::uint32_t node) {
    placed_[node] = true;
    fresh_.push_back(node);
  }

  /// Adds displacements that are harmonic on the net and bring every known coordinate to its value.
  void follow_known() {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::pair<std::uint32_t, double>> moved;
      for (const auto& k : known_)
        if (k.axis == axis) moved.push_back({k.node, k.value - x(k.node, axis)});
      if (moved.empty()) continue;
      const auto displacement = fields_.with(moved);
      for (std::uint32_t node = 0; node < mesh_.nodes; ++node) x(node, axis) += displacement[node];
    }
  }

  void straighten_ropes() {
    std::fill(placed_.begin(), placed_.end(), false);
    for (const auto& panel : mesh_.panels)
      for (const auto node : panel.nodes) placed_[node] = true;
    for (const auto& k : known_) placed_[k.node] = true;
    for (const auto& rope : mesh_.ropes) placed_[rope.nodes.front()] = placed_[rope.nodes.back()] = true;
    for (const auto& rope : mesh_.ropes)
      while (put_stretch(rope, true)) {
      }
  }

  const GearMesh& mesh_;
  const Girth& girth_;
  HarmonicFields& fields_;
  StoredRopes& ropes_;
  const std::vector<KnownCoordinate>& known_;
  std::unordered_map<std::size_t, double> known_at_;  // known coordinates, by at(node, axis)
  std::set<std::uint32_t> of_bodies_;                 // the nodes at points of bodies
  std::vector<double> positions_;
  std::vector<bool> placed_;
  std::shared_ptr<const std::vector<Lead>> leads_;
  std::vector<std::uint32_t> fresh_;  // the nodes that put_stretch() has placed
};

}  // namespace

StartShapes::StartShapes(const Gear& gear, const GearMesh& mesh)
    : gear_(gear),
      mesh_(mesh),
      girth_(gear, mesh),
      fields_(mesh),
      ropes_{ropes_at_nodes(mesh)},
      rings_(on_rings(mesh, girth_)) {}

std::vector<double> StartShapes::with(const Gear& placed, const std::vector<KnownCoordinate>& known) {
  return *shapes_.of(collect_known(placed, mesh_, known), [&](const std::vector<KnownCoordinate>& all) {
    return std::make_shared<const std::vector<double>>(
        Shaper(gear_, mesh_, girth_, fields_, ropes_, rings_, all).make());
  });
}

}  // namespace netloft::gears
