// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/dimensions.hpp"

#include "io/results/figures/figure_names.hpp"
#include "io/results/file/rope_nodes.hpp"
#include "io/results/file/ship.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::results {

namespace {

using Where = DimensionEnd::Where;

/// The middle node of a rope that runs from port to starboard. In a half gear the rope starts there.
std::uint32_t middle_of(const std::vector<std::uint32_t>& rope, bool is_half) {
  return rope[is_half ? 0 : rope.size() / 2];
}

Dimension spread_of(const std::string& name, const std::vector<std::uint32_t>& rope, bool is_half) {
  const DimensionEnd starboard{Where::node, rope.back()};
  return {name,
          is_half ? DimensionEnd{Where::mirrored, rope.back()} : DimensionEnd{Where::node, rope.front()},
          starboard};
}

/// Nodes on which a hold acts. They have a reaction along x or z, whereas the plane of symmetry causes
/// reactions along y only.
std::vector<std::uint32_t> held_nodes(const StoredShape& stored) {
  const auto reaction = stored.node_field("reaction", stored.times.size() - 1);
  std::vector<std::uint32_t> held;
  for (std::uint32_t n = 0; 3 * n + 2 < reaction.size(); ++n)
    if (std::hypot(reaction[3 * n], reaction[3 * n + 2]) > 0) held.push_back(n);
  return held;
}

/// Adds the spread of the towing points: between two held nodes of a whole gear, or between the only held
/// node of a half gear and its mirror image.
void add_towing_spread(const StoredShape& stored, std::vector<Dimension>& all) {
  const auto held = held_nodes(stored);
  if (held.size() == 1 && stored.result.is_half())
    all.push_back({"spread of the towing points", {Where::mirrored, held[0]}, {Where::node, held[0]}});
  if (held.size() == 2 && !stored.result.is_half())
    all.push_back({"spread of the towing points", {Where::node, held[0]}, {Where::node, held[1]}});
}

std::string name_aboard(const StoredBody& body) {
  for (const char* side : {"port-", "starboard-"})
    if (body.name.starts_with(side)) return body.name.substr(std::string(side).size());
  return body.name;
}

/// Adds the spread of every pair of bodies: between the port and the starboard body of a whole gear, or
/// between the body of a half gear and its mirror image.
void add_body_spreads(const StoredShape& stored, std::vector<Dimension>& all) {
  for (const auto& body : stored.bodies) {
    if (body.is_to_port) continue;
    const DimensionEnd starboard{Where::node, body.origin};
    const std::string name = principal_name("pairs/" + name_aboard(body) + "/spread");
    if (stored.result.is_half()) all.push_back({name, {Where::mirrored, body.origin}, starboard});
    for (const auto& other : stored.bodies)
      if (other.is_to_port && name_aboard(other) == name_aboard(body))
        all.push_back({name, {Where::node, other.origin}, starboard});
  }
}

void add_mouth(const StoredShape& stored, std::vector<Dimension>& all) {
  if (!stored.result.gear) return;
  const auto headline = nodes_of_rope(stored, stored.result.gear->headline),
             footrope = nodes_of_rope(stored, stored.result.gear->footrope);
  if (headline.empty()) return;
  const DimensionEnd top{Where::node, middle_of(headline, stored.result.is_half())};
  if (stored.bed)
    all.push_back({principal_name("mouth/headline_height"), top, {Where::bed, 0}});
  else if (!footrope.empty())
    all.push_back({principal_name("mouth/headline_height"),
                   top,
                   {Where::node, middle_of(footrope, stored.result.is_half())}});
  all.push_back(spread_of(principal_name("mouth/upper_wing_spread"), headline, stored.result.is_half()));
  if (!footrope.empty())
    all.push_back(spread_of(principal_name("mouth/lower_wing_spread"), footrope, stored.result.is_half()));
}

}  // namespace

std::vector<Dimension> dimensions_of(const StoredShape& stored) {
  std::vector<Dimension> all;
  add_mouth(stored, all);
  add_body_spreads(stored, all);
  if (!all.empty() && ships_of(stored, 0).empty()) add_towing_spread(stored, all);
  return all;
}

std::array<double, 3> place_of(const DimensionEnd& end, const StoredShape& stored,
                               const std::vector<double>& points, const std::array<double, 3>& other) {
  if (end.where == Where::bed && stored.bed)
    return {other[0], other[1], stored.bed->height(other[0], other[1])};
  const std::size_t at = 3 * std::size_t{end.node};
  return {points[at], (end.where == Where::mirrored ? -1 : 1) * points[at + 1], points[at + 2]};
}

}  // namespace netloft::results
