// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/schema/part_schema.hpp"

#include "io/gears/catalogue/part_kinds.hpp"
#include "io/program/schema/schema_words.hpp"
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/mesh_parts.hpp"

#include <algorithm>
#include <limits>

namespace netloft::program::schema {

namespace {

Json count_limits(Json array, const formats::Count& count) {
  if (count.least > 0) array["minItems"] = count.least;
  if (count.most < 1000000) array["maxItems"] = count.most;
  return array;
}

Json geometry_schema(const scenes::GeometryKey& key) {
  const Json number = quantity(key.unit, key.range.lo, key.range.hi, key.doc);
  const Json integer = {
      {"type", "integer"}, {"minimum", key.range.lo}, {"maximum", key.range.hi}, {"description", key.doc}};
  const Json point = {{"description", key.doc},
                      {"type", "array"},
                      {"items", quantity(key.unit, key.range.lo, key.range.hi, "x, y or z")},
                      {"minItems", 3},
                      {"maxItems", 3}};
  switch (key.shape) {
    case scenes::GeometryKey::Shape::integer:
      return integer;
    case scenes::GeometryKey::Shape::integers:
      return count_limits({{"type", "array"}, {"items", integer}, {"description", key.doc}}, key.count);
    case scenes::GeometryKey::Shape::named_points:
      return {{"type", "object"}, {"additionalProperties", point}, {"description", key.doc}};
    case scenes::GeometryKey::Shape::word:
      if (key.words.empty()) return text(key.doc);
      return {{"enum", key.words}, {"default", key.words[0]}, {"description", key.doc}};
    case scenes::GeometryKey::Shape::points:
      if (key.count.most == 1) return point;
      return count_limits({{"type", "array"}, {"items", point}, {"description", key.doc}}, key.count);
    default:
      return number;
  }
}

/// Adds keys for those data of elements that the geometry of the part does not provide.
void put_data(Json& part, const ElementType& e, bool required) {
  if (e.element.stencil == NETLOFT_BAR_PAIR) return;  // all data come from the two ropes
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& datum : e.data)
    if (!find_datum_on(e.element.stencil, datum.name))
      put(part, datum.name,
          count_limits({{"type", "array"},
                        {"items", quantity(datum.unit, -inf, inf, datum.doc)},
                        {"description", datum.doc}},
                       formats::exactly(datum.width)),
          required);
}

/// Adds the laws of an element: `drag = "hydro/morison"`, or a table with the law and its parameters.
void put_laws(Json& part, const ElementType& e) {
  for (const auto& slot : e.laws) {
    const Json name = text(std::string(slot.doc) + ", such as " + slot.fallback);
    const Json table = {{"type", "object"}, {"properties", {{"law", name}}}};
    put(part, slot.name, {{"description", slot.doc}, {"anyOf", {name, table}}}, false);
  }
}

/// Adds the parameters of companions: elements that the program makes together with elements of this type.
void put_companions(Json& part, const ElementType& e, const PluginContent& plugin) {
  for (const auto& other : plugin.elements)
    if (other.rides_on && std::string_view(other.rides_on) == e.element.name)
      put_table(part, other.parameters);
}

Json begin_part(const ElementType& e) {
  Json part = object();
  part["title"] = e.type;
  part["description"] = e.element.doc;
  put(part, "type", {{"const", e.type}, {"description", e.element.doc}}, true);
  return part;
}

/// Allows catalogue parts: `twine = "pe-braided-4mm"`, a table that overrides values of a named part, or a
/// table with all values.
void let_name_catalogue_parts(Json& part) {
  for (const auto& key : gears::part_keys()) {
    if (!part["properties"].contains(key)) continue;
    Json whole = part["properties"][key], overriding = whole;
    overriding.erase("required");
    put(overriding, "part", text("name of a part of the catalogue; `netloft catalogue` lists them"), true);
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

/// The schema of a part with its own geometry.
Json part_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  for (const auto& key : scenes::geometry_keys(scenes::layout_of(e)))
    put(part, key.name, geometry_schema(key), key.required);
  put_data(part, e, true);
  return end_part(std::move(part), e, plugin);
}

/// The schema of a part on a region of a mesh.
Json mesh_part_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  part["title"] = e.type + " on a mesh";
  for (const auto& key : scenes::mesh_keys(scenes::layout_of(e)))
    put(part, key.name, geometry_schema(key), key.required);
  put_data(part, e, true);
  return end_part(std::move(part), e, plugin);
}

/// The schema of a part on the nodes of other parts, which may provide the data of its elements.
Json rider_schema(const ElementType& e, const PluginContent& plugin) {
  Json part = begin_part(e);
  part["title"] = e.type + " on other parts";
  const Json name = text("a part, an edge or a point");
  put(part, "on",
      {{"description", "part or region whose nodes this part uses"},
       {"anyOf", {name, {{"type", "array"}, {"items", name}, {"minItems", 1}}}}},
      true);
  if (e.element.stencil == NETLOFT_NODE) {
    put(part, "number", quantity("1", 0, 1e6, "pieces, spread evenly along `on`"), false);
    put(part, "each", quantity("1", 0, 1e6, "number of pieces on every node, instead of a number in all"),
        false);
  }
  put_data(part, e, false);
  return end_part(std::move(part), e, plugin);
}

std::string name_of(const ElementType& e) {
  std::string name = e.type;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

Json reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }

}  // namespace

void PartSchema::add(const ElementType& e, const PluginContent& plugin) {
  const std::string name = name_of(e);
  definitions[name + "-on"] = rider_schema(e, plugin);
  types_.push_back(e.type);
  offers_.push_back(reference(name + "-on"));
  if (e.is_on_body()) return check(e, reference(name + "-on"));  // its body is in [bodies]
  definitions[name] = part_schema(e, plugin);
  definitions[name + "-mesh"] = mesh_part_schema(e, plugin);
  offers_.push_back(reference(name));
  offers_.push_back(reference(name + "-mesh"));
  const Json with_nodes = {
      {"if", {{"required", {"mesh"}}}}, {"then", reference(name + "-mesh")}, {"else", reference(name)}};
  check(e, {{"if", {{"required", {"on"}}}}, {"then", reference(name + "-on")}, {"else", with_nodes}});
}

void PartSchema::add_body(const ElementType& e, const PluginContent& plugin) {
  const std::string name = name_of(e);
  definitions[name] = part_schema(e, plugin);
  types_.push_back(e.type);
  offers_.push_back(reference(name));
  check(e, reference(name));
}

Json PartSchema::schema() const {
  return {{"type", "object"},
          {"properties", {{"type", {{"enum", types_}, {"description", "what the part is made of"}}}}},
          {"allOf", checks_},
          {"anyOf", offers_}};
}

void PartSchema::check(const ElementType& e, const Json& then) {
  checks_.push_back(
      {{"if", {{"properties", {{"type", {{"const", e.type}}}}}, {"required", {"type"}}}}, {"then", then}});
}

}  // namespace netloft::program::schema
