// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/gear_model.hpp"

#include "io/formats/units/in_quotes.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/parameter_reader.hpp"
#include "io/scenes/reading/part_names.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

constexpr double kMostFiner = 100;
constexpr std::int64_t kFewestNodes = 20;

/// Whether the scene says `nodes = "knots"`: every knot is a node, and no other key may set the fineness of
/// the mesh.
bool wants_knots(formats::TableReader& table) {
  const formats::Value* nodes = table.kind("nodes") == formats::Kind::text ? table.raw("nodes") : nullptr;
  return nodes && *nodes->as<std::string>() == kKnots;
}

/// Reads the keys of `[gear]`, but not `nodes` if `knots`, because its value is then a word.
Values read_gear_keys(formats::TableReader& table, bool knots) {
  std::vector<netloft_parameter> keys(gear_keys().begin(), gear_keys().end());
  if (knots) std::erase_if(keys, [](const auto& key) { return std::string_view(key.name) == "nodes"; });
  return read_parameters(keys, table);
}

/// Reports an error if the scene states both `nodes` and `size`, because each of them sets the fineness of
/// the mesh, or if the number of nodes is out of range.
void check_fineness(const GearKeys& keys, formats::TableReader& table) {
  if (keys.size > 0 && table.has("nodes") && keys.nodes > 0)
    table.error("size", "is given beside nodes, and each of them says how fine the mesh is",
                "leave one of them out: with nodes = 0 only size counts, with size = 0 only nodes");
  if (keys.nodes < kFewestNodes && !(keys.nodes == 0 && keys.size > 0))
    table.error("nodes", "= " + std::to_string(keys.nodes) + " is outside [20, 1000000]",
                "nodes = 0 is possible only with a size");
}

void check_knots(formats::TableReader& gear) {
  for (const char* key : {"size", "finer"})
    if (gear.has(key))
      gear.error(key, "is given beside nodes = \"knots\", which already says how fine the mesh is",
                 "leave one of them out");
}

/// Reports an error if half a gear is requested but the plan differs between port and starboard.
void check_halves(const gears::NetPlan& plan, formats::TableReader& table) {
  for (const auto& body : plan.bodies)
    if (body.stands != gears::Standing::pair)
      table.error(
          "extent",
          "the gear is modelled as half, but the body " + formats::in_quotes(body.name) + " exists only once",
          "set extent = \"whole\", because half a body cannot be modelled");
  if (plan.ship)
    for (const auto& moment : plan.ship->path)
      if (moment.heading != 0) {
        table.error("extent", "the gear is modelled as half, but the ship turns",
                    "set extent = \"whole\", or leave out ship.path.heading");
        break;
      }
  if (plan.ship && !plan.ship->path_port.empty())
    table.error("extent", "the gear is modelled as half, but two ships tow it on different paths",
                "set extent = \"whole\", or leave out ship.path_port");
  for (const auto& rope : plan.ropes)
    if (rope.length_port.value_or(rope.length) != rope.length)
      table.error("extent",
                  "the gear is modelled as half, but the plan gives " + formats::in_quotes(rope.name) +
                      " a different length to port",
                  "set extent = \"whole\", or leave out length_port");
  for (const auto& rope : plan.ropes)
    if (rope.tension_port.value_or(rope.tension.value_or(0)) != rope.tension.value_or(0))
      table.error("extent",
                  "the gear is modelled as half, but the plan gives " + formats::in_quotes(rope.name) +
                      " a different tension to port",
                  "set extent = \"whole\", or leave out tension_port");
}

/// Reads `finer = { top-codend = 2 }`: factors by which the mesh of single panels and ropes is finer.
void read_finer(formats::TableReader& table, const gears::Gear& gear, gears::Fineness& fineness) {
  formats::TableReader finer = table.table("finer", formats::Presence::optional);
  std::vector<std::string> names;
  for (const auto& panel : gear.panels) names.push_back(panel.name);
  for (const auto& rope : gear.ropes) names.push_back(rope.name);
  for (const auto& name : finer.keys()) {
    const double times =
        finer.real(name, {.unit = "1",
                          .doc = "factor by which the sides of triangles, or the bars, are shorter",
                          .range = formats::between(1 / kMostFiner, kMostFiner)});
    const auto meant = meant_by(name, names);
    if (meant.empty())
      finer.error(name, "there is no panel or rope " + formats::in_quotes(name), name_hint(name, names));
    for (const auto& one : meant)
      if (one == name || !finer.has(one)) fineness.finer[one] = times;
  }
}

}  // namespace

std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names) {
  const auto is_there = [&](const std::string& one) { return std::ranges::find(names, one) != names.end(); };
  if (is_there(name)) return {name};
  const std::string starboard = "starboard-" + name, port = "port-" + name;
  return is_there(starboard) && is_there(port) ? std::vector{starboard, port} : std::vector<std::string>{};
}

std::optional<GearModel> read_gear_model(const gears::NetPlan& plan, formats::TableReader& root) {
  formats::TableReader table = root.table("gear", formats::Presence::optional);
  GearModel model;
  model.fineness.knots = wants_knots(table);
  const Values values = read_gear_keys(table, model.fineness.knots);
  std::vector<std::string> faults;
  const ParameterBlock block(gear_keys(), sizeof(GearKeys), values, faults);
  if (!faults.empty()) return std::nullopt;
  const auto& keys = *static_cast<const GearKeys*>(block.data());
  model.fineness.knots ? check_knots(table) : check_fineness(keys, table);
  model.gear = gears::make_gear(plan, keys.extent == 1 ? gears::Extent::half : gears::Extent::whole);
  model.fineness.nodes = static_cast<std::size_t>(keys.nodes);
  model.fineness.size = keys.size;
  read_finer(table, model.gear, model.fineness);
  if (model.gear.extent == gears::Extent::half) check_halves(plan, table);
  return model;
}

}  // namespace netloft::scenes
