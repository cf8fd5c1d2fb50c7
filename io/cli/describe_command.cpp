// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/parameters.hpp"
#include "framework/registry/nearest.hpp"
#include "framework/scene/plan.hpp"
#include "io/cli/commands.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/keys.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <functional>
#include <iterator>

namespace netloft::io {

namespace {

using Json = nlohmann::ordered_json;
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
    default:
      return "the three corners of a triangle";
  }
}

void print(const Json& json) { std::puts(json.dump(2, ' ', false, Json::error_handler_t::replace).c_str()); }

Json parameter_json(std::span<const netloft_parameter> table) {
  Json rows = Json::array();
  for (const auto& p : table)
    rows.push_back({{"name", p.name},
                    {"unit", p.unit},
                    {"allowed", allowed(p)},
                    {"default", default_of(p)},
                    {"doc", p.doc}});
  return rows;
}

void parameter_text(std::span<const netloft_parameter> table, Out out) {
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
  for (const auto& key : geometry_keys(layout_of(e))) fmt::format_to(out, "  {:<24} {}\n", key.name, key.doc);
  fmt::format_to(out, "\nparameters\n");
  parameter_text(e.parameters, out);
  fmt::format_to(out, "\nterms\n");
  for (const auto& t : e.terms)
    fmt::format_to(out, "  {:<24} {} ({})\n", t.name, t.doc, describe_traits(t.traits));
  if (!e.laws.empty()) fmt::format_to(out, "\nlaws\n");
  for (const auto& l : e.laws) fmt::format_to(out, "  {:<24} {}, default {}\n", l.name, l.doc, l.fallback);
  if (!e.outputs.empty()) fmt::format_to(out, "\noutputs\n");
  for (const auto& o : e.outputs) fmt::format_to(out, "  {:<24} {} [{}]\n", o.name, o.doc, o.unit);
  return text;
}

Json element_json(const ElementType& e) {
  Json terms = Json::array(), outputs = Json::array(), data = Json::array(), geometry = Json::array();
  for (const auto& key : geometry_keys(layout_of(e)))
    geometry.push_back({{"name", key.name}, {"doc", key.doc}});
  for (const auto& t : e.terms)
    terms.push_back({{"name", t.name}, {"traits", describe_traits(t.traits)}, {"doc", t.doc}});
  for (const auto& o : e.outputs) outputs.push_back({{"name", o.name}, {"unit", o.unit}, {"doc", o.doc}});
  for (const auto& d : e.data)
    data.push_back({{"name", d.name}, {"unit", d.unit}, {"width", d.width}, {"doc", d.doc}});
  return {{"type", e.type},
          {"kind", "element"},
          {"doc", e.element.doc},
          {"stands_on", stencil_name(e.element.stencil)},
          {"geometry", geometry},
          {"parameters", parameter_json(e.parameters)},
          {"data", data},
          {"terms", terms},
          {"outputs", outputs},
          {"plugin", e.origin->file},
          {"version", e.origin->version}};
}

std::string solver_text(const SolverType& s) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}\na solver; plugin {} {} ({})\n\nparameters (in the table analysis.{})\n",
                 s.type, s.solver.doc, s.origin->name, s.origin->version,
                 s.origin->file.empty() ? "compiled in" : s.origin->file, s.origin->name);
  parameter_text(s.parameters, out);
  return text;
}

Json solver_json(const SolverType& s) {
  return {{"type", s.type},           {"kind", "solver"},
          {"doc", s.solver.doc},      {"parameters", parameter_json(s.parameters)},
          {"plugin", s.origin->file}, {"version", s.origin->version}};
}

std::string law_text(const LawType& l) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(
      out, "{}: {}\na law for {}; plugin {} {} ({})\n\nparameters (beside `law` in the slot's table)\n",
      l.type, l.law.doc, l.law.kind == NETLOFT_TWINE_LAW ? "twines and ropes" : "netting as a screen",
      l.origin->name, l.origin->version, l.origin->file.empty() ? "compiled in" : l.origin->file);
  parameter_text(l.parameters, out);
  return text;
}

Json law_json(const LawType& l) {
  return {{"type", l.type},
          {"kind", "law"},
          {"doc", l.law.doc},
          {"for", l.law.kind == NETLOFT_TWINE_LAW ? "twine" : "screen"},
          {"parameters", parameter_json(l.parameters)},
          {"plugin", l.origin->file},
          {"version", l.origin->version}};
}

/// "water" and "analysis": tables that belong to no plugin.
int describe_keys(const std::string& name, std::span<const netloft_parameter> table, bool json) {
  if (json) {
    print({{"type", name}, {"kind", "table"}, {"parameters", parameter_json(table)}});
    return kDone;
  }
  std::string text = "[" + name + "]: a table of the scene\n";
  parameter_text(table, std::back_inserter(text));
  std::puts(text.c_str());
  return kDone;
}

/// One component, whatever its kind, as a row of `list`, as a page and as JSON.
struct Component {
  std::string type, kind, doc;
  std::function<std::string()> text;
  std::function<Json()> json;
};

std::vector<Component> components_of(const PluginContent& plugin) {
  std::vector<Component> all;
  for (const auto& e : plugin.elements)
    all.push_back({e.type, "element", e.element.doc, [&e] { return element_text(e); },
                   [&e] { return element_json(e); }});
  for (const auto& l : plugin.laws)
    all.push_back({l.type, "law", l.law.doc, [&l] { return law_text(l); }, [&l] { return law_json(l); }});
  for (const auto& s : plugin.solvers)
    all.push_back(
        {s.type, "solver", s.solver.doc, [&s] { return solver_text(s); }, [&s] { return solver_json(s); }});
  return all;
}

}  // namespace

int list_command(const Options& options) {
  Registry registry;
  find_plugins(options, registry);
  Json rows = Json::array();
  std::string refused;
  for (const auto& name : registry.available()) try {
      for (const auto& c : components_of(registry.plugin(name))) {
        rows.push_back({{"type", c.type}, {"kind", c.kind}, {"doc", c.doc}});
        if (!options.json) std::puts(fmt::format("{:<24} {:<8} {}", c.type, c.kind, c.doc).c_str());
      }
    } catch (const PluginRefused& e) {
      refused += std::string(e.what()) + "\n";
    }
  if (options.json) print({{"components", rows}, {"refused", refused}});
  std::fputs(refused.c_str(), stderr);
  return refused.empty() ? kDone : kRefused;
}

int describe_command(const Options& options) {
  if (options.target == "water") return describe_keys("water", water_keys(), options.json);
  if (options.target == "analysis") return describe_keys("analysis", analysis_keys(), options.json);
  Registry registry;
  find_plugins(options, registry);
  const bool whole = options.target.find('/') == std::string::npos;
  Json all = Json::array();
  for (const auto& c : components_of(registry.plugin(options.target.substr(0, options.target.find('/'))))) {
    if (!whole && c.type != options.target) continue;
    all.push_back(c.json());
    if (!options.json) std::puts(c.text().c_str());
  }
  if (all.empty()) registry.element(options.target);  // says what there is
  if (options.json) print(all.size() == 1 ? all[0] : all);
  return kDone;
}

}  // namespace netloft::io
