// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/halves.hpp"

#include "io/formats/units/in_metres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace netloft::scenes {

namespace {

// A node is beyond the plane of symmetry if its distance from the plane exceeds this fraction of the breadth
// of the gear. In converged solutions, nodes were beyond the plane by up to 5e-10 of the breadth; in crossed
// gears, by 0.1.
constexpr double kRounding = 1e-6;
constexpr std::size_t kMostNames = 5;

struct Beyond {
  std::uint32_t part;
  double by;  // distance beyond the plane [m]
  bool is_held;
};

bool is_held_across(const Scene& scene, std::uint32_t node) {
  return (scene.held[node] & kAxisY) && (scene.carried.empty() || !scene.carried[node]);
}

std::vector<Beyond> find_beyond(const LoadedScene& loaded, std::span<const double> positions) {
  double breadth = 0;
  for (std::size_t i = 1; i < positions.size(); i += 3) breadth = std::max(breadth, std::abs(positions[i]));
  std::vector<Beyond> all;
  for (std::uint32_t p = 0; p < loaded.parts.size(); ++p) {
    Beyond part{p, kRounding * breadth, false};
    for (const auto node : loaded.parts[p].nodes) {
      const double by = -positions[3 * std::size_t{node} + 1];
      if (by > kRounding * breadth) part.is_held |= is_held_across(loaded.scene, node);
      part.by = std::max(part.by, by);
    }
    if (part.by > kRounding * breadth) all.push_back(part);
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.by > b.by; });
  return all;
}

/// Names in a sentence: "a", "a and b", "a, b and 7 more".
std::string list_names(const LoadedScene& loaded, const std::vector<Beyond>& parts) {
  const std::size_t named = parts.size() > kMostNames ? kMostNames - 1 : parts.size();
  std::string names;
  for (std::size_t i = 0; i < named; ++i)
    names += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + loaded.scene.parts[parts[i].part].name;
  if (named < parts.size()) names += " and " + std::to_string(parts.size() - named) + " more";
  return names;
}

/// The horizontal unit vector to starboard, normal to the flow at height z; nullopt if the flow comes from
/// behind the drawn gear, so that the gear turns round.
std::optional<std::array<double, 2>> starboard_at(const Scene& scene, double z) {
  std::array<double, 3> v{}, dz{};
  scene.current.at(z, v, dz);
  const double speed = std::hypot(v[0], v[1]);
  if (v[0] < 0) return {};
  if (speed == 0) return std::array<double, 2>{0, 1};
  return std::array<double, 2>{-v[1] / speed, v[0] / speed};
}

/// Adds the crossings of pairs of bodies in a whole gear. Each body is compared with the other body of its
/// pair, not with the plane, because the gear may be towed askew.
void add_pairs(const LoadedScene& loaded, std::span<const double> positions,
               std::vector<Crossing>& crossings) {
  for (const auto& [name, parts] : loaded.gear->pairs) {
    std::array<const RigidBody*, 2> bodies{};  // the port body, the starboard body
    for (const auto part : parts)
      for (std::size_t b = 0; b < loaded.bodies.size(); ++b)
        if (loaded.bodies[b].part == part) bodies[loaded.bodies[b].side > 0] = &loaded.scene.bodies[b];
    if (!bodies[0] || !bodies[1]) continue;
    const double *port = &positions[3 * std::size_t{bodies[0]->origin}],
                 *starboard = &positions[3 * std::size_t{bodies[1]->origin}];
    const auto out = starboard_at(loaded.scene, starboard[2]);
    if (!out) continue;
    const double apart = (*out)[0] * (starboard[0] - port[0]) + (*out)[1] * (starboard[1] - port[1]);
    if (apart < 0)
      crossings.push_back({parts[0], false,
                           bodies[1]->name + " is " + formats::in_metres(-apart, 3) + " to port of " +
                               bodies[0]->name + ": they have crossed"});
  }
}

}  // namespace

std::vector<Crossing> find_crossings(const LoadedScene& loaded, std::span<const double> positions) {
  std::vector<Crossing> crossings;
  if (!loaded.gear) return crossings;
  if (loaded.gear->times != 2) {
    add_pairs(loaded, positions, crossings);
    return crossings;
  }
  const auto beyond = find_beyond(loaded, positions);
  if (beyond.empty()) return crossings;
  const bool is_held = std::any_of(beyond.begin(), beyond.end(), [](const auto& b) { return b.is_held; });
  crossings.push_back({beyond[0].part, is_held,
                       list_names(loaded, beyond) + (beyond.size() == 1 ? " lies " : " lie up to ") +
                           formats::in_metres(beyond[0].by, 3) +
                           " beyond the plane of symmetry, y = 0: the half to starboard and its mirror image "
                           "have crossed"});
  return crossings;
}

}  // namespace netloft::scenes
