// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/read_scene.hpp"

#include "io/scene/geometry.hpp"
#include "io/scene/joiner.hpp"
#include "io/scene/keys.hpp"
#include "io/scene/parameter_reader.hpp"
#include "io/scene/result_request.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

/// Reads one scene; members are steps in the order they happen.
class SceneReader {
 public:
  SceneReader(const Document& document, std::string name, Registry& registry, Diagnostics& diagnostics,
              bool& refused)
      : root_(document.root(), diagnostics),
        registry_(registry),
        diagnostics_(diagnostics),
        refused_(refused) {
    out_.scene.name = std::move(name);
    out_.files = document.files();
  }

  LoadedScene read() {
    read_water();
    read_parts();
    read_joins();
    assemble_nodes();
    read_holds();
    read_analysis();
    read_results();
    root_.finish();
    if (diagnostics_.errors() == 0) check_held();
    return std::move(out_);
  }

 private:
  void read_water() {
    TableReader water = root_.table("water", Presence::optional);
    const Values values = read_parameters(water_keys(), water);
    std::vector<std::string> faults;
    const ParameterBlock block(water_keys(), sizeof(Water), values, faults);
    if (faults.empty()) out_.scene.water = *static_cast<const Water*>(block.data());
  }

  void read_parts() {
    TableReader parts = root_.table("parts", Presence::required, "the pieces of the gear, a table each");
    const auto names = parts.keys();
    if (names.empty() && root_.has("parts"))
      parts.error("", "there are no parts: a scene needs at least one, such as [parts.net]");
    for (const auto& name : names) {
      if (name.find('.') != std::string::npos || name.empty())
        parts.error(name,
                    "a part's name must not be empty or hold a dot, which leads to its edges (net.fore)");
      if (parts.kind(name) == Kind::table) {
        TableReader part = parts.table(name);
        read_part(name, part);
      } else {
        parts.error(name, "a part is a table, such as [parts." + name + "]");
      }
    }
  }

  void read_part(const std::string& name, TableReader& table) {
    const std::string type_name =
        table.text("type", {.doc = "element type, plugin/element, such as priour/triangle"});
    const ElementType* type = find_type(type_name, table);
    Geometry geometry;
    Part part{.name = name, .type = type_name, .parameters = {}, .nodes = {}, .data = {}};
    if (type) {
      part.parameters = read_parameters(type->parameters, table);
      geometry = read_geometry(*type, table);
      read_extra_data(*type, geometry, table);
    } else {
      for (const auto& key : table.keys()) table.raw(key);  // nobody knows what may stand here
    }
    geometry.names.name = name, geometry.names.place = table.place();
    part.data = geometry.data;
    types_.push_back(type);
    out_.scene.parts.push_back(std::move(part));
    geometries_.push_back(std::move(geometry));
  }

  const ElementType* find_type(const std::string& name, TableReader& table) {
    if (name.empty()) return nullptr;
    try {
      return &registry_.element(name);
    } catch (const PluginRefused& e) {
      refused_ = true;
      table.error("type", e.what());
      return nullptr;
    }
  }

  Geometry read_geometry(const ElementType& type, TableReader& table) {
    switch (type.element.stencil) {
      case NETLOFT_BAR:
        return read_line(table);
      case NETLOFT_TRIANGLE:
        return read_panel(table);
      default:
        return read_point(table);
    }
  }

  /// Data of elements that the geometry does not give: the same number for every element of the part.
  void read_extra_data(const ElementType& type, Geometry& geometry, TableReader& table) {
    for (const auto& datum : type.data) {
      if (geometry.data.contains(datum.name)) continue;
      const auto values =
          table.reals(datum.name, {.unit = datum.unit, .doc = datum.doc, .count = exactly(datum.width)});
      const std::size_t elements = geometry.elements.size() / static_cast<std::size_t>(type.nodes());
      for (std::size_t e = 0; e < elements && values.size() == datum.width; ++e)
        geometry.data[datum.name].insert(geometry.data[datum.name].end(), values.begin(), values.end());
    }
  }

  void read_joins() {
    joiner_.emplace(geometries_);
    for (auto& join : root_.tables("join")) {
      const auto points =
          join.texts("points", {.doc = "two or more points or edges that become one", .count = {.least = 2}});
      std::vector<Joiner::Ends> sets;
      for (const auto& point : points)
        if (auto set = find_set(point, join, "points")) sets.push_back(*set);
      if (sets.size() != points.size()) continue;
      for (const auto& set : sets)
        if (set.own.size() != sets[0].own.size())
          join.error("points", "\"" + points[0] + "\" has " + std::to_string(sets[0].own.size()) +
                                   " nodes, \"" + points[static_cast<std::size_t>(&set - sets.data())] +
                                   "\" has " + std::to_string(set.own.size()) +
                                   "; only as many to as many can be joined");
      if (diagnostics_.errors() == 0) joiner_->join(sets);
    }
  }

  void assemble_nodes() {
    joiner_->number(out_.scene);
    for (std::size_t p = 0; p < geometries_.size(); ++p) {
      PartGeometry& names = geometries_[p].names;
      names.nodes = joiner_->nodes(p);
      for (const auto own : geometries_[p].elements) out_.scene.parts[p].nodes.push_back(names.nodes[own]);
      out_.parts.push_back(names);
    }
  }

  /// "net", "net.fore", "net.node-17": own nodes of one part. An error is put at `key` of `table`.
  std::optional<Joiner::Ends> find_set(const std::string& name, TableReader& table, std::string_view key) {
    const auto dot = name.find('.');
    const std::string part_name = name.substr(0, dot);
    std::vector<std::string> part_names;
    for (std::size_t p = 0; p < geometries_.size(); ++p) {
      const PartGeometry& part = geometries_[p].names;
      part_names.push_back(part.name);
      if (part.name != part_name) continue;
      Joiner::Ends ends{p, {}};
      if (dot == std::string::npos) {
        for (std::uint32_t i = 0; i < geometries_[p].node_count(); ++i) ends.own.push_back(i);
        return ends;
      }
      if (!find_own_nodes(part, geometries_[p].node_count(), name.substr(dot + 1), ends.own)) {
        if (geometries_[p].node_count() == 0) return {};  // its geometry is wrong, which is said already
        table.error(key, "\"" + part_name + "\" has no \"" + name.substr(dot + 1) + "\"",
                    name_hint(name.substr(dot + 1), set_names(part)));
        return {};
      }
      return ends;
    }
    table.error(key, "there is no part \"" + part_name + "\"", name_hint(part_name, part_names));
    return {};
  }

  void read_holds() {
    for (auto& hold : root_.tables("hold")) {
      const std::string on = hold.text("on", {.doc = "what is held: a part, an edge or a point (net.fore)"});
      const std::uint8_t axes = read_axes(hold);
      const auto at = read_places(hold);
      const std::string name = hold.text("name", {.doc = "name of the reaction", .fallback = on});
      if (on.empty()) continue;
      const auto set = find_set(on, hold, "on");
      if (!set) continue;
      Hold held{name, {}};
      for (const auto own : set->own) held.nodes.push_back(out_.parts[set->part].nodes[own]);
      fix(held.nodes, axes, at, hold);
      out_.holds.push_back(std::move(held));
    }
  }

  std::uint8_t read_axes(TableReader& hold) {
    const std::string text =
        hold.text("axes", {.doc = "along which it cannot move: letters of xyz", .fallback = "xyz"});
    std::uint8_t axes = 0;
    for (const char c : text) {
      if (c < 'x' || c > 'z') {
        hold.error("axes", "\"" + text + "\" is not made of the letters x, y and z");
        return kAllAxes;
      }
      axes = static_cast<std::uint8_t>(axes | (1 << (c - 'x')));
    }
    if (!axes) hold.error("axes", "holds nothing; leave the key out to hold all of x, y and z");
    return axes;
  }

  /// `at`: empty for "sketch", else points of the line along which the nodes are spread.
  std::vector<std::vector<double>> read_places(TableReader& hold) {
    if (!hold.has("at")) return {};
    if (hold.kind("at") == Kind::text) {
      hold.choice("at", {.allowed = {"sketch"}, .doc = "where the sketch has it, or points"});
      return {};
    }
    const Value* value = hold.raw("at");
    const Array* array = value ? value->as<Array>() : nullptr;
    const bool one_point = array && !array->items.empty() && array->items[0].kind() != Kind::array;
    const Range range = between(-1e6, 1e6);
    if (one_point)
      return {
          hold.reals("at", {.unit = "m", .doc = "where it is held", .range = range, .count = exactly(3)})};
    return hold.rows("at", {.unit = "m",
                            .doc = "line along which it is held",
                            .range = range,
                            .rows = {.least = 1},
                            .columns = exactly(3)});
  }

  void fix(const std::vector<std::uint32_t>& nodes, std::uint8_t axes,
           const std::vector<std::vector<double>>& at, TableReader& hold) {
    if (diagnostics_.errors()) return;
    if (at.size() == 1 && nodes.size() > 1)
      hold.error("at", std::to_string(nodes.size()) +
                           " nodes cannot be held in one point; give two or more points of a line");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      out_.scene.held[nodes[i]] |= axes;
      if (at.empty()) continue;
      const double t = nodes.size() > 1 ? double(i) / double(nodes.size() - 1) * double(at.size() - 1) : 0;
      const auto leg = std::min(static_cast<std::size_t>(t), at.size() - 1),
                 next = std::min(leg + 1, at.size() - 1);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (axes & (1 << axis))
          out_.scene.positions[3 * std::size_t{nodes[i]} + axis] =
              at[leg][axis] + (t - double(leg)) * (at[next][axis] - at[leg][axis]);
    }
  }

  void read_analysis() {
    TableReader analysis = root_.table("analysis", Presence::optional);
    const Values values = read_parameters(analysis_keys(), analysis);
    std::vector<std::string> faults;
    const ParameterBlock block(analysis_keys(), sizeof(AnalysisKeys), values, faults);
    // Tables of solvers that are not asked today may stay in the file.
    for (const auto& name : registry_.available()) analysis.has(name);
    if (!faults.empty()) return;
    const auto& keys = *static_cast<const AnalysisKeys*>(block.data());
    out_.analysis.solver = keys.solver;
    out_.analysis.limits = {keys.tolerance, static_cast<int>(keys.max_iterations), keys.max_seconds, nullptr};
    try {
      const SolverType& solver = registry_.solver(keys.solver);
      TableReader own =
          analysis.table(out_.analysis.solver.substr(0, out_.analysis.solver.find('/')), Presence::optional);
      out_.analysis.solver_parameters = read_parameters(solver.parameters, own);
    } catch (const PluginRefused& e) {
      refused_ = true;
      analysis.error("solver", e.what());
    }
  }

  void read_results() {
    TableReader results = root_.table("results", Presence::optional);
    for (const auto& name : results.keys()) {
      TableReader entry = results.table(name);
      ResultRequest request;
      request.name = name;
      request.of = entry.text("of", {.doc = "a part, an edge or a point"});
      request.take = entry.text("take", {.doc = "what of it, such as \"min z\" or \"max tension\""});
      if (request.of.empty() || request.take.empty()) continue;
      const auto set = find_set(request.of, entry, "of");
      if (!set) continue;
      request.part = static_cast<std::uint32_t>(set->part);
      for (const auto own : set->own) request.nodes.push_back(out_.parts[set->part].nodes[own]);
      const bool whole = request.of.find('.') == std::string::npos;
      if (!types_[set->part] || !understand(request, whole ? types_[set->part] : nullptr, entry)) continue;
      out_.results.push_back(std::move(request));
    }
  }

  void check_held() {
    std::vector<int> nodes_per_element;
    for (const auto* type : types_) nodes_per_element.push_back(type->nodes());
    for (const auto& fault : find_loose_parts(out_.scene, nodes_per_element))
      diagnostics_.error(out_.place_of(fault.part), fault.message);
  }

  TableReader root_;
  Registry& registry_;
  Diagnostics& diagnostics_;
  bool& refused_;
  LoadedScene out_;
  std::vector<const ElementType*> types_;
  std::vector<Geometry> geometries_;
  std::optional<Joiner> joiner_;
};

}  // namespace

LoadedScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       Registry& registry, Diagnostics& diagnostics, bool& refused) {
  const Document document = Document::load(file, overrides, diagnostics);
  if (diagnostics.errors()) return {};
  return SceneReader(document, file.stem().string(), registry, diagnostics, refused).read();
}

}  // namespace netloft::io
