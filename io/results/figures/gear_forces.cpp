// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of the forces of water, weight and ground on the parts of a gear.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

namespace {

struct PartGroup {
  std::string name;
  std::vector<std::uint32_t> parts;
};

/// Groups the parts of the scene by kind. The group "others" has the parts that are not in the net plan.
std::vector<PartGroup> kinds_of(const GearView& gear) {
  const scenes::GearInScene& g = gear.gear();
  std::vector<PartGroup> kinds = {
      {"all", {}}, {"netting", g.panels}, {"ropes", g.ropes}, {"floats", g.pieces}, {"others", {}}};
  std::set<std::uint32_t> planned(g.panels.begin(), g.panels.end());
  planned.insert(g.ropes.begin(), g.ropes.end());
  planned.insert(g.pieces.begin(), g.pieces.end());
  const auto& parts = gear.loaded().scene.parts;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    if (parts[p].companion)
      continue;  // the force of a part includes that of its companion, which has the same name
    kinds.front().parts.push_back(p);
    if (!planned.contains(p)) kinds.back().parts.push_back(p);
  }
  return kinds;
}

Vector sum_over(const GearView& gear, const PartGroup& kind, const GearView::Kind& is_of_kind) {
  Vector sum;
  for (const auto part : kind.parts) sum += gear.force(gear.name(part), is_of_kind);
  return whole_of(sum, gear.times());
}

bool any_has(const GearView& gear, const PartGroup& kind, const GearView::Kind& is_of_kind) {
  return std::any_of(kind.parts.begin(), kind.parts.end(),
                     [&](auto part) { return gear.has_force(gear.name(part), is_of_kind); });
}

void add_vector(const std::string& at, const std::string& doc, const Vector& force,
                std::vector<Figure>& figures) {
  figures.push_back({at + "x", "N", doc + ", aft", force.x});
  figures.push_back(
      {at + "y", "N", doc + ", to starboard; for half a gear, the force on the starboard half", force.y});
  figures.push_back({at + "z", "N", doc + ", upwards", force.z});
}

void add_drag(const GearView& gear, const std::string& at, const PartGroup& kind,
              std::vector<Figure>& figures) {
  if (any_has(gear, kind, &PartForce::is_drag))
    add_vector(at + kind.name + "/", "force of the water", sum_over(gear, kind, &PartForce::is_drag),
               figures);
}

void add_weight(const GearView& gear, const std::string& at, const PartGroup& kind,
                std::vector<Figure>& figures) {
  if (any_has(gear, kind, &PartForce::is_weight))
    figures.push_back({at + kind.name, "N", "weight in water, negative if the part floats",
                       -sum_over(gear, kind, &PartForce::is_weight).z});
}

/// Returns a group of one part for every part of a kind.
std::vector<PartGroup> parts_of(const GearView& gear, const PartGroup& kind) {
  std::vector<PartGroup> parts;
  for (const auto part : kind.parts) parts.push_back({gear.name(part), {part}});
  return parts;
}

/// Adds two figures: the total weight in water of all parts that sink, and that of all parts that float.
void add_budget(const GearView& gear, const std::vector<PartGroup>& parts, std::vector<Figure>& figures) {
  double sinking = 0, floating = 0;
  for (const auto& part : parts) {
    const double weight = -sum_over(gear, part, &PartForce::is_weight).z;
    (weight > 0 ? sinking : floating) += weight;
  }
  figures.push_back({"budget/sinking", "N", "weight in water of all parts that sink", sinking});
  figures.push_back({"budget/floating", "N", "weight in water of all parts that float", floating});
}

/// Normal forces of the ground on nodes in contact with it [N].
std::map<std::uint32_t, double> forces_of_ground(const GearView& gear) {
  std::map<std::uint32_t, double> forces;
  for (std::size_t f = 0; f < gear.answer().outputs.size(); ++f) {
    const ElementFamily& family = *gear.assembler().families()[f];
    const auto& outputs = family.type().outputs;
    for (std::size_t k = 0; k < outputs.size(); ++k)
      for (std::size_t e = 0; e < family.size() && is_output(outputs[k], output::kNormalForce); ++e)
        if (const double force = gear.answer().outputs[f][k][e]; force > 0)
          forces[family.node(e, 0)] += force;
  }
  return forces;
}

double fraction_on_ground(const GearView& gear, std::uint32_t rope,
                          const std::map<std::uint32_t, double>& touching) {
  const auto& nodes = gear.nodes_of(rope);
  const auto lengths = gear.rest_lengths(rope);
  double on = 0, all = 0;
  for (std::size_t bar = 0; bar < lengths.size(); ++bar) {
    on += 0.5 * lengths[bar] *
          static_cast<double>(touching.count(nodes[bar]) + touching.count(nodes[bar + 1]));  // (4)
    all += lengths[bar];
  }
  return on / all;
}

/// A stretch of the footrope, on both sides of the gear together: its length [m], its length on the ground
/// [m], and the normal force of the ground on it [N].
struct OnGround {
  double length = 0, touching = 0, force = 0;
};

constexpr int kStretches = 5;

/// Distributes the contact of a node among the stretches, in proportion to their overlap with the piece of
/// rope that the node represents. This piece lies between the distances `from` and `to` from the middle of
/// the footrope [m]; `half` is the length from the middle to an end [m].
void add_to_stretches(double from, double to, double half, double force, bool touches,
                      std::array<OnGround, kStretches>& all) {
  for (int k = 0; k < kStretches; ++k) {
    const double begin = half * k / kStretches, end = half * (k + 1) / kStretches;
    const double length = std::max(0.0, std::min(to, end) - std::max(from, begin));
    all[static_cast<std::size_t>(k)].length += length;
    if (touches) all[static_cast<std::size_t>(k)].touching += length;
    all[static_cast<std::size_t>(k)].force += length / (to - from) * force;
  }
}

/// The footrope, divided into equal stretches from its middle to its ends. In a half gear the rope starts in
/// the middle.
std::array<OnGround, kStretches> stretches_of(const GearView& gear, std::uint32_t footrope,
                                              const std::map<std::uint32_t, double>& forces) {
  const auto& nodes = gear.nodes_of(footrope);
  const auto lengths = gear.rest_lengths(footrope);
  const double all = std::accumulate(lengths.begin(), lengths.end(), 0.0),
               middle = gear.is_half() ? 0 : all / 2;
  std::array<OnGround, kStretches> stretches;
  double s = 0;  // length from the start of the rope to the node
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double before = i ? lengths[i - 1] / 2 : 0, after = i < lengths.size() ? lengths[i] / 2 : 0;
    const auto at = forces.find(nodes[i]);
    const double force = at == forces.end() ? 0 : at->second, from = s - before - middle,
                 to = s + after - middle;
    const auto add = [&](double one, double other) {  // distances from the middle
      if (other > one)
        add_to_stretches(one, other, all - middle, force * (other - one) / (to - from), force > 0, stretches);
    };
    add(std::max(from, 0.0), to);
    add(std::max(-to, 0.0), -from);
    if (i < lengths.size()) s += lengths[i];
  }
  return stretches;
}

void add_stretches(const GearView& gear, std::uint32_t footrope,
                   const std::map<std::uint32_t, double>& forces, std::vector<Figure>& figures) {
  const auto stretches = stretches_of(gear, footrope, forces);
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const OnGround& one = stretches[k];
    const std::string at = "footrope/" + std::to_string(100 / kStretches * k) + "-" +
                           std::to_string(100 / kStretches * (k + 1)) + "%/";
    const std::string where =
        ", on the part of the footrope between these fractions of the distance from its middle to its ends";
    figures.push_back(
        {at + "touching", "m", "length in contact with the ground" + where, gear.times() * one.touching});
    figures.push_back(
        {at + "force", "N", "force of the ground along its normal" + where, gear.times() * one.force});
    figures.push_back({at + "force_per_metre", "N/m", "force of the ground over length" + where,
                       one.length > 0 ? one.force / one.length : 0});
  }
}

void add_footrope(const GearView& gear, std::uint32_t footrope, std::vector<Figure>& figures) {
  const auto forces = forces_of_ground(gear);
  const double fraction = fraction_on_ground(gear, footrope, forces);
  const auto lengths = gear.rest_lengths(footrope);
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  double force = 0;
  for (const auto node : gear.nodes_of(footrope))
    if (const auto at = forces.find(node); at != forces.end()) force += at->second;
  figures.push_back({"ground/footrope_fraction", "1",
                     "fraction of the footrope's length that touches the ground", fraction});
  figures.push_back({"ground/footrope_length", "m", "length of the footrope that touches the ground",
                     gear.times() * fraction * length});
  figures.push_back({"ground/footrope_force", "N", "force of the ground on the footrope, along its normal",
                     gear.times() * force});
  add_stretches(gear, footrope, forces, figures);
}

}  // namespace

void add_force_figures(const GearView& gear, std::vector<Figure>& figures) {
  const auto kinds = kinds_of(gear);
  const auto parts = parts_of(gear, kinds.front());
  for (const auto& kind : kinds) add_drag(gear, "drag/", kind, figures);
  for (const auto& part : parts) add_drag(gear, "drag_by_part/", part, figures);
  for (const auto& kind : kinds) add_weight(gear, "weight_in_water/", kind, figures);
  if (any_has(gear, kinds.front(), &PartForce::is_weight)) add_budget(gear, parts, figures);
  for (const auto& part : parts) add_weight(gear, "weight_in_water_by_part/", part, figures);
}

void add_ground_figures(const GearView& gear, std::vector<Figure>& figures) {
  const PartGroup all = kinds_of(gear).front();
  double normal = 0;
  bool is_there = false;
  for (const auto part : all.parts)
    for (const double force : gear.output(part, output::kNormalForce)) {
      normal += force;
      is_there = true;
    }
  if (!is_there) return;
  figures.push_back({"ground/force", "N", "force of the ground, along its normal", gear.times() * normal});
  if (any_has(gear, all, &PartForce::is_along_ground))
    add_vector("ground/friction_", "force of the ground along its surface",
               sum_over(gear, all, &PartForce::is_along_ground), figures);
  if (const auto* footrope = gear.find_rope(gear.gear().footrope)) add_footrope(gear, *footrope, figures);
}

}  // namespace netloft::results
