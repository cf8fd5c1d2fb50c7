// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/plugins.hpp"
#include "io/program/schema/part_schema.hpp"
#include "io/program/schema/schema_words.hpp"
#include "io/program/session/components.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/print.hpp"
#include "io/scenes/reading/analysis.hpp"
#include "io/scenes/reading/dynamics.hpp"
#include "io/scenes/reading/keys.hpp"

#include <limits>

namespace netloft::program {

using namespace schema;

namespace {

Json hold_schema() {
  Json hold = object();
  const Json name = text("what is held: a part, an edge or a point (net.fore)");
  put(hold, "on",
      {{"description", "what is held"},
       {"anyOf", {name, {{"type", "array"}, {"items", name}, {"minItems", 1}}}}},
      true);
  put(hold, "axes",
      {{"type", "string"}, {"pattern", "^[xyz]+$"}, {"description", "axes along which nodes cannot move"}},
      false);
  const Json direction = {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
  for (const auto& [key, doc] : {std::pair{"along", "direction of the line on which the nodes slide"},
                                 std::pair{"plane", "normal of the plane in which the nodes stay"}}) {
    Json own = direction;
    own["description"] = doc;
    put(hold, key, own, false);
  }
  put(hold, "at", {{"description", "\"sketch\", a point, or points of a line"}}, false);
  put(hold, "name", text("name of the reaction"), false);
  put(hold, "loose",
      {{"type", "boolean"},
       {"default", false},
       {"description",
        "true: the hold only keeps the gear from drifting, and bears no force in equilibrium"}},
      false);
  put(hold, "displacement",
      columns_schema("displacement of the held nodes from their initial position, over time",
                     {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"z", "m"}}),
      false);
  put(hold, "velocity",
      columns_schema("velocity of the held nodes, over time",
                     {{"t", "s"}, {"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"}}),
      false);
  return {{"type", "array"}, {"items", hold}};
}

Json join_schema() {
  Json join = object();
  put(join, "points",
      {{"type", "array"},
       {"items", {{"type", "string"}}},
       {"minItems", 1},
       {"description", "points or edges that are joined"}},
      false);
  put(join, "together", {{"type", "boolean"}, {"default", false}, {"description", "all nodes become one"}},
      false);
  put(join, "edges", {{"type", "array"}, {"minItems", 2}, {"description", "net plan: edges sewn together"}},
      false);
  put(join, "take_up",
      {{"type", Json::array({"number", "array"})},
       {"description", "net plan: meshes of each further edge for one of the first"}},
      false);
  join["anyOf"] = {{{"required", {"points"}}}, {{"required", {"edges"}}}};
  return {{"type", "array"}, {"items", join}};
}

/// The schema of a current: one velocity, or a profile over height.
Json current_schema() {
  const auto column = [](const std::string& unit, double limit, const std::string& doc) {
    return Json{{"type", "array"},
                {"items", quantity(unit, -limit, limit, doc)},
                {"minItems", 1},
                {"description", doc}};
  };
  Json profile = object();
  put(profile, "z", column("m", 2e4, "heights of the samples, 0 at the surface"), true);
  put(profile, "x", column("m/s", 50, "velocity along x at each z"), false);
  put(profile, "y", column("m/s", 50, "velocity along y at each z"), false);
  put(profile, "up", column("m/s", 50, "velocity upwards at each z"), false);
  put(profile, "t", column("s", 1e9, "times of the shares"), false);
  put(profile, "factor", column("1", 1e3, "factor on the profile at each t"), false);
  Json drift = columns_schema("velocity everywhere, over time",
                              {{"t", "s"}, {"x", "m/s"}, {"y", "m/s"}, {"up", "m/s"}});
  Json velocity = column("m/s", 50, "velocity [vx, vy, vz]");
  velocity["minItems"] = velocity["maxItems"] = 3;
  return {{"description", "velocity of the water: the same everywhere, or over height and time"},
          {"anyOf", {velocity, profile, drift}}};
}

Json results_schema() {
  Json entry = object();
  put(entry, "of", text("a part, an edge or a point"), true);
  put(entry, "take",
      text(
          "min, max, mean, sum or range, and a quantity: x, y, z, displacement, reaction z, heel, tension …"),
      true);
  return {{"type", "object"}, {"additionalProperties", entry}, {"description", "named scalars"}};
}

/// Adds the table of a solver, an integrator or a strategy to `analysis`.
void put_component(Json& analysis, const std::string& type, const char* doc,
                   std::span<const netloft_parameter> parameters) {
  const scenes::ComponentTable at = scenes::table_of_component(type);
  Json& plugin = analysis["properties"][at.plugin];
  if (plugin.is_null()) plugin = object();
  if (at.component.empty()) {
    plugin["description"] = doc;
    return put_table(plugin, parameters);
  }
  Json own = object();
  own["description"] = doc;
  put_table(own, parameters);
  plugin["properties"][at.component] = own;
}

/// The schema of tables of a net plan, which GEAR.md documents.
Json plan_schema(const char* doc, bool is_list) {
  if (is_list) return {{"type", "array"}, {"items", {{"type", "object"}}}, {"description", doc}};
  return {{"type", "object"}, {"additionalProperties", {{"type", "object"}}}, {"description", doc}};
}

/// Adds the keys for the division of a gear, and for the elements of its panels and ropes.
void put_gear(Json& scene) {
  Json gear = object(), elements = object();
  put_table(gear, scenes::gear_keys());
  Json& nodes = gear["properties"]["nodes"];
  nodes = {{"anyOf", Json::array({nodes, {{"const", scenes::kKnots}}})},
           {"description", nodes["description"]}};
  Json finer = {{"type", "object"}, {"additionalProperties", {{"type", "number"}, {"exclusiveMinimum", 0}}}};
  finer["description"] = "for each panel or rope: factor by which sides of triangles, or bars, are shorter";
  put(gear, "finer", finer, false);
  for (const auto& of : scenes::gear_elements())
    put(elements, of.kind,
        {{"type", "object"},
         {"properties", {{"type", text(std::string("element type, such as ") + of.type)}}},
         {"description", std::string("element and parameters of all ") + of.doc}},
        false);
  elements["additionalProperties"] = {{"type", "object"}};
  put(scene, "gear", gear, false);
  put(scene, "elements", elements, false);
  put(scene, "panels", plan_schema("net plan: pieces of netting", false), false);
  put(scene, "ropes", plan_schema("net plan: ropes, wires and chains", false), false);
  put(scene, "floats", plan_schema("net plan: floats, weights and ground gear", false), false);
  put(scene, "points", plan_schema("net plan: points that ropes lead to", false), false);
  put(scene, "hang", plan_schema("net plan: edges on ropes", true), false);
  put(scene, "flow",
      {{"type", "object"},
       {"properties", {{"type", text("how the gear changes the water: flow/momentum, or none")}}},
       {"description", "net plan: water that the net slows"}},
      false);
  put(scene, "ship",
      {{"type", "object"}, {"description", "net plan: the ship that tows, with its blocks, warps and path"}},
      false);
}

/// Adds the keys for files that a scene reads.
void put_files(Json& scene) {
  put(scene, "include",
      {{"type", "array"},
       {"items", {{"type", "string"}}},
       {"description",
        "files that are read first; keys in this file replace theirs; names are relative to the folder of "
        "this file"}},
      false);
  put(scene, "without",
      {{"type", "array"},
       {"items", text("a table or key of the included files, such as floats.headline")},
       {"description", "what is left out of the files that are included"}},
      false);
  put(scene, "catalogue",
      {{"type", "array"},
       {"items", text("a folder, relative to the scene")},
       {"description", "folders with your own catalogues, searched first"}},
      false);
}

/// Adds the warnings that a scene accepts.
void put_accept(Json& scene) {
  Json entry = object();
  put(entry, "warning", text("the words with which the warning begins"), true);
  put(entry, "reason", text("why it is accepted"), true);
  put(scene, "accept",
      {{"type", "array"}, {"items", entry}, {"description", "warnings that are known and not shown"}}, false);
}

/// Adds parts (on nodes of their own, or on nodes of other parts) and rigid bodies.
void put_pieces(Json& scene, const PartSchema& parts, const PartSchema& bodies) {
  put(scene, "parts",
      {{"type", "object"},
       {"minProperties", 1},
       {"additionalProperties", parts.schema()},
       {"description", "the pieces of the gear"}},
      false);
  put(scene, "bodies",
      {{"type", "object"},
       {"additionalProperties", bodies.schema()},
       {"description", "rigid bodies; parts are joined to points of them"}},
      false);
  // "type" is required only without `include`, because an included file may have it.
  scene["if"] = {{"required", {"include"}}};
  for (const char* pieces : {"parts", "bodies"})
    scene["else"]["properties"][pieces]["additionalProperties"]["required"] = {"type"};
  scene["$defs"] = parts.definitions;
  scene["$defs"].update(bodies.definitions);
}

}  // namespace

Json scene_schema(Registry& registry) {
  PartSchema parts, bodies;
  Json analysis = object(), water = object(), waves = object(), tow = object(), bed = object();
  put_table(water, scenes::water_keys());
  put_table(tow, scenes::tow_keys());
  put_table(bed, scenes::bed_keys());
  put(water, "current", current_schema(), false);
  put_table(waves, scenes::wave_keys());
  put(water, "waves", waves, false);
  put_table(analysis, scenes::analysis_keys());
  put_table(analysis, scenes::dynamics_keys());
  for (const auto& name : registry.available()) {
    const PluginContent& plugin = registry.plugin(name);
    for (const auto& e : plugin.elements) {
      if (!e.rides_on)
        parts.add(e, plugin);  // companions are in the schema of the elements that they accompany
      if (e.is_on_body()) bodies.add_body(e, plugin);
    }
    for (const auto& s : plugin.solvers) put_component(analysis, s.type, s.solver.doc, s.parameters);
    for (const auto& i : plugin.integrators) put_component(analysis, i.type, i.integrator.doc, i.parameters);
    for (const auto& s : plugin.strategies) put_component(analysis, s.type, s.strategy.doc, s.parameters);
  }
  Json scene = object();
  scene["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  scene["title"] = "Netloft scene";
  put_files(scene);
  put_accept(scene);
  put(scene, "water", water, false);
  put(scene, "tow", tow, false);
  put(scene, "bed", bed, false);
  put_pieces(scene, parts, bodies);
  put_gear(scene);
  put(scene, "hold", hold_schema(), false);
  put(scene, "join", join_schema(), false);
  put(scene, "analysis", analysis, false);
  put(scene, "results", results_schema(), false);
  return scene;
}

int schema_command(const PluginOptions& options) {
  Registry registry;
  find_plugins(options, registry);
  print_line(scene_schema(registry).dump(2, ' ', false, Json::error_handler_t::replace));
  return kDone;
}

}  // namespace netloft::program
