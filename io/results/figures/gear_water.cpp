// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of the water inside a bag that a flow (ext/flow.h) slows.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

namespace {

/// The rim of the mouth without the bar in the plane of symmetry that closes it in half a gear.
struct Rim {
  Vector middle;   // mean of the places of its bars [m], in the plane of symmetry of half a gear
  double bar = 0;  // mean length of its bars [m]
};

/// A bag and the forces of the water on it. Water inside a bag has not yet passed the netting, so that only
/// the pressure ahead of the netting has slowed it. By Euler's equations, linearised about the flow U (1 − a)
/// through the netting, the pressure is that of a dipole for every force:
///   p(x) = −Σ F_i·r/(4π |r|³),  r = x − x_i        pressure inside the bag                            (1)
///   u = U − p/(ρ U (1 − a))                         speed inside the bag                               (2)
/// F_i [N] is the force of the water on a triangle of netting, or on a node of a rope, at x_i. The sum
/// includes mirror images in the seabed and, in half a gear, in its plane of symmetry. U [m/s] is the
/// undisturbed speed, a the fraction of the speed that the water loses at the netting, ρ the density of the
/// water. Just ahead of a thin disc of uniform drag, (2) is U (1 − a), the speed at its netting.
struct Bag {
  std::uint32_t flow = 0;             // index of the part that is the flow
  double induction = 0;               // a
  Rim rim;                            // of the mouth
  std::vector<Vector> places, drags;  // x_i [m], F_i [N]
};

std::array<double, 3> undisturbed_at(const GearView& gear, double z) {
  std::array<double, 3> flow{}, dz{};
  gear.loaded().scene.current.at(z, flow, dz);
  return flow;
}

/// Whether a node lies in the plane of symmetry of half a gear.
bool is_cut(const GearView& gear, std::uint32_t node) {
  return gear.is_half() && (gear.loaded().scene.held[node] & kAxisY) != 0;
}

Rim rim_of(const GearView& gear, std::uint32_t flow) {
  const auto& nodes = gear.loaded().scene.parts[flow].nodes;
  Rim rim;
  double bars = 0;
  for (std::size_t n = 0; n + 1 < nodes.size(); n += 2) {
    const Vector a = gear.at(nodes[n]), b = gear.at(nodes[n + 1]);
    if (is_cut(gear, nodes[n]) && is_cut(gear, nodes[n + 1])) continue;
    rim.middle += 0.5 * (a + b), rim.bar += norm(b - a), ++bars;
  }
  rim.middle = (1 / bars) * rim.middle, rim.bar /= bars;
  if (gear.is_half()) rim.middle.y = 0;
  return rim;
}

std::set<std::uint32_t> nodes_in_flow(const GearView& gear, std::uint32_t flow, bool with_ahead) {
  std::set<std::uint32_t> nodes;
  for (const Part& part : gear.loaded().scene.parts)
    if (part.flow == flow && (with_ahead || (!part.reach.empty() && part.reach[0] > 0)))
      nodes.insert(part.nodes.begin(), part.nodes.end());
  return nodes;
}

/// Calls `visit` with each triangle of netting in the water of the flow: its corners, middle and area.
template <class Visit>
void visit_triangles(const GearView& gear, std::uint32_t flow, const Visit& visit) {
  for (const auto& family : gear.assembler().families()) {
    if (family->type().element.stencil != NETLOFT_TRIANGLE || family->repeated()) continue;
    for (std::size_t e = 0; e < family->size(); ++e) {
      const Part& part = gear.loaded().scene.parts[family->part(e)];
      if (part.flow != flow || part.companion) continue;
      const std::array corners{family->node(e, 0), family->node(e, 1), family->node(e, 2)};
      const Vector a = gear.at(corners[0]), b = gear.at(corners[1]), c = gear.at(corners[2]);
      visit(corners, (1.0 / 3) * (a + b + c), 0.5 * norm(cross(b - a, c - a)));
    }
  }
}

/// The bag whose water a part changes; nullopt if the part is no flow. The force on a node of netting is
/// distributed over the triangles around it in proportion to their areas.
std::optional<Bag> bag_of(const GearView& gear, std::uint32_t flow) {
  const auto induction = gear.output(flow, output::kInduction);
  const auto& drag = gear.answer().drag_in_flow;
  if (induction.empty() || !(induction[0] < 1) || drag.empty()) return {};
  Bag bag{flow, induction[0], rim_of(gear, flow), {}, {}};
  const auto force_at = [&](std::uint32_t node) {
    const auto held = gear.assembler().reaction(node, drag), free = gear.assembler().unbalanced(node, drag);
    return Vector{held[0] + free[0], held[1] + free[1], held[2] + free[2]};
  };
  std::map<std::uint32_t, double> areas;  // of the triangles around each node
  visit_triangles(gear, flow, [&](const auto& corners, const Vector&, double area) {
    for (const auto node : corners) areas[node] += area;
  });
  visit_triangles(gear, flow, [&](const auto& corners, const Vector& middle, double area) {
    Vector force;
    for (const auto node : corners)
      if (areas[node] > 0) force += (area / areas[node]) * force_at(node);
    bag.places.push_back(middle);
    bag.drags.push_back(force);
  });
  for (const std::uint32_t node : nodes_in_flow(gear, flow, true))
    if (!areas.contains(node) || !(areas[node] > 0)) {
      bag.places.push_back(gear.at(node));
      bag.drags.push_back(force_at(node));
    }
  return bag;
}

/// Pressure at a place inside a bag, by (1) [Pa].
double pressure_at(const GearView& gear, const Bag& bag, const Vector& place) {
  const auto bed = bed_below(place, gear.loaded().scene);
  const int mirrors_y = gear.is_half() ? 2 : 1, mirrors_z = bed ? 2 : 1;
  double sum = 0;
  for (int my = 0; my < mirrors_y; ++my)
    for (int mz = 0; mz < mirrors_z; ++mz) {
      // A mirrored place sees the bag as the place sees the mirror image of the bag.
      const Vector at{place.x, my ? -place.y : place.y, mz ? 2 * *bed - place.z : place.z};
      for (std::size_t i = 0; i < bag.places.size(); ++i) {
        const Vector r = at - bag.places[i];
        const double far = norm(r);
        if (far > 0) sum -= dot(bag.drags[i], r) / (far * far * far);
      }
    }
  return sum / (4 * std::numbers::pi);
}

/// Speed of the water at a place inside a bag, by (2) [m/s].
double speed_inside(const GearView& gear, const Bag& bag, const Vector& place) {
  const auto flow = undisturbed_at(gear, place.z);
  const double speed = std::hypot(flow[0], flow[1]);
  if (!(speed > 0)) return 0;
  return speed -
         pressure_at(gear, bag, place) / (gear.loaded().scene.water.density * speed * (1 - bag.induction));
}

/// The mean of the speed over the mouth [m/s] and the area of the modelled part of the mouth [m2]. The mouth
/// is divided into triangles between its middle and the bars of its rim. The points of the mean are a quarter
/// of a bar ahead of it, because netting may lie in the mouth itself. With 0.05 to 0.5 of a bar, and with 1
/// to 6 rings, the mean of a trawl differs by less than a thousandth.
struct Mouth {
  double speed = 0, area = 0;
};

Mouth mouth_of(const GearView& gear, const Bag& bag) {
  const auto& nodes = gear.loaded().scene.parts[bag.flow].nodes;
  const Vector middle = bag.rim.middle, start = middle - (0.25 * bag.rim.bar) * gear.current_at(middle);
  constexpr int kRings = 3;
  Mouth mouth;
  for (std::size_t n = 0; n + 1 < nodes.size(); n += 2) {
    const Vector a = gear.at(nodes[n]) - middle, b = gear.at(nodes[n + 1]) - middle;
    const double area = dot(gear.current_at(middle), 0.5 * cross(a, b));
    mouth.area += area;
    for (int ring = 0; ring < kRings; ++ring) {
      const double share = std::sqrt((ring + 0.5) / kRings);  // each ring has the same area
      mouth.speed += area / kRings * speed_inside(gear, bag, start + 0.5 * share * (a + b));
    }
  }
  mouth.speed /= mouth.area;
  return mouth;
}

/// The middle of the bag around a panel: the middle of all netting behind the mouth that lies as far aft as
/// the panel.
Vector middle_around(const GearView& gear, const std::set<std::uint32_t>& netting, std::uint32_t panel) {
  const auto& own = gear.loaded().scene.parts[panel].nodes;
  const auto [fore, aft] = std::ranges::minmax(own, {}, [&](auto node) { return gear.at(node).x; });
  const double from = gear.at(fore).x, to = gear.at(aft).x, x = 0.5 * (from + to);
  constexpr double kFar = std::numeric_limits<double>::max();
  Vector low{kFar, kFar, kFar}, high = -1.0 * low;
  const auto widen = [&](double length) {
    for (const auto node : netting)
      if (const Vector at = gear.at(node); std::abs(at.x - x) <= length) {
        low.y = std::min(low.y, at.y), high.y = std::max(high.y, at.y);
        low.z = std::min(low.z, at.z), high.z = std::max(high.z, at.z);
      }
  };
  widen(0.25 * (to - from));
  if (low.z > high.z) widen(0.5 * (to - from));  // a panel of one cell has nodes at its ends only
  return {x, gear.is_half() ? 0 : 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
}

}  // namespace

void add_water_figures(const GearView& gear, std::vector<Figure>& figures) {
  for (std::uint32_t part = 0; part < gear.loaded().scene.parts.size(); ++part) {
    const auto bag = bag_of(gear, part);
    if (!bag) continue;
    const Mouth mouth = mouth_of(gear, *bag);
    if (!std::isfinite(mouth.speed)) continue;
    figures.push_back({"mouth/induction", "1", "fraction of its speed that the water loses at the netting",
                       bag->induction});
    figures.push_back({"mouth/water_speed", "m/s", "mean speed of the water in the mouth", mouth.speed});
    figures.push_back({"mouth/filtered", "m3/s", "water that passes through the mouth",
                       gear.times() * std::abs(mouth.area) * mouth.speed});
    const auto netting = nodes_in_flow(gear, part, false);
    for (const auto panel : gear.gear().panels)
      if (const Part& its = gear.loaded().scene.parts[panel];
          its.flow == part && !its.reach.empty() && its.reach[0] > 0)
        figures.push_back({"panels/" + gear.name(panel) + "/water_speed", "m/s",
                           "speed of the water in the middle of the bag, between the panels around it",
                           speed_inside(gear, *bag, middle_around(gear, netting, panel))});
  }
}

}  // namespace netloft::results
