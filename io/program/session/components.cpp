// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/components.hpp"

#include "framework/parameters/parameter_values.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/results/figures/law_range.hpp"
#include "io/scenes/reading/analysis.hpp"
#include "io/scenes/reading/geometry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

namespace netloft::program {

namespace {

const char* kind_name(std::uint32_t kind) {
  if (kind == NETLOFT_REAL) return "real";
  if (kind == NETLOFT_INTEGER) return "integer";
  if (kind == NETLOFT_BOOLEAN) return "boolean";
  return kind == NETLOFT_CHOICE ? "choice" : "text";
}

}  // namespace

Json parameter_json(std::span<const netloft_parameter> table) {
  Json rows = Json::array();
  for (const auto& p : table)
    rows.push_back({{"name", p.name},
                    {"kind", kind_name(p.kind)},
                    {"unit", p.unit},
                    {"allowed", allowed(p)},
                    {"default", default_of(p)},
                    {"doc", p.doc}});
  return rows;
}

namespace {

using Out = std::back_insert_iterator<std::string>;

const char* stencil_name(std::uint32_t stencil) {
  switch (stencil) {
    case NETLOFT_NODE:
      return "a node";
    case NETLOFT_BAR:
      return "two nodes of a line";
    case NETLOFT_BAR_PAIR:
      return "two neighbouring bars of a rope";
    case NETLOFT_TRIANGLE_PAIR:
      return "two triangles that share an edge";
    case NETLOFT_BODY:
      return "a rigid body";
    default:
      return "the three corners of a triangle";
  }
}

void append_parameters(std::span<const netloft_parameter> table, Out out) {
  for (const auto& p : table)
    fmt::format_to(out, "  {:<24} {}\n  {:<24} {}, default {}\n", p.name, p.doc, "", allowed(p),
                   p.flags & NETLOFT_REQUIRED ? "none: required" : default_of(p));
}

std::string element_text(const ElementType& e) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}\nan element on {}; plugin {} {} ({})\n\ngeometry\n", e.type, e.element.doc,
                 stencil_name(e.element.stencil), e.origin->name, e.origin->version,
                 e.origin->file.empty() ? "compiled in" : e.origin->file);
  for (const auto& key : scenes::geometry_keys(scenes::layout_of(e)))
    fmt::format_to(out, "  {:<24} {}\n", key.name, key.doc);
  fmt::format_to(out, "\nparameters\n");
  append_parameters(e.parameters, out);
  fmt::format_to(out, "\nterms\n");
  for (const auto& t : e.terms)
    fmt::format_to(out, "  {:<24} {} ({})\n", t.name, t.doc, describe_traits(t.traits));
  if (!e.laws.empty()) fmt::format_to(out, "\nlaws\n");
  for (const auto& l : e.laws) fmt::format_to(out, "  {:<24} {}, default {}\n", l.name, l.doc, l.fallback);
  if (!e.globals.empty()) fmt::format_to(out, "\nunknowns that the elements of a part share\n");
  for (const auto& g : e.globals)
    fmt::format_to(out, "  {:<24} {} [{}]{}\n", g.name, g.doc, g.unit,
                   g.needs ? fmt::format(", with {}", g.needs) : "");
  if (!e.outputs.empty()) fmt::format_to(out, "\noutputs\n");
  for (const auto& o : e.outputs) fmt::format_to(out, "  {:<24} {} [{}]\n", o.name, o.doc, o.unit);
  return text;
}

/// An interval as text: "[1, 100000]", "(0, 10]".
std::string interval(const formats::Range& range) {
  return fmt::format("{}{:g}, {:g}{}", range.lo_open ? "(" : "[", range.lo, range.hi,
                     range.hi_open ? ")" : "]");
}

/// A count as text: "4 ", "2 or more ".
std::string count_text(const formats::Count& count) {
  return count.least == count.most ? fmt::format("{} ", count.least)
                                   : fmt::format("{} or more ", count.least);
}

std::string allowed_geometry(const scenes::GeometryKey& key) {
  const std::string unit = key.unit == "1" ? "" : " " + key.unit;
  switch (key.shape) {
    case scenes::GeometryKey::Shape::word:
      return fmt::format("one of {}", fmt::join(key.words, ", "));
    case scenes::GeometryKey::Shape::named_points:
      return "name = [x, y, z]" + unit;
    case scenes::GeometryKey::Shape::points:
      return (key.count.most == 1 ? "" : count_text(key.count) + "times ") + "[x, y, z]" + unit;
    case scenes::GeometryKey::Shape::integers:
      return count_text(key.count) + "in " + interval(key.range) + unit;
    default:
      return interval(key.range) + unit;
  }
}

Json geometry_row(const scenes::GeometryKey& key) {
  return {{"name", key.name},
          {"unit", key.unit},
          {"allowed", allowed_geometry(key)},
          {"default", key.required        ? "required"
                      : key.words.empty() ? ""
                                          : key.words[0]},
          {"doc", key.doc}};
}

Json element_json(const ElementType& e) {
  Json terms = Json::array(), outputs = Json::array(), data = Json::array(), geometry = Json::array(),
       laws = Json::array(), globals = Json::array();
  for (const auto& key : scenes::geometry_keys(scenes::layout_of(e))) geometry.push_back(geometry_row(key));
  for (const auto& t : e.terms)
    terms.push_back({{"name", t.name}, {"traits", describe_traits(t.traits)}, {"doc", t.doc}});
  for (const auto& o : e.outputs) outputs.push_back({{"name", o.name}, {"unit", o.unit}, {"doc", o.doc}});
  for (const auto& d : e.data)
    data.push_back({{"name", d.name}, {"unit", d.unit}, {"width", d.width}, {"doc", d.doc}});
  for (const auto& l : e.laws)
    laws.push_back({{"name", l.name}, {"default", l.fallback ? l.fallback : ""}, {"doc", l.doc}});
  for (const auto& g : e.globals)
    globals.push_back(
        {{"name", g.name}, {"unit", g.unit}, {"needs", g.needs ? g.needs : ""}, {"doc", g.doc}});
  return {{"type", e.type},
          {"kind", "element"},
          {"doc", e.element.doc},
          {"stands_on", stencil_name(e.element.stencil)},
          {"geometry", geometry},
          {"parameters", parameter_json(e.parameters)},
          {"data", data},
          {"laws", laws},
          {"terms", terms},
          {"globals", globals},
          {"outputs", outputs},
          {"plugin", e.origin->file},
          {"version", e.origin->version}};
}

const char* file_of(const PluginOrigin& origin) {
  return origin.file.empty() ? "compiled in" : origin.file.c_str();
}

/// Describes a solver, an integrator or a strategy; scenes set its parameters in a table of the analysis.
std::string analysis_text(const std::string& type, const char* doc, const char* kind,
                          const PluginOrigin& origin, std::span<const netloft_parameter> parameters) {
  std::string text;
  const Out out = std::back_inserter(text);
  const scenes::ComponentTable at = scenes::table_of_component(type);
  fmt::format_to(out, "{}: {}\n{}; plugin {} {} ({})\n\nparameters (in the table analysis.{}{}{})\n", type,
                 doc, kind, origin.name, origin.version, file_of(origin), at.plugin,
                 at.component.empty() ? "" : ".", at.component);
  append_parameters(parameters, out);
  return text;
}

Json analysis_json(const std::string& type, const char* doc, const char* kind, const PluginOrigin& origin,
                   std::span<const netloft_parameter> parameters) {
  return {{"type", type},
          {"kind", kind},
          {"doc", doc},
          {"parameters", parameter_json(parameters)},
          {"plugin", origin.file},
          {"version", origin.version}};
}

Component component_of(const SolverType& s) {
  return {s.type, "solver", s.solver.doc,
          [&s] { return analysis_text(s.type, s.solver.doc, "a solver", *s.origin, s.parameters); },
          [&s] { return analysis_json(s.type, s.solver.doc, "solver", *s.origin, s.parameters); }};
}

Component component_of(const IntegratorType& i) {
  return {i.type, "integrator", i.integrator.doc,
          [&i] { return analysis_text(i.type, i.integrator.doc, "an integrator", *i.origin, i.parameters); },
          [&i] { return analysis_json(i.type, i.integrator.doc, "integrator", *i.origin, i.parameters); }};
}

Component component_of(const StrategyType& s) {
  return {s.type, "strategy", s.strategy.doc,
          [&s] { return analysis_text(s.type, s.strategy.doc, "a strategy", *s.origin, s.parameters); },
          [&s] { return analysis_json(s.type, s.strategy.doc, "strategy", *s.origin, s.parameters); }};
}

std::string law_text(const LawType& l) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(
      out, "{}: {}\na law for {}; plugin {} {} ({})\n\nparameters (beside `law` in the slot's table)\n",
      l.type, l.law.doc, l.law.kind == NETLOFT_TWINE_LAW ? "twines and ropes" : "netting as a screen",
      l.origin->name, l.origin->version, l.origin->file.empty() ? "compiled in" : l.origin->file);
  append_parameters(l.parameters, out);
  if (!l.validity.empty())
    fmt::format_to(out, "\nmeasured in this range (the report says how much of a gear is outside it)\n");
  for (const auto& range : l.validity) fmt::format_to(out, "  {}\n", results::validity_text(range));
  return text;
}

Json validity_json(const LawType& l) {
  Json rows = Json::array();
  for (const auto& range : l.validity)
    rows.push_back({{"quantity", name_of_quantity(range.quantity)},
                    {"lo", range.lo},
                    {"hi", range.hi},
                    {"source", range.source},
                    {"text", results::validity_text(range)}});
  return rows;
}

Json law_json(const LawType& l) {
  return {{"type", l.type},
          {"kind", "law"},
          {"doc", l.law.doc},
          {"for", l.law.kind == NETLOFT_TWINE_LAW ? "twine" : "screen"},
          {"parameters", parameter_json(l.parameters)},
          {"measured_for", validity_json(l)},
          {"plugin", l.origin->file},
          {"version", l.origin->version}};
}

}  // namespace

std::string parameter_text(std::span<const netloft_parameter> table) {
  std::string text;
  append_parameters(table, std::back_inserter(text));
  return text;
}

std::vector<Component> components_of(const PluginContent& plugin) {
  std::vector<Component> all;
  for (const auto& e : plugin.elements)
    all.push_back({e.type, "element", e.element.doc, [&e] { return element_text(e); },
                   [&e] { return element_json(e); }});
  for (const auto& l : plugin.laws)
    all.push_back({l.type, "law", l.law.doc, [&l] { return law_text(l); }, [&l] { return law_json(l); }});
  for (const auto& s : plugin.solvers) all.push_back(component_of(s));
  for (const auto& i : plugin.integrators) all.push_back(component_of(i));
  for (const auto& s : plugin.strategies) all.push_back(component_of(s));
  return all;
}

}  // namespace netloft::program
