// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/parameters.hpp"
#include "io/catalogue/part_kinds.hpp"
#include "io/cli/commands.hpp"
#include "io/cli/components.hpp"
#include "io/scene/analysis.hpp"
#include "io/scene/dynamics.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/keys.hpp"
#include "io/scene/mesh_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace netloft::io {

namespace {

Json object() {
  return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

/// An SI number, or a text with a unit.
Json quantity(const std::string& unit, double lo, double hi, const std::string& doc) {
  Json number = {{"type", "number"}};
  if (std::isfinite(lo)) number["minimum"] = lo;
  if (std::isfinite(hi)) number["maximum"] = hi;
  return {{"description", unit == "1" ? doc : doc + " [" + unit + "]; a number in SI or a text with a unit"},
          {"anyOf", {number, {{"type", "string"}}}}};
}

/// Columns of numbers, each an SI number or a text with a unit.
Json column_schema(const char* unit, const std::string& doc) {
  const double inf = std::numeric_limits<double>::infinity();
  return {
      {"type", "array"}, {"items", quantity(unit, -inf, inf, doc)}, {"minItems", 1}, {"description", doc}};
}

/// The same, or numbers with one unit for all.
Json column_or_values_schema(const char* unit, const std::string& doc) {
  const Json values = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 1}};
  const Json with_unit = {{"type", "object"},
                          {"properties", {{"unit", {{"type", "string"}}}, {"values", values}}},
                          {"required", {"unit", "values"}},
                          {"additionalProperties", false}};
  return {{"description", doc}, {"anyOf", {column_schema(unit, doc), with_unit}}};
}

/// A table of columns by name; the first is what the others are over.
Json columns_schema(const std::string& doc,
                    std::initializer_list<std::pair<const char*, const char*>> columns) {
  Json table = object();
  table["description"] = doc;
  for (const auto& [name, unit] : columns) table["properties"][name] = column_schema(unit, doc);
  table["required"] = {columns.begin()->first};
  return table;
}

Json parameter_schema(const netloft_parameter& p) {
  switch (p.kind) {
    case NETLOFT_TABLE: {
      Json table = object();
      table["description"] = p.doc;
      for (std::size_t k = 0; p.columns[k]; ++k) {
        table["properties"][p.columns[k]] = column_or_values_schema(p.column_units[k], p.doc);
        table["required"].push_back(p.columns[k]);
      }
      return table;
    }
    case NETLOFT_INTEGER:
      return {{"type", "integer"},
              {"minimum", p.lo},
              {"maximum", p.hi},
              {"default", p.fallback},
              {"description", p.doc}};
    case NETLOFT_BOOLEAN:
      return {{"type", "boolean"}, {"default", p.fallback != 0}, {"description", p.doc}};
    case NETLOFT_TEXT:
      return {{"type", "string"}, {"description", p.doc}};
    case NETLOFT_CHOICE: {
      Json words = Json::array();
      for (std::size_t i = 0; p.choices[i]; ++i) words.push_back(p.choices[i]);
      return {{"enum", words}, {"default", default_of(p)}, {"description", p.doc}};
    }
    default: {
      Json q = quantity(p.unit, p.lo, p.hi, p.doc);
      if (!(p.flags & NETLOFT_REQUIRED) && !p.fallback_of) q["default"] = p.fallback;
      return q;
    }
  }
}

/// Puts a schema at a dotted name, making tables on the way.
void put(Json& owner, const std::string& name, const Json& schema, bool required) {
  Json* at = &owner;
  std::size_t begin = 0;
  for (auto dot = name.find('.'); dot != std::string::npos; begin = dot + 1, dot = name.find('.', begin)) {
    const std::string group = name.substr(begin, dot - begin);
    if (required) (*at)["required"].push_back(group);
    Json& properties = (*at)["properties"];
    if (!properties.contains(group)) properties[group] = object();
    at = &properties[group];
  }
  const std::string leaf = name.substr(begin);
  (*at)["properties"][leaf] = schema;
  if (required) (*at)["required"].push_back(leaf);
}

void drop_repeats(Json& schema) {
  if (schema.contains("required")) {
    Json once = Json::array();
    for (const auto& name : schema["required"])
      if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
    schema["required"] = once;
  }
  if (schema.contains("properties"))
    for (auto& [key, value] : schema["properties"].items()) drop_repeats(value);
}

void put_table(Json& owner, std::span<const netloft_parameter> table) {
  for (const auto& p : table) put(owner, p.name, parameter_schema(p), p.flags & NETLOFT_REQUIRED);
}

Json count_limits(Json array, const Count& count) {
  if (count.least > 0) array["minItems"] = count.least;
  if (count.most < 1000000) array["maxItems"] = count.most;
  return array;
}

Json text(const std::string& doc) { return {{"type", "string"}, {"description", doc}}; }

Json geometry_schema(const GeometryKey& key) {
  const Json number = quantity(key.unit, key.range.lo, key.range.hi, key.doc);
  const Json integer = {
      {"type", "integer"}, {"minimum", key.range.lo}, {"maximum", key.range.hi}, {"description", key.doc}};
  const Json point = {{"description", key.doc},
                      {"type", "array"},
                      {"items", quantity(key.unit, key.range.lo, key.range.hi, "x, y or z")},
                      {"minItems", 3},
                      {"maxItems", 3}};
  switch (key.shape) {
    case GeometryKey::Shape::integer:
      return integer;
    case GeometryKey::Shape::integers:
      return count_limits({{"type", "array"}, {"items", integer}, {"description", key.doc}}, key.count);
    case GeometryKey::Shape::named_points:
      return {{"type", "object"}, {"additionalProperties", point}, {"description", key.doc}};
    case GeometryKey::Shape::word:
      if (key.words.empty()) return text(key.doc);
      return {{"enum", key.words}, {"default", key.words[0]}, {"description", key.doc}};
    case GeometryKey::Shape::points:
      if (key.count.most == 1) return point;
      return count_limits({{"type", "array"}, {"items", point}, {"description", key.doc}}, key.count);
    default:
      return number;
  }
}

/// Data of elements that the geometry does not give stand in the part's table.
void put_data(Json& part, const ElementType& e, bool required) {
  if (e.element.stencil == NETLOFT_BAR_PAIR) return;  // the ropes that it stands between give it all
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& datum : e.data)
    if (!find_datum_on(e.element.stencil, datum.name))
      put(part, datum.name,
          count_limits({{"type", "array"},
                        {"items", quantity(datum.unit, -inf, inf, datum.doc)},
                        {"description", datum.doc}},
                       exactly(datum.width)),
          required);
}

/// `drag = "hydro/morison"`, or a table with the law and its parameters.
void put_laws(Json& part, const ElementType& e) {
  for (const auto& slot : e.laws) {
    const Json name = text(std::string(slot.doc) + ", such as " + slot.fallback);
    const Json table = {{"type", "object"}, {"properties", {{"law", name}}}};
    put(part, slot.name, {{"description", slot.doc}, {"anyOf", {name, table}}}, false);
  }
}

/// Elements that come with those of a part bring parameters of their own.
void put_companions(Json& part, const ElementType& e, const PluginContent& plugin) {
  for (const auto& other : plugin.elements)
    if (other.element.rides_on && std::string_view(other.element.rides_on) == e.element.name)
      put_table(part, other.parameters);
}

Json begin_part(const ElementType& e) {
  Json part = object();
  part["title"] = e.type;
  part["description"] = e.element.doc;
  put(part, "type", {{"const", e.type}, {"description", e.element.doc}}, true);
  return part;
}

/// `twine = "pe-braided-4mm"`, or a table that overrides values of the part it names, or all values.
void let_name_catalogue_parts(Json& part) {
  for (const auto& key : part_keys()) {
    if (!part["properties"].contains(key)) continue;
    Json whole = part["properties"][key], overriding = whole;
    overriding.erase("required");
    put(overriding, "part", text("of the catalogue; `netloft catalogue` lists them"), true);
    const Json names_one = {{"type", "object"}, {"required", {"part"}}};
    part["properties"][key] = {{"description", "the name of a part of the catalogue, or a table"},
                               {"if", {{"type", "string"}}},
                               {"then", true},
                               {"else", {{"if", names_one}, {"then", overriding}, {"else", whole}}}};
  }
}

Json end_part(Json part, const ElementType& e, const PluginContent& plugin) {
  put_table(part, e.parameters);
  put_companions(part, e, plugin);
  put_laws(part, e);
  drop_repeats(part);
  let_name_catalogue_parts(part);
  return part;
}

/// A part with a geometry of its own.
Json part_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  for (const auto& key : geometry_keys(layout_of(e))) put(part, key.name, geometry_schema(key), key.required);
  put_data(part, e, true);
  return end_part(std::move(part), e, plugin);
}

/// A part on a region of a mesh.
Json mesh_part_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  part["title"] = e.type + " on a mesh";
  for (const auto& key : mesh_keys(layout_of(e))) put(part, key.name, geometry_schema(key), key.required);
  put_data(part, e, true);
  return end_part(std::move(part), e, plugin);
}

/// A part that stands on others, which may give it its data.
Json rider_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  part["title"] = e.type + " on other parts";
  const Json name = text("a part, an edge or a point");
  put(part, "on",
      {{"description", "what it stands on"},
       {"anyOf", {name, {{"type", "array"}, {"items", name}, {"minItems", 1}}}}},
      true);
  if (e.element.stencil == NETLOFT_NODE) {
    put(part, "number", quantity("1", 0, 1e6, "pieces, shared out along what it stands on"), false);
    put(part, "each", quantity("1", 0, 1e6, "pieces on every node, instead of a number"), false);
  }
  put_data(part, e, false);
  return end_part(std::move(part), e, plugin);
}

Json hold_schema() {
  Json hold = object();
  const Json name = text("what is held: a part, an edge or a point (net.fore)");
  put(hold, "on",
      {{"description", "what is held"},
       {"anyOf", {name, {{"type", "array"}, {"items", name}, {"minItems", 1}}}}},
      true);
  put(hold, "axes",
      {{"type", "string"}, {"pattern", "^[xyz]+$"}, {"description", "along which it cannot move"}}, false);
  const Json direction = {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
  for (const auto& [key, doc] : {std::pair{"along", "direction of the line it slides on"},
                                 std::pair{"plane", "normal of the plane it stays in"}}) {
    Json own = direction;
    own["description"] = doc;
    put(hold, key, own, false);
  }
  put(hold, "at", {{"description", "\"sketch\", a point, or points of a line"}}, false);
  put(hold, "name", text("name of the reaction"), false);
  put(hold, "displacement",
      columns_schema("way from where it is held, over time",
                     {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"z", "m"}}),
      false);
  put(hold, "velocity",
      columns_schema("velocity of what is held, over time",
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
       {"description", "points or edges that become one"}},
      false);
  put(join, "together", {{"type", "boolean"}, {"default", false}, {"description", "all nodes become one"}},
      false);
  put(join, "edges", {{"type", "array"}, {"minItems", 2}, {"description", "net plan: edges sewn together"}},
      false);
  put(join, "take_up",
      {{"type", "number"}, {"description", "net plan: meshes of the second edge for one of the first"}},
      false);
  join["anyOf"] = {{{"required", {"points"}}}, {{"required", {"edges"}}}};
  return {{"type", "array"}, {"items", join}};
}

/// One velocity, or a profile over height.
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

/// What a part may hold, by its type and by whether it stands on others, for two readers: `allOf` leads a
/// checker to the one description that holds, so that it can name the wrong key; `anyOf`, which is always
/// true, offers an editor all of them to complete from.
class PartSchema {
 public:
  void add(const ElementType& e, const PluginContent& plugin) {
    const std::string name = name_of(e);
    definitions[name + "-on"] = rider_schema(e, plugin);
    types_.push_back(e.type);
    offers_.push_back(reference(name + "-on"));
    if (e.is_on_body()) return check(e, reference(name + "-on"));  // [bodies] makes what it stands on
    definitions[name] = part_schema(e, plugin);
    definitions[name + "-mesh"] = mesh_part_schema(e, plugin);
    offers_.push_back(reference(name)), offers_.push_back(reference(name + "-mesh"));
    const Json with_nodes = {
        {"if", {{"required", {"mesh"}}}}, {"then", reference(name + "-mesh")}, {"else", reference(name)}};
    check(e, {{"if", {{"required", {"on"}}}}, {"then", reference(name + "-on")}, {"else", with_nodes}});
  }
  /// The same of a rigid body.
  void add_body(const ElementType& e, const PluginContent& plugin) {
    const std::string name = name_of(e);
    definitions[name] = part_schema(e, plugin);
    types_.push_back(e.type);
    offers_.push_back(reference(name));
    check(e, reference(name));
  }
  Json schema() const {
    return {{"type", "object"},
            {"properties", {{"type", {{"enum", types_}, {"description", "what the part is made of"}}}}},
            {"allOf", checks_},
            {"anyOf", offers_}};
  }
  Json definitions = Json::object();

 private:
  static std::string name_of(const ElementType& e) {
    std::string name = e.type;
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
  }
  static Json reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }
  void check(const ElementType& e, const Json& then) {
    checks_.push_back(
        {{"if", {{"properties", {{"type", {{"const", e.type}}}}}, {"required", {"type"}}}}, {"then", then}});
  }
  Json types_ = Json::array(), checks_ = Json::array(), offers_ = {{{"type", "object"}}};
};

/// The table that a solver, an integrator or a strategy has in `analysis`.
void put_component(Json& analysis, const std::string& type, const char* doc,
                   std::span<const netloft_parameter> parameters) {
  const ComponentTable at = table_of_component(type);
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

/// Tables of a net plan, whose page is GEAR.md.
Json plan_schema(const char* doc, bool is_list) {
  if (is_list) return {{"type", "array"}, {"items", {{"type", "object"}}}, {"description", doc}};
  return {{"type", "object"}, {"additionalProperties", {{"type", "object"}}}, {"description", doc}};
}

/// How a gear is modelled, and what the parts of its plan are made of.
void put_gear(Json& scene) {
  Json gear = object(), elements = object();
  put_table(gear, gear_keys());
  Json& nodes = gear["properties"]["nodes"];
  nodes = {{"anyOf", Json::array({nodes, {{"const", kKnots}}})}, {"description", nodes["description"]}};
  Json finer = {{"type", "object"}, {"additionalProperties", {{"type", "number"}, {"exclusiveMinimum", 0}}}};
  finer["description"] = "by panel or rope: sides of triangles, or bars, that many times shorter";
  put(gear, "finer", finer, false);
  for (const auto& of : gear_elements())
    put(elements, of.kind,
        {{"type", "object"},
         {"properties", {{"type", text(std::string("element type, such as ") + of.type)}}},
         {"description", std::string("what counts for all ") + of.doc}},
        false);
  elements["additionalProperties"] = {{"type", "object"}};
  put(scene, "gear", gear, false);
  put(scene, "elements", elements, false);
  put(scene, "panels", plan_schema("net plan: pieces of netting", false), false);
  put(scene, "ropes", plan_schema("net plan: ropes, wires and chains", false), false);
  put(scene, "floats", plan_schema("net plan: floats, weights and ground gear", false), false);
  put(scene, "points", plan_schema("net plan: points that ropes lead to", false), false);
  put(scene, "hang", plan_schema("net plan: edges on ropes", true), false);
  put(scene, "ship",
      {{"type", "object"}, {"description", "net plan: the ship that tows, with its blocks, warps and path"}},
      false);
}

/// What is read beside the scene itself.
void put_files(Json& scene) {
  put(scene, "include",
      {{"type", "array"},
       {"items", {{"type", "string"}}},
       {"description", "files laid down first, relative to this one"}},
      false);
  put(scene, "catalogue",
      {{"type", "array"},
       {"items", text("a folder, relative to the scene")},
       {"description", "folders with catalogues of one's own, searched first"}},
      false);
}

}  // namespace

namespace {

/// The pieces of a gear: parts on nodes of their own or on others, and rigid bodies.
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
       {"description", "rigid bodies, to whose points parts are joined"}},
      false);
  // What is included may say it already.
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
  put_table(water, water_keys());
  put_table(tow, tow_keys());
  put_table(bed, bed_keys());
  put(water, "current", current_schema(), false);
  put_table(waves, wave_keys());
  put(water, "waves", waves, false);
  put_table(analysis, analysis_keys());
  put_table(analysis, dynamics_keys());
  for (const auto& name : registry.available()) {
    const PluginContent& plugin = registry.plugin(name);
    for (const auto& e : plugin.elements) {
      if (!e.element.rides_on) parts.add(e, plugin);  // else it comes with another
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

int schema_command(const Options& options) {
  Registry registry;
  find_plugins(options, registry);
  std::puts(scene_schema(registry).dump(2, ' ', false, Json::error_handler_t::replace).c_str());
  return kDone;
}

}  // namespace netloft::io
