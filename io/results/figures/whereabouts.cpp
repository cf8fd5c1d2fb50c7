// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/whereabouts.hpp"

#include "framework/registry/element_outputs.hpp"
#include "io/results/figures/gear_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace netloft::results {

namespace {

// A position is reported if it is above the surface or below the bed by more than this [m]. In gears of the
// library, netting without contact elements reaches up to 0.31 m below the bed. Mistakes cause larger values:
// a float whose line is 2 m longer than the water depth is 2 m in the air; a wrong depth gives even more.
constexpr double kClearly = 0.5;

/// The part that is farthest beyond a limit (surface or bed), and the number of parts beyond this limit.
struct Beyond {
  double most = kClearly;
  std::string part;
  std::size_t parts = 0;

  void add(const std::string& name, double by) {
    if (!(by > kClearly)) return;
    ++parts;
    if (by > most || part.empty()) {
      most = by;
      part = name;
    }
  }
  /// The beginning of a sentence, with subject and verb: "top-wing and 3 more parts lie".
  std::string who() const {
    return parts == 1 ? part + " lies"
                      : fmt::format("{} and {} more part{} lie", part, parts - 1, parts == 2 ? "" : "s");
  }
};

class Whereabouts {
 public:
  Whereabouts(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer)
      : loaded_(loaded), assembler_(assembler), answer_(answer), x_(assembler.node_positions(answer.x)) {}

  std::vector<std::string> sentences() {
    std::vector<std::string> all;
    if (const Beyond dry = above_surface(); dry.parts > 0)
      all.push_back(fmt::format(
          "{} up to {:.3g} m above the surface, z = 0, but the model has water there, too: give depths as "
          "negative z, or give ropes and netting surface = 1, so that the water ends at z = 0",
          dry.who(), dry.most));
    if (const Beyond sunk = below_bed(); sunk.parts > 0)
      all.push_back(fmt::format("{} up to {:.3g} m below the bed", sunk.who(), sunk.most));
    add_flying(all);
    return all;
  }

 private:
  const Part& part(std::uint32_t p) const { return loaded_.scene.parts[p]; }
  double z(std::uint32_t node) const { return x_[3 * std::size_t{node} + 2]; }
  double above_bed(std::uint32_t node) const {
    const double* at = &x_[3 * std::size_t{node}];
    return at[2] - loaded_.scene.bed.at(at[0], at[1])[0];
  }

  /// Parts whose elements have drag or buoyancy even above the surface, because they do not know where the
  /// surface is. Leaves out warps.
  std::set<std::string> feel_water_anywhere() const {
    std::set<std::string> feel, know_surface;
    for (const auto& f : answer_.forces) {
      const bool is_of_current = f.is_drag() && (f.traits & NETLOFT_READS_CURRENT);
      if (is_of_current && f.force != std::array<double, 3>{}) feel.insert(f.part);
      if (f.is_weight() && f.force[2] > 0) feel.insert(f.part);
      if (f.traits & NETLOFT_READS_WAVES) know_surface.insert(f.part);
    }
    for (const auto& name : know_surface) feel.erase(name);
    if (loaded_.gear)
      if (const auto warps = loaded_.gear->roles.find("warp"); warps != loaded_.gear->roles.end())
        for (const auto p : warps->second) feel.erase(part(p).name);
    return feel;
  }

  Beyond above_surface() const {
    Beyond dry;
    const auto feel = feel_water_anywhere();
    for (const auto& p : loaded_.scene.parts) {
      double highest = 0;
      if (feel.contains(p.name))
        for (const auto node : p.nodes) highest = std::max(highest, z(node));
      dry.add(p.name, highest);
    }
    return dry;
  }

  Beyond below_bed() const {
    Beyond sunk;
    if (!loaded_.scene.bed.is_there) return sunk;
    for (const auto& p : loaded_.scene.parts) {
      double deepest = 0;
      for (const auto node : p.nodes) deepest = std::max(deepest, -above_bed(node));
      sunk.add(p.name, deepest);
    }
    return sunk;
  }

  /// The contact of a part that can rest on the bed: the sum of its normal forces [N], and the height of its
  /// lowest node above the bed [m].
  struct Resting {
    double force = 0, above = std::numeric_limits<double>::infinity();
  };

  std::map<std::uint32_t, Resting> resting_parts() const {
    std::map<std::uint32_t, Resting> all;
    for (std::size_t f = 0; f < answer_.outputs.size(); ++f) {
      const ElementFamily& family = *assembler_.families()[f];
      for (std::size_t k = 0; k < family.type().outputs.size(); ++k) {
        if (!is_output(family.type().outputs[k], output::kNormalForce)) continue;
        for (std::size_t e = 0; e < family.size(); ++e)
          all[family.part(e)].force += std::max(0.0, answer_.outputs[f][k][e]);
      }
    }
    for (auto& [p, resting] : all)
      for (const auto node : part(p).nodes) resting.above = std::min(resting.above, above_bed(node));
    return all;
  }

  void add_flying(std::vector<std::string>& all) const {
    if (!loaded_.scene.bed.is_there) return;
    const auto resting = resting_parts();
    if (resting.empty()) return;
    const bool none_rests = std::ranges::all_of(resting, [](const auto& r) { return r.second.force == 0; });
    const auto lowest = std::ranges::min_element(
        resting, [](const auto& a, const auto& b) { return a.second.above < b.second.above; });
    if (none_rests)
      return all.push_back(fmt::format(
          "nothing rests on the bed: {}, the lowest part that could, is {:.3g} m above the bed; {}",
          part(lowest->first).name, lowest->second.above, why_it_flies()));
    for (const auto& [p, one] : resting)
      if (one.force == 0 && stands_on_footrope(p))
        all.push_back(fmt::format("{} rests nowhere on the bed; its lowest point is {:.3g} m above it",
                                  loaded_.gear->footrope, one.above));
  }

  /// Explains why a gear does not touch the bottom: it floats, or its warps are too short.
  std::string why_it_flies() const {
    const double up = net_buoyancy();
    std::string why =
        fmt::format("the net buoyancy of the gear is {:.4g} N, {}", up,
                    up > 0 ? "upward: the gear floats" : "downward: the gear is heavier than water");
    if (!loaded_.gear) return why;
    const auto warps = loaded_.gear->roles.find("warp");
    if (warps == loaded_.gear->roles.end() || warps->second.empty()) return why;
    const auto [length, depth] = longest(warps->second);
    return why + fmt::format("; the longest warp is {:.4g} m, and its start is {:.4g} m above the bed{}",
                             length, depth, length < depth ? ": the warp cannot reach the bed" : "");
  }

  /// Buoyancy minus weight of all parts except warps [N]: positive if the gear floats.
  double net_buoyancy() const {
    double up = 0;
    for (const auto& f : answer_.forces)
      if (f.is_weight() && !is_warp(f.part)) up += f.force[2];
    return loaded_.gear ? loaded_.gear->times * up : up;
  }

  bool is_warp(const std::string& name) const {
    if (!loaded_.gear) return false;
    const auto warps = loaded_.gear->roles.find("warp");
    return warps != loaded_.gear->roles.end() &&
           std::ranges::any_of(warps->second, [&](auto p) { return part(p).name == name; });
  }

  /// The longest of some ropes: its unstretched length, and the height of its start above the bed [m].
  std::pair<double, double> longest(const std::vector<std::uint32_t>& ropes) const {
    const GearView gear(loaded_, assembler_, answer_);
    std::pair<double, double> most{0, 0};
    for (const auto rope : ropes) {
      const auto lengths = gear.rest_lengths(rope);
      const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
      if (length > most.first) most = {length, above_bed(gear.nodes_of(rope).front())};
    }
    return most;
  }

  /// Whether all nodes of a part belong to the footrope, as for a part that models the contact of the
  /// footrope.
  bool stands_on_footrope(std::uint32_t p) const {
    if (!loaded_.gear) return false;
    for (const auto& rope : loaded_.scene.parts)
      if (rope.name == loaded_.gear->footrope) {
        const std::set<std::uint32_t> nodes(rope.nodes.begin(), rope.nodes.end());
        return std::ranges::all_of(part(p).nodes, [&](auto node) { return nodes.contains(node); });
      }
    return false;
  }

  const scenes::LoadedScene& loaded_;
  const Assembler& assembler_;
  const Response& answer_;
  std::vector<double> x_;
};

}  // namespace

std::vector<std::string> whereabouts_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                              const Response& answer) {
  return Whereabouts(loaded, assembler, answer).sentences();
}

}  // namespace netloft::results
