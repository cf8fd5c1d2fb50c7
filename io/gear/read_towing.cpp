// SPDX-License-Identifier: BSD-3-Clause
#include "io/catalogue/part_choice.hpp"
#include "io/catalogue/part_kinds.hpp"
#include "io/gear/names.hpp"
#include "io/gear/plan_reader.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

constexpr const char* kPoints = "points";

/// Names in the table `points` of a body, or of the part of a catalogue that it names under `key`.
std::vector<std::string> names_in(const Table* points) {
  std::vector<std::string> names;
  if (points)
    for (const auto& member : points->members) names.push_back(member.key);
  return names;
}

const Table* points_of_catalogue(TableReader& table, const Catalogue& catalogue) {
  Diagnostics silent;  // the scene that reads the body says what is wrong with it
  for (const auto& key : part_keys()) {
    const Value* said = table.has(key) ? table.raw(key) : nullptr;
    if (!said || !names_a_part(*said)) continue;
    const CataloguePart* part = choose_part(*said, kinds_under(key), key, catalogue, silent);
    const auto points = part ? part->tables.find(kPoints) : std::map<std::string, Value>::const_iterator{};
    if (part && points != part->tables.end()) return points->second.as<Table>();
  }
  return nullptr;
}

/// The point that warps lead to: the one point `warp` of the bodies, if nothing is said.
std::string end_of_warp(const NetPlan& plan, TableReader& warp) {
  if (warp.has("to")) return warp.text("to", {.doc = "the point that it leads to, such as \"door.warp\""});
  std::vector<std::string> ends;
  for (const auto& body : plan.bodies)
    for (const auto& point : body.points)
      if (point == kWarp) ends.push_back(body.name + "." + point);
  if (ends.size() == 1) return ends[0];
  warp.error("to",
             ends.empty() ? "is missing, and no body has a point \"warp\""
                          : "is missing, and more than one body has a point \"warp\"",
             "the point that it leads to, such as \"door.warp\"");
  return {};
}

const Range kTimes{0, 1e9};

/// The column `t` of a table in time: from zero on, each later than the one before.
std::vector<double> read_times(TableReader& table) {
  const auto t = table.reals("t", {.unit = "s", .doc = "times", .range = kTimes, .count = {.least = 2}});
  if (!t.empty() && t[0] != 0) table.error("t", "does not begin at 0, where the gear is towed steadily");
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1])) {
      table.error("t", "does not ascend: each time must be later than the one before");
      break;
    }
  return t;
}

/// A column beside the times; `start` where it is left out, and what it has to begin with.
std::vector<double> read_column(TableReader& table, const std::string& key, const RealsSpec& spec,
                                double start, const std::string& why) {
  if (!table.has(key)) return std::vector<double>(spec.count.least, start);
  auto column = table.reals(key, spec);
  if (!column.empty() && std::abs(column[0] - start) > 1e-9 * (1 + std::abs(start)))
    table.error(key, "begins with another value than " + why);
  column.resize(spec.count.least, start);
  return column;
}

std::vector<ShipMoment> read_path(TableReader& path, double speed) {
  const auto t = read_times(path);
  const auto speeds = read_column(
      path, "speed",
      {.unit = "m/s", .doc = "over the ground", .range = between(0, 50), .count = exactly(t.size())}, speed,
      "ship.speed, with which the gear is towed until then");
  const auto headings = read_column(
      path, "heading",
      {.unit = "rad", .doc = "turned to starboard", .range = between(-100, 100), .count = exactly(t.size())},
      0, "0, the heading of the tow");
  std::vector<ShipMoment> moments;
  for (std::size_t i = 0; i < t.size(); ++i) moments.push_back({t[i], speeds[i], headings[i]});
  return moments;
}

constexpr int kPartsOfSpeedingUp = 8;  // straight lengths for one change of the speed of a winch

/// Lengths that speeds straight between times pay out.
void add_paid_out(const std::vector<double>& t, const std::vector<double>& v, Rope& warp) {
  warp.winch.push_back({0, 0});
  for (std::size_t i = 1; i < t.size(); ++i) {
    const int parts = v[i] == v[i - 1] ? 1 : kPartsOfSpeedingUp;
    const std::array<double, 2> from = warp.winch.back();
    for (int k = 1; k <= parts; ++k) {
      const double s = double(k) / parts, h = t[i] - t[i - 1];
      warp.winch.push_back({t[i - 1] + s * h, from[1] + h * s * (v[i - 1] + 0.5 * s * (v[i] - v[i - 1]))});
    }
  }
}

const RealSpec kTension{.unit = "N", .doc = "at the block, held by the winch", .range = {0, 1e9, true}};

/// One tension, or a row of them beside `t`; that of the warp at its start if it has one.
void read_tensions(TableReader& winch, const Rope& warp, HeldTension& held) {
  if (!winch.has("t")) {
    if (winch.has("tension")) held.tension.push_back({0, winch.real("tension", kTension)});
  } else if (const auto t = read_times(winch); !t.empty()) {
    const auto wanted = winch.reals(
        "tension", {.unit = "N", .doc = kTension.doc, .range = kTension.range, .count = exactly(t.size())});
    for (std::size_t i = 0; i < std::min(t.size(), wanted.size()); ++i)
      held.tension.push_back({t[i], wanted[i]});
  }
  if (held.tension.empty() || !warp.tension) return;
  if (std::abs(held.tension[0][1] - *warp.tension) > 1e-9 * *warp.tension)
    winch.error("tension", "begins with another value than warp.tension, with which the length is found");
  else if (warp.tension_port && held.tension.size() > 1)
    winch.error("tension", "is of both warps, and warp.tension_port differs", "leave out one of them");
}

/// `winch = { tension, max_speed, band, dead_band }`.
void read_held(TableReader& winch, Rope& warp) {
  HeldTension held;
  read_tensions(winch, warp, held);
  const double first = !held.tension.empty() ? held.tension[0][1] : warp.tension.value_or(0);
  held.max_speed = winch.real("max_speed", {.unit = "m/s",
                                            .doc = "at which it can pay out and haul",
                                            .range = {0, 50, true},
                                            .fallback = kWinchSpeed});
  held.band = winch.real("band", {.unit = "N",
                                  .doc = "deviation of the tension at which it runs at max_speed",
                                  .range = {0, 1e9, true},
                                  .fallback = kWinchBand * first});
  held.dead_band = winch.real("dead_band", {.unit = "N",
                                            .doc = "deviation of the tension at which it still stands",
                                            .range = {0, 1e9},
                                            .fallback = 0.0});
  warp.held = std::move(held);
}

/// `winch = { t, length }` or `{ t, speed }`, of both warps.
void read_lengths(TableReader& winch, Rope& warp) {
  const auto t = read_times(winch);
  if (winch.has("speed")) {
    const RealsSpec spec{.unit = "m/s",
                         .doc = "paying out; negative: hauling",
                         .range = between(-50, 50),
                         .count = exactly(t.size())};
    const auto v = winch.reals("speed", spec);
    if (v.size() == t.size()) add_paid_out(t, v, warp);
  } else {
    const auto lengths = read_column(
        winch, "length",
        {.unit = "m", .doc = "of warp that is out", .range = {0, 1e5, true}, .count = exactly(t.size())},
        warp.length, "warp.length, which is out at the start");
    for (std::size_t i = 0; i < t.size(); ++i) warp.winch.push_back({t[i], lengths[i] - warp.length});
  }
  const double shortest = std::min(warp.length, warp.length_port.value_or(warp.length));
  for (const auto& [time, more] : warp.winch)
    if (!(shortest + more > 0))
      return winch.error(winch.has("speed") ? "speed" : "length", "hauls more warp than there is");
}

void read_winch(TableReader& winch, Rope& warp) {
  warp.winch_place = winch.place();
  std::vector<const char*> given;
  for (const char* key : {"length", "speed", "tension"})
    if (winch.has(key)) given.push_back(key);
  if (given.size() > 1)
    return winch.error(given.back(), std::string("stands beside ") + given.front() +
                                         ", and either says how the winch runs; give one of them");
  const bool runs_by_tension = given.empty() ? warp.tension.has_value() : winch.has("tension");
  if (given.empty() && !runs_by_tension)
    return winch.error("length",
                       "is missing, and so are speed and tension: one of them says how the winch runs");
  if (runs_by_tension) return read_held(winch, warp);
  if (warp.tension)
    return winch.error(given.front(), "stands beside warp.tension, by which the length at the start is found",
                       "run it with the tension once, and write the length that it found");
  for (const char* key : {"max_speed", "band", "dead_band"})
    if (winch.has(key)) {
      winch.raw(key);
      winch.error(key, "is of a winch that holds a tension, and this one follows a table");
    }
  read_lengths(winch, warp);
}

Rope read_warp(const NetPlan& plan, TableReader& warp, const Catalogue& catalogue) {
  Rope rope;
  rope.name = rope.role = kWarp, rope.place = rope.role_place = warp.place();
  rope.stands = Standing::pair;
  ChosenPart part = read_part_choice(warp, "rope", "rope", catalogue);
  rope.part_name = std::move(part.name), rope.rope = std::move(part.table);
  const RealSpec length{.unit = "m", .doc = "from the block", .range = {0, 1e5, true}};
  rope.length = warp.real("length", length);
  if (warp.has("length_port")) rope.length_port = warp.real("length_port", length);
  rope.tension_place = warp.place("tension");
  if (warp.has("tension")) rope.tension = warp.real("tension", kTension);
  if (warp.has("tension_port")) {
    rope.tension_port = warp.real("tension_port", kTension);
    if (!warp.has("tension"))
      warp.error("tension_port", "stands alone; of the warp to starboard nothing is said",
                 "tension beside it, or tension alone for both");
  }
  if (warp.has("winch")) {
    TableReader winch = warp.table("winch");
    read_winch(winch, rope);
  }
  rope.between = {kBlock, end_of_warp(plan, warp)};
  rope.between_place = warp.place(warp.has("to") ? "to" : "length");
  return rope;
}

}  // namespace

PlanBody read_plan_body(const std::string& name, TableReader& table, const Catalogue& catalogue) {
  PlanBody body;
  body.name = name, body.place = table.place();
  body.stands = read_standing(table, "pair");
  const Value* own = table.has(kPoints) ? table.raw(kPoints) : nullptr;
  body.points = names_in(own ? own->as<Table>() : points_of_catalogue(table, catalogue));
  for (const auto& key : table.keys()) table.raw(key);  // the scene reads them
  return body;
}

void add_ship(NetPlan& plan, TableReader& table, const Catalogue& catalogue) {
  Ship ship;
  ship.place = table.place(), ship.speed_place = table.place("speed");
  ship.speed = table.real("speed", {.unit = "m/s", .doc = "over the ground", .range = between(0, 50)});
  if (table.has("efficiency"))
    ship.efficiency = table.real(
        "efficiency", {.unit = "1", .doc = "towing power over the heat of the fuel", .range = {0, 1, true}});
  if (table.has("path")) {
    TableReader path = table.table("path");
    ship.path = read_path(path, ship.speed), ship.path_place = path.place();
  }
  if (table.has("path_port")) {
    TableReader path = table.table("path_port");
    ship.path_port = read_path(path, ship.speed);
    if (ship.path.empty())
      table.error("path_port", "stands alone; of the ship to starboard nothing is said",
                  "path beside it, of the ship to starboard");
  }
  TableReader block = table.table(kBlock, Presence::optional), warp = table.table(kWarp);
  ship.block_height = block.real(
      "height",
      {.unit = "m", .doc = "of the blocks above the water", .range = between(-100, 100), .fallback = 4.0});
  ship.block_gap = block.real("gap", {.unit = "m",
                                      .doc = "between the blocks to port and to starboard",
                                      .range = between(0, 2000),
                                      .fallback = 6.0});
  if (!ship.path_port.empty() && ship.block_gap == 0)
    table.error("path_port", "has no block to port: both blocks stand in the middle",
                "block = { gap = \"6 m\" }, the distance between both");
  plan.points.push_back(
      {kBlock, Standing::pair, {{0, ship.block_gap / 2, ship.block_height}}, block.place()});
  if (table.diagnostics().errors() == 0 || table.kind(kWarp) == Kind::table)
    plan.ropes.push_back(read_warp(plan, warp, catalogue));
  plan.ship = ship;
}

}  // namespace netloft::io
