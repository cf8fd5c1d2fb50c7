// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of towing: angles and loads of warps, and what towing costs.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

namespace {

constexpr double kHeatOfDiesel = 42.7e6;  // lower heating value [J/kg], ISO 15550

/// Unit vector along the outermost bar of a rope at one end, pointing away from this end.
Vector direction(const GearView& gear, std::uint32_t rope, bool from_start) {
  const auto& nodes = gear.nodes_of(rope);
  const std::size_t n = nodes.size();
  const Vector way =
      from_start ? gear.at(nodes[1]) - gear.at(nodes[0]) : gear.at(nodes[n - 2]) - gear.at(nodes[n - 1]);
  return (1 / norm(way)) * way;
}

/// The force in a rope at its start [N]. T are the tensions at the middles of its bars [N], l the lengths of
/// the bars [m]. Because the tension of a warp changes evenly, it is extrapolated linearly from the first two
/// bars.
Vector force_at_start(const GearView& gear, std::uint32_t rope, const std::vector<double>& T,
                      const std::vector<double>& l) {
  const Vector first = T[0] * direction(gear, rope, true);
  if (T.size() < 2) return first;
  const auto& nodes = gear.nodes_of(rope);
  const Vector way = gear.at(nodes[2]) - gear.at(nodes[1]);
  return first + (l[0] / (l[0] + l[1])) * (first - (T[1] / norm(way)) * way);
}

/// Adds the length of a warp and its angles at both ends. Adds the load on its block to `pull`.
void add_warp(const GearView& gear, std::uint32_t rope, Vector& pull, std::vector<Figure>& figures) {
  const auto tensions = gear.tensions(rope);
  if (tensions.empty()) return;
  const auto lengths = gear.rest_lengths(rope);
  const Vector at_block = force_at_start(gear, rope, tensions, lengths),
               at_end = direction(gear, rope, false);
  const std::string own = "warps/" + gear.name(rope) + "/";
  figures.push_back({own + "length", "m", "unstretched length of the warp",
                     std::accumulate(lengths.begin(), lengths.end(), 0.0)});
  figures.push_back({own + "down_at_start", "rad", "angle below the horizontal at the start of the warp",
                     std::asin(-at_block.z / norm(at_block))});
  figures.push_back({own + "out_at_start", "rad",
                     "angle between warp and tow at the start of the warp, seen from above",
                     std::abs(std::atan2(at_block.y, at_block.x))});
  figures.push_back(
      {own + "up_at_end", "rad", "angle above the horizontal at the end of the warp", std::asin(at_end.z)});
  pull += at_block;
}

bool has(const std::vector<std::uint32_t>& parts, std::uint32_t part) {
  return std::ranges::find(parts, part) != parts.end();
}

/// The group under which the power for towing a part is reported.
std::string group_of(const GearView& gear, std::uint32_t part) {
  const scenes::GearInScene& g = gear.gear();
  if (has(g.panels, part)) return "netting";
  if (const auto warps = g.roles.find("warp"); warps != g.roles.end() && has(warps->second, part))
    return "warps";
  if (has(g.ropes, part)) return "ropes";
  if (has(g.pieces, part)) return "floats";
  if (std::ranges::any_of(gear.loaded().bodies, [&](const auto& b) { return b.part == part; }))
    return "bodies";
  return gear.output(part, output::kNormalForce).empty() ? "others" : "ground";
}

/// Adds the power for towing each group: the aft force of water, ground and other external loads, times the
/// speed. Forces between elements cancel in the sum.
void add_power(const GearView& gear, std::vector<Figure>& figures) {
  static constexpr std::pair<const char*, const char*> groups[] = {
      {"netting", "towing the netting"},
      {"ropes", "towing ropes other than warps"},
      {"floats", "towing floats and weights"},
      {"bodies", "towing boards and other bodies through the water"},
      {"warps", "towing the warps"},
      {"ground", "friction and slope of the ground"},
      {"others", "towing everything else, such as a catch"}};
  std::map<std::string, double> forces;
  const auto& parts = gear.loaded().scene.parts;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (!parts[p].companion)
      forces[group_of(gear, p)] += gear.force(parts[p].name, [](const PartForce&) { return true; }).x;
  for (const auto& [name, doc] : groups)
    if (const auto at = forces.find(name); at != forces.end())
      figures.push_back({"power/" + std::string(name), "W", std::string("power that goes into ") + doc,
                         gear.times() * gear.gear().ship_speed * at->second});
}

/// The value of a figure that has been added already; 0 if there is none.
double value_of(const std::vector<Figure>& figures, std::string_view name) {
  const auto at = std::ranges::find(figures, name, &Figure::name);
  return at == figures.end() ? 0 : at->value;
}

void add_cost(const GearView& gear, const Vector& pull, std::vector<Figure>& figures) {
  const scenes::GearInScene& g = gear.gear();
  const double force = gear.times() * pull.x, power = force * g.ship_speed;
  figures.push_back({"towing/pull", "N", "force with which the ship pulls forwards", force});
  figures.push_back({"towing/power", "W", "pull of the ship times its speed over the ground", power});
  add_power(gear, figures);
  if (!(g.ship_efficiency > 0)) return;
  const double burnt = power / (g.ship_efficiency * kHeatOfDiesel);
  figures.push_back(
      {"towing/fuel", "kg/s", "diesel for the towing power, at the efficiency of the ship", burnt});
  for (const auto& [name, at, doc] : {std::tuple{"mouth/lower_wing_spread", "towing/fuel_per_area",
                                                 "diesel per area swept between the wing ends"},
                                      std::tuple{"pairs/door/spread", "towing/fuel_per_area_of_boards",
                                                 "diesel per area swept between the boards"}})
    if (const double width = value_of(figures, name); width > 0)
      figures.push_back({at, "kg/m2", doc, burnt / (width * g.ship_speed)});
}

}  // namespace

void add_towing_figures(const GearView& gear, std::vector<Figure>& figures) {
  const auto warps = gear.gear().roles.find("warp");
  if (warps == gear.gear().roles.end()) return;
  Vector pull;
  for (const auto rope : warps->second) add_warp(gear, rope, pull, figures);
  if (gear.gear().ship_speed > 0) add_cost(gear, pull, figures);
}

}  // namespace netloft::results
