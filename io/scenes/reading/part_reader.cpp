// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/part_reader.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/scenes/reading/idle_keys.hpp"
#include "io/scenes/reading/own_data.hpp"
#include "io/scenes/reading/part_names.hpp"
#include "io/scenes/reading/thickness.hpp"

namespace netloft::scenes {

namespace {

bool is_turned(formats::TableReader& part) {
  const formats::Value* panel = part.kind("panel") == formats::Kind::table ? part.raw("panel") : nullptr;
  const formats::Member* netting = panel ? panel->as<formats::Table>()->find("netting") : nullptr;
  const std::string* word = netting ? netting->value.as<std::string>() : nullptr;
  return word && *word == "t90";
}

}  // namespace

void PartReader::read_parts(formats::Presence presence) {
  formats::TableReader parts = root_.table("parts", presence, "the parts of the gear, one table each");
  if (presence == formats::Presence::required && root_.kind("parts") == formats::Kind::table &&
      parts.keys().empty())
    root_.error("parts", "there are no parts: a scene needs at least one, such as [parts.net]");
  for (const auto& name : parts.keys()) {
    check_part_name(name, parts);
    if (parts.kind(name) == formats::Kind::table) {
      formats::TableReader part = parts.table(name);
      if (part.has("on")) {
        riders_.emplace_back(name, part);  // riders are read later, because they may name parts that follow
        draft_.announce_rider(name);
      } else {
        read_part(name, part);
      }
    } else {
      parts.error(name, "a part is a table, such as [parts.net]");
    }
  }
}

void PartReader::read_bodies() {
  formats::TableReader bodies =
      root_.table("bodies", formats::Presence::optional, "rigid bodies, a table each");
  for (const auto& name : bodies.keys()) {
    check_part_name(name, bodies);
    if (const auto same = draft_.part_number(name))
      diagnostics_.error(bodies.place(name), "there is a part named " + formats::in_quotes(name) +
                                                 " already, at " +
                                                 diagnostics_.where(draft_.geometries[*same].names.place));
    if (bodies.kind(name) != formats::Kind::table) {
      bodies.error(name, "a body is a table, such as [bodies.door]");
      continue;
    }
    formats::TableReader body = bodies.table(name);
    read_part(name, body, Home::bodies);
  }
}

std::size_t PartReader::read_body_of_plan(const std::string& name, const std::string& name_in_plan,
                                          const BodyOfPlan* place) {
  formats::TableReader bodies = root_.table("bodies", formats::Presence::optional);
  formats::TableReader table = bodies.table(name_in_plan);
  table.has("stands");
  read_part(name, table, Home::bodies, place);
  return draft_.geometries.size() - 1;
}

void PartReader::check_part_name(const std::string& name, formats::TableReader& parts) {
  const bool has_dot = name.find('.') != std::string::npos;
  const std::string fault = has_dot
                                ? "must not contain a dot, which separates a part from its edges (net.fore)"
                                : formats::name_fault(name);
  if (!fault.empty())
    diagnostics_.error(parts.place(name), "the name of a part, " + formats::in_quotes(name) + ", " + fault);
  if (gear_.has_name(name))
    diagnostics_.error(parts.place(name),
                       "the net plan has something named " + formats::in_quotes(name) + " already",
                       "[elements." + name + "] changes its elements; give a new part another name");
}

const ElementType* PartReader::find_type(Part& part, formats::TableReader& table, Home home) const {
  part.type = read_type_name(draft_, part.name, table);
  const ElementType* type = elements_.find(part.type, table);
  if (!type || type->is_on_body() == (home == Home::bodies)) return type;
  table.error(
      "type", type->type + (type->is_on_body() ? " needs a rigid body" : " cannot be on a rigid body"),
      type->is_on_body() ? "make one with [bodies." + part.name + "], or name an existing one with on = \"…\""
                         : "move it to [parts." + part.name + "], or use a type such as body/solid");
  return nullptr;
}

void PartReader::read_part(const std::string& name, formats::TableReader& table, Home home,
                           const BodyOfPlan* place) {
  formats::report({"reading", name, draft_.geometries.size(), "parts"});
  const int errors_before = diagnostics_.errors();
  Geometry geometry;
  Part part;
  part.name = name;
  const ElementType* type = find_type(part, table, home);
  if (type) {
    elements_.read(*type, table, part);
    geometry = place ? read_body(table, place) : read_geometry(*type, name, table);
    read_extra_data(*type, geometry, table);
  } else {
    // The allowed keys depend on the type. If it is unknown, all keys are allowed.
    for (const auto& key : table.keys()) table.raw(key);
  }
  geometry.names.name = name;
  geometry.names.place = table.place();
  if (is_turned(table) && diagnostics_.errors() == errors_before)
    check_turned_netting(part, table.table("panel").place("netting"), diagnostics_);
  if (diagnostics_.errors() == errors_before) check_thickness(part, geometry, table);
  const bool is_sound =
      diagnostics_.errors() == errors_before && !(table.has("mesh") && meshes_.has_failed());
  draft_.add_part(std::move(part), std::move(geometry), type, is_sound);
}

void PartReader::check_thickness(const Part& part, const Geometry& geometry, formats::TableReader& table) {
  // Parts on a mesh are not checked: a rope in a mesh may be a short piece of a longer rope, and for bars of
  // netting the mesh file gives length and number of twines independently.
  if (table.has("mesh")) return;
  if (const auto fault = thickness_fault(part, geometry))
    table.error(fault->key, fault->message, kThicknessCure);
}

Geometry PartReader::read_geometry(const ElementType& type, const std::string& name,
                                   formats::TableReader& table) {
  if (table.has("mesh")) return meshes_.read(type, name, draft_.geometries.size(), table);
  switch (layout_of(type)) {
    case Layout::line:
      return read_line(table);
    case Layout::panel_in_triangles:
      return read_panel(table);
    case Layout::panel_in_bars:
      return read_panel_in_bars(table);
    case Layout::body:
      return read_body(table);
    default:
      if (type.nodes() == 1) return read_point(table);
      table.error("type", "connects parts that meet, and has no nodes of its own",
                  "name the parts: on = [\"first\", \"second\"]");
      return {};
  }
}

/// Reads data of elements that do not follow from the geometry: one value for all elements of the part.
void PartReader::read_extra_data(const ElementType& type, Geometry& geometry, formats::TableReader& table) {
  const std::size_t elements = geometry.elements.size() / static_cast<std::size_t>(type.nodes());
  for (const auto& datum : type.data)
    if (!find_datum_on(type.element.stencil, datum.name))
      read_own_datum(type, datum, elements, table, geometry.data);
}

std::string read_type_name(const Draft& draft, const std::string& name, formats::TableReader& table) {
  std::vector<std::string> others;
  if (!table.has("type") && table.diagnostics().wants_hints())
    for (const auto& part : draft.geometries) others.push_back(part.names.name);
  if (const auto near = nearest(name, others)) {
    table.error("type", "is missing: element type, plugin/element, such as priour/triangle",
                "did you mean the part \"" + *near + "\"?");
    return {};
  }
  return read_name(table, "type", "element type, plugin/element, such as priour/triangle");
}

}  // namespace netloft::scenes
