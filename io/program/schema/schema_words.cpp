// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/schema/schema_words.hpp"

#include "framework/parameters/parameter_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::program::schema {

namespace {

/// A column: numbers that are each an SI number or a text with a unit, or numbers with one common unit.
Json column_schema(const char* unit, const std::string& doc) {
  const double inf = std::numeric_limits<double>::infinity();
  const Json each = {{"type", "array"}, {"items", quantity(unit, -inf, inf, doc)}, {"minItems", 1}};
  const Json values = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 1}};
  const Json with_unit = {
      {"type", "object"},
      {"properties", {{"unit", {{"type", "string"}, {"minLength", 1}}}, {"values", values}}},
      {"required", {"unit", "values"}},
      {"additionalProperties", false}};
  return {{"description", doc}, {"anyOf", {each, with_unit}}};
}

Json parameter_schema(const netloft_parameter& p) {
  switch (p.kind) {
    case NETLOFT_TABLE: {
      Json table = object();
      table["description"] = p.doc;
      for (std::size_t k = 0; p.columns[k]; ++k) {
        table["properties"][p.columns[k]] = column_schema(p.column_units[k], p.doc);
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

}  // namespace

Json object() {
  return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

Json quantity(const std::string& unit, double lo, double hi, const std::string& doc) {
  Json number = {{"type", "number"}};
  if (std::isfinite(lo)) number["minimum"] = lo;
  if (std::isfinite(hi)) number["maximum"] = hi;
  return {{"description", unit == "1" ? doc : doc + " [" + unit + "]; a number in SI or a text with a unit"},
          {"anyOf", {number, {{"type", "string"}}}}};
}

Json columns_schema(const std::string& doc,
                    std::initializer_list<std::pair<const char*, const char*>> columns) {
  Json table = object();
  table["description"] = doc;
  for (const auto& [name, unit] : columns) table["properties"][name] = column_schema(unit, doc);
  table["required"] = {columns.begin()->first};
  return table;
}

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

Json text(const std::string& doc) { return {{"type", "string"}, {"description", doc}}; }

}  // namespace netloft::program::schema
