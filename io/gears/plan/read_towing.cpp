// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/part_choice.hpp"
#include "io/gears/catalogue/part_kinds.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/plan_reader.hpp"
#include "io/gears/plan/table_in_time.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

constexpr const char* kPoints = "points";

/// The points in the table `points` of a body or of a catalogue part; an empty list if `points` is no table.
std::vector<BodyPoint> points_in(const formats::Value* points) {
  std::vector<BodyPoint> all;
  if (!points || !points->as<formats::Table>()) return all;
  formats::Diagnostics silent;  // the scene that reads the body reports its errors
  formats::TableReader table(*points, silent);
  for (const auto& name : table.keys()) {
    const auto at = table.reals(name, {.unit = "m", .range = formats::between(-1e6, 1e6)});
    all.push_back({name, at.size() == 3 ? at[1] : 0});
  }
  return all;
}

const formats::Value* points_of_catalogue(formats::TableReader& table, const Catalogue& catalogue) {
  formats::Diagnostics silent;  // the scene that reads the body reports its errors
  for (const auto& key : part_keys()) {
    const formats::Value* said = table.has(key) ? table.raw(key) : nullptr;
    if (!said || !names_a_part(*said)) continue;
    const CataloguePart* part = choose_part(*said, kinds_under(key), key, catalogue, silent);
    const auto points =
        part ? part->tables.find(kPoints) : std::map<std::string, formats::Value>::const_iterator{};
    if (part && points != part->tables.end()) return &points->second;
  }
  return nullptr;
}

/// The point to which warps lead: by default the point named `warp`, if exactly one body has such a point.
/// Returns an empty text after an error.
std::string end_of_warp(const NetPlan& plan, formats::TableReader& warp) {
  if (warp.has("to")) return warp.text("to", {.doc = "point to which the warp leads, such as \"door.warp\""});
  std::vector<std::string> ends;
  for (const auto& body : plan.bodies)
    for (const auto& point : body.points)
      if (point.name == kWarp) ends.push_back(body.name + "." + point.name);
  if (ends.size() == 1) return ends[0];
  warp.error("to",
             ends.empty() ? "is missing, and no body has a point \"warp\""
                          : "is missing, and more than one body has a point \"warp\"",
             "give the point to which the warp leads, such as \"door.warp\"");
  return {};
}

std::vector<ShipMoment> read_path(formats::TableReader& path, double speed) {
  const auto t = read_times(path);
  const auto speeds =
      read_column(path, "speed",
                  {.unit = "m/s",
                   .doc = "speed over the ground",
                   .range = formats::between(0, 50),
                   .count = formats::exactly(t.size())},
                  speed, "ship.speed, the speed at which the gear is towed before this path begins");
  const auto headings = read_column(path, "heading",
                                    {.unit = "rad",
                                     .doc = "heading relative to that of the tow, positive to starboard",
                                     .range = formats::between(-100, 100),
                                     .count = formats::exactly(t.size())},
                                    0, "0, the heading of the tow");
  std::vector<ShipMoment> moments;
  for (std::size_t i = 0; i < t.size(); ++i) moments.push_back({t[i], speeds[i], headings[i]});
  return moments;
}

const formats::RealSpec kTension{
    .unit = "N", .doc = "tension at the block, held by the winch", .range = {0, 1e9, true}};

Rope read_warp(const NetPlan& plan, formats::TableReader& warp, const Catalogue& catalogue) {
  Rope rope;
  rope.name = rope.role = kWarp;
  rope.place = rope.role_place = warp.place();
  rope.stands = Standing::pair;
  ChosenPart part = read_part_choice(warp, "rope", "rope", catalogue);
  rope.part_name = std::move(part.name);
  rope.rope = std::move(part.table);
  const formats::RealSpec length{
      .unit = "m", .doc = "length of warp from the block", .range = {0, 1e5, true}};
  rope.length = warp.real("length", length);
  if (warp.has("length_port")) rope.length_port = warp.real("length_port", length);
  rope.tension_place = warp.place("tension");
  if (warp.has("tension")) rope.tension = warp.real("tension", kTension);
  if (warp.has("tension_port")) {
    rope.tension_port = warp.real("tension_port", kTension);
    if (!warp.has("tension"))
      warp.error("tension_port", "is given without a tension of the starboard warp",
                 "give tension beside tension_port, or only tension for both warps");
  }
  if (warp.has("winch")) read_winch(warp, rope);
  rope.between = {kBlock, end_of_warp(plan, warp)};
  rope.between_place = warp.place(warp.has("to") ? "to" : "length");
  return rope;
}

}  // namespace

PlanBody read_plan_body(const std::string& name, formats::TableReader& table, const Catalogue& catalogue) {
  PlanBody body;
  body.name = name;
  body.place = table.place();
  body.stands = read_standing(table, "pair");
  const formats::Value* own = table.has(kPoints) ? table.raw(kPoints) : nullptr;
  body.points = points_in(own ? own : points_of_catalogue(table, catalogue));
  if (table.kind("rim") == formats::Kind::table) {
    formats::Diagnostics silent;  // the scene that reads the body reports its errors
    formats::TableReader rim(*table.raw("rim"), silent);
    body.rim = rim.text("edge", {});
    body.rim_place = rim.place("edge");
  }
  for (const auto& key : table.keys()) table.raw(key);  // known, because the scene reads them
  return body;
}

void add_ship(NetPlan& plan, formats::TableReader& table, const Catalogue& catalogue) {
  Ship ship;
  ship.place = table.place();
  ship.speed_place = table.place("speed");
  ship.speed =
      table.real("speed", {.unit = "m/s", .doc = "speed over the ground", .range = formats::between(0, 50)});
  if (table.has("efficiency"))
    ship.efficiency = table.real(
        "efficiency",
        {.unit = "1", .doc = "towing power divided by the heating power of the fuel", .range = {0, 1, true}});
  if (table.has("path")) {
    formats::TableReader path = table.table("path");
    ship.path = read_path(path, ship.speed);
    ship.path_place = path.place();
  }
  if (table.has("path_port")) {
    formats::TableReader path = table.table("path_port");
    ship.path_port = read_path(path, ship.speed);
    if (ship.path.empty())
      table.error("path_port", "is given without a path of the starboard ship",
                  "give path, that of the starboard ship, beside path_port");
  }
  formats::TableReader block = table.table(kBlock, formats::Presence::optional), warp = table.table(kWarp);
  ship.block_height = block.real("height", {.unit = "m",
                                            .doc = "height of the blocks above the water",
                                            .range = formats::between(-100, 100),
                                            .fallback = 4.0});
  ship.block_gap = block.real("gap", {.unit = "m",
                                      .doc = "distance between the blocks to port and to starboard",
                                      .range = formats::between(0, 2000),
                                      .fallback = 6.0});
  if (!ship.path_port.empty() && ship.block_gap == 0)
    table.error("path_port", "needs a block to port, but both blocks are in the middle",
                "give the distance between the blocks, such as block = { gap = \"6 m\" }");
  plan.points.push_back(
      {kBlock, Standing::pair, {{0, ship.block_gap / 2, ship.block_height}}, block.place()});
  if (table.diagnostics().errors() == 0 || table.kind(kWarp) == formats::Kind::table)
    plan.ropes.push_back(read_warp(plan, warp, catalogue));
  plan.ship = ship;
}

}  // namespace netloft::gears
