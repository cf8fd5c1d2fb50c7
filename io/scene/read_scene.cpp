// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/read_scene.hpp"

#include "framework/scene/pairs.hpp"

#include "framework/registry/nearest.hpp"
#include "io/scene/catalogue_parts.hpp"
#include "io/scene/current.hpp"
#include "io/scene/geometry.hpp"
#include "io/scene/holder.hpp"
#include "io/scene/joiner.hpp"
#include "io/scene/keys.hpp"
#include "io/scene/parameter_reader.hpp"
#include "io/scene/part_names.hpp"
#include "io/scene/result_request.hpp"
#include "io/scene/riding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace netloft::io {

namespace {

/// Where a name was written, for errors about it.
struct Mention {
  std::string name;
  Place place;
  std::string path;  // "hold[0].on"
};

Mention mention(const std::string& name, const TableReader& table, std::string_view key) {
  return {name, table.place(key), table.path(key)};
}

/// The sentence of a refused plugin is its first line; where it was looked for stands below.
void report_refusal(TableReader& table, const char* key, const std::string& what) {
  const auto end = what.find('\n');
  std::string tried;
  for (auto at = end; at != std::string::npos;) {
    const auto begin = what.find_first_not_of(" \n", at);
    if (begin == std::string::npos) break;
    at = what.find('\n', begin);
    tried += (tried.empty() ? "" : "; ") + what.substr(begin, at - begin);
  }
  table.error(key, what.substr(0, end), tried);
}

void drop_repeats(std::vector<std::uint32_t>& nodes) {
  std::set<std::uint32_t> seen;
  std::erase_if(nodes, [&](std::uint32_t node) { return !seen.insert(node).second; });
}

/// Reads one scene; members are steps in the order they happen.
class SceneReader {
 public:
  SceneReader(const Value& root, std::string name, Registry& registry, Diagnostics& diagnostics,
              bool& refused)
      : root_(root, diagnostics), registry_(registry), diagnostics_(diagnostics), refused_(refused) {
    out_.scene.name = std::move(name);
    root_.has("catalogue");  // read with the parts that are named
  }

  LoadedScene read() {
    read_water();
    read_parts();
    read_joins();
    assemble_nodes();
    read_riders();
    add_companions();
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
    const ParameterBlock block(water_keys(), sizeof(SceneWater), values, faults);
    if (faults.empty()) out_.scene.water = *static_cast<const SceneWater*>(block.data());
    out_.scene.current = read_current(water);
  }

  void read_parts() {
    TableReader parts = root_.table("parts", Presence::required, "the pieces of the gear, a table each");
    if (root_.kind("parts") == Kind::table && parts.keys().empty())
      root_.error("parts", "there are no parts: a scene needs at least one, such as [parts.net]");
    for (const auto& name : parts.keys()) {
      check_part_name(name, parts);
      if (parts.kind(name) == Kind::table) {
        TableReader part = parts.table(name);
        if (part.has("on"))
          riders_.emplace_back(name, part);  // stands on parts that may come later
        else
          read_part(name, part);
      } else {
        parts.error(name, "a part is a table, such as [parts.net]");
      }
    }
  }

  void check_part_name(const std::string& name, TableReader& parts) {
    const bool has_dot = name.find('.') != std::string::npos;
    const std::string fault =
        has_dot ? "must not hold a dot, which leads to its edges (net.fore)" : name_fault(name);
    if (!fault.empty())
      diagnostics_.error(parts.place(name), "the name of a part, " + in_quotes(name) + ", " + fault);
  }

  void read_part(const std::string& name, TableReader& table) {
    const int errors_before = diagnostics_.errors();
    const std::string type_name = read_type_name(name, table);
    const ElementType* type = find_type(type_name, table);
    Geometry geometry;
    Part part;
    part.name = name, part.type = type_name;
    if (type) {
      part.parameters = read_parameters(parameters_with_companions(*type), table);
      part.laws = read_laws(*type, table);
      geometry = read_geometry(*type, table);
      read_extra_data(*type, geometry, table);
    } else {
      for (const auto& key : table.keys()) table.raw(key);  // nobody knows what may stand here
    }
    geometry.names.name = name, geometry.names.place = table.place();
    part.data = geometry.data;
    types_.push_back(type);
    is_sound_.push_back(diagnostics_.errors() == errors_before);
    out_.scene.parts.push_back(std::move(part));
    geometries_.push_back(std::move(geometry));
  }

  /// Elements of the same plugin that ride on this one: bending on the bars of a rope.
  std::vector<const ElementType*> companions_of(const ElementType& type) {
    std::vector<const ElementType*> riders;
    const std::string own = type.element.name;
    for (const auto& e : registry_.plugin(type.origin->name).elements)
      if (e.element.rides_on && own == e.element.rides_on) riders.push_back(&e);
    return riders;
  }

  /// A part's parameters are those of its elements and of all that ride on them, each name once.
  std::vector<netloft_parameter> parameters_with_companions(const ElementType& type) {
    std::vector<netloft_parameter> all = type.parameters;
    for (const auto* rider : companions_of(type))
      for (const auto& p : rider->parameters)
        if (std::none_of(all.begin(), all.end(),
                         [&](const auto& q) { return std::string_view(q.name) == p.name; }))
          all.push_back(p);
    return all;
  }

  /// `drag = "hydro/morison"`, or a table with `law` and the parameters of the law.
  std::map<std::string, LawChoice> read_laws(const ElementType& type, TableReader& table) {
    std::map<std::string, LawChoice> laws;
    for (const auto& slot : type.laws) {
      if (!table.has(slot.name)) continue;
      if (table.kind(slot.name) == Kind::table) {
        TableReader own = table.table(slot.name);
        const std::string name = own.text("law", {.doc = slot.doc, .fallback = slot.fallback});
        if (const LawType* law = find_law(name, own, "law"))
          laws[slot.name] = {name, read_parameters(law->parameters, own)};
      } else {
        const std::string name = table.text(slot.name, {.doc = slot.doc});
        if (find_law(name, table, slot.name)) laws[slot.name] = {name, {}};
      }
    }
    return laws;
  }

  const LawType* find_law(const std::string& name, TableReader& table, const char* key) {
    try {
      return &registry_.law(name);
    } catch (const PluginRefused& e) {
      refused_ = true;
      report_refusal(table, key, e.what());
      return nullptr;
    }
  }

  /// Parts on other parts, once the scene has its nodes.
  void read_riders() {
    for (auto& [name, table] : riders_) {
      const int errors_before = diagnostics_.errors();
      const ElementType* type = find_type(read_type_name(name, table), table);
      Part part;
      part.name = name;
      Geometry none;
      none.names.name = name, none.names.place = table.place();
      if (type) {
        part.type = type->type;
        part.parameters = read_parameters(parameters_with_companions(*type), table);
        part.laws = read_laws(*type, table);
        find_ground(*type, table, part);
      } else {
        for (const auto& key : table.keys()) table.raw(key);
      }
      types_.push_back(type);
      is_sound_.push_back(diagnostics_.errors() == errors_before);
      out_.parts.push_back(none.names);
      out_.scene.parts.push_back(std::move(part));
      geometries_.push_back(std::move(none));
    }
  }

  /// What `on` names, as nodes or as elements of the kind the rider stands on.
  void find_ground(const ElementType& type, TableReader& table, Part& rider) {
    const int errors_before = diagnostics_.errors();
    const std::vector<std::string> names =
        table.kind("on") == Kind::text
            ? std::vector<std::string>{table.text("on", {})}
            : table.texts("on", {.doc = "parts, edges or points it stands on", .count = {.least = 1}});
    if (diagnostics_.errors() > errors_before) return;
    const bool on_nodes = type.element.stencil == NETLOFT_NODE;
    const double number = on_nodes
                              ? table.real("number", {.doc = "pieces, shared out along what it stands on",
                                                      .range = between(0, 1e6),
                                                      .fallback = 1.0})
                              : 1;
    std::vector<std::uint32_t> nodes;
    std::vector<double> carried(out_.scene.node_count(), 0.0);
    for (std::size_t n = 0; n < names.size(); ++n) {
      const std::string& name = names[n];
      const Mention at = mention_of_item(name, table, "on", n);
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(n), name) !=
          names.begin() + static_cast<std::ptrdiff_t>(n))
        diagnostics_.error(at.place, at.path + ": " + in_quotes(name) + " is named twice");
      const auto set = find_nodes(at);
      if (!set || !is_sound_[set->part] || !types_[set->part]) continue;
      const Part& ground = out_.scene.parts[set->part];
      if (on_nodes) {
        const auto lengths = carried_length(out_.scene, ground, *types_[set->part]);
        for (std::size_t i = 0; i < carried.size(); ++i) carried[i] += lengths[i];
        for (const auto own : set->own) nodes.push_back(out_.parts[set->part].nodes[own]);
      } else if (name.find('.') == std::string::npos &&
                 types_[set->part]->element.stencil == type.element.stencil) {
        ride_on_elements(ground, rider);
      } else if (name.find('.') == std::string::npos && type.element.stencil == NETLOFT_TRIANGLE &&
                 !geometries_[set->part].faces.nodes.empty()) {
        ride_on_elements(faces_of(set->part), rider);
      } else {
        table.error("on", in_quotes(name) + " is no whole part that " + type.type + " can stand on");
      }
    }
    drop_repeats(nodes);
    if (on_nodes && !nodes.empty()) ride_on_nodes(nodes, carried, number, rider);
    for (const auto& datum : type.data)
      if (!rider.data.contains(datum.name) && !rider.nodes.empty()) {
        const auto values =
            table.reals(datum.name, {.unit = datum.unit, .doc = datum.doc, .count = exactly(datum.width)});
        for (std::size_t e = 0; e < rider.nodes.size() / static_cast<std::size_t>(type.nodes()); ++e)
          rider.data[datum.name].insert(rider.data[datum.name].end(), values.begin(), values.end());
      }
  }

  /// The triangles between the bars of a panel, as if they were its elements.
  Part faces_of(std::size_t part) const {
    Part faces;
    for (const auto own : geometries_[part].faces.nodes) faces.nodes.push_back(out_.parts[part].nodes[own]);
    faces.data = geometries_[part].faces.data;
    return faces;
  }

  void add_companions() {
    if (diagnostics_.errors()) return;
    for (std::size_t p = 0, parts = out_.scene.parts.size(); p < parts; ++p) {
      for (const auto* rider : companions_of(*types_[p])) {
        Part companion = make_companion(out_.scene.parts[p], *types_[p], *rider);
        if (companion.nodes.empty() && may_act(*rider, companion.parameters)) continue;  // it has no pairs
        companions_.push_back(rider);
        out_.scene.parts.push_back(std::move(companion));
        out_.parts.push_back({out_.scene.parts[p].name, out_.parts[p].place, {}, {}, {}, {}});
      }
      keep_own_parameters(out_.scene.parts[p], *types_[p]);
    }
  }

  /// What only the riders of a part know has been handed to them.
  static void keep_own_parameters(Part& part, const ElementType& type) {
    std::erase_if(part.parameters, [&](const auto& given) {
      return std::none_of(type.parameters.begin(), type.parameters.end(),
                          [&](const auto& p) { return given.first == p.name; });
    });
  }

  /// A part that --set has made by a slip of the pen has no type.
  std::string read_type_name(const std::string& name, TableReader& table) {
    std::vector<std::string> others;
    for (const auto& part : geometries_) others.push_back(part.names.name);
    if (const auto near = nearest(name, others); near && !table.has("type")) {
      table.error("type", "is missing: element type, plugin/element, such as priour/triangle",
                  "did you mean the part \"" + *near + "\"?");
      return {};
    }
    return read_name(table, "type", "element type, plugin/element, such as priour/triangle");
  }

  /// A text that must not be empty.
  std::string read_name(TableReader& table, const char* key, const char* doc) {
    const std::string name = table.text(key, {.doc = doc});
    if (name.empty() && table.kind(key) == Kind::text)
      table.error(key, "is empty (" + std::string(doc) + ")");
    return name;
  }

  const ElementType* find_type(const std::string& name, TableReader& table) {
    if (name.empty()) return nullptr;
    try {
      return &registry_.element(name);
    } catch (const PluginRefused& e) {
      refused_ = true;
      report_refusal(table, "type", e.what());
      return nullptr;
    }
  }

  Geometry read_geometry(const ElementType& type, TableReader& table) {
    switch (layout_of(type)) {
      case Layout::line:
        return read_line(table);
      case Layout::panel_in_triangles:
        return read_panel(table);
      case Layout::panel_in_bars:
        return read_panel_in_bars(table);
      default:
        return read_point(table);
    }
  }

  /// Data of elements that the geometry does not give: the same number for every element of the part.
  void read_extra_data(const ElementType& type, Geometry& geometry, TableReader& table) {
    const auto& given = geometry_data(layout_of(type));
    for (const auto& datum : type.data) {
      if (std::find(given.begin(), given.end(), datum.name) != given.end()) continue;
      const auto values =
          table.reals(datum.name, {.unit = datum.unit, .doc = datum.doc, .count = exactly(datum.width)});
      const std::size_t elements = geometry.elements.size() / static_cast<std::size_t>(type.nodes());
      for (std::size_t e = 0; e < elements && values.size() == datum.width; ++e)
        geometry.data[datum.name].insert(geometry.data[datum.name].end(), values.begin(), values.end());
    }
  }

  void read_joins() {
    joiner_.emplace(geometries_);
    for (auto& table : root_.tables("join")) {
      const int errors_before = diagnostics_.errors();
      const bool together = table.boolean("together", {.doc = "all nodes become one", .fallback = false});
      const auto points = table.texts("points", {.doc = "two or more points or edges that become one",
                                                 .count = {.least = together ? 1u : 2u}});
      if (diagnostics_.errors() > errors_before) continue;
      std::vector<Joiner::Ends> sets;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (auto set = find_nodes(mention_of_item(points[i], table, "points", i))) sets.push_back(*set);
      if (sets.size() != points.size() || !can_be_joined(sets, points, table, together)) continue;
      joins_.push_back({sets, mention("", table, "points"), together});
      joins_.back().make(*joiner_);
    }
    if (diagnostics_.errors() == 0) check_joins();
  }

  /// One of the names that stand at a key; of a name that stands there alone, the key itself.
  Mention mention_of_item(const std::string& name, TableReader& table, std::string_view key, std::size_t i) {
    Mention m = mention(name, table, key);
    const Array* array = table.raw(key) ? table.raw(key)->as<Array>() : nullptr;
    if (!array || i >= array->items.size()) return m;
    m.place = array->items[i].place;
    m.path += "[" + std::to_string(i) + "]";
    return m;
  }

  bool can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                     TableReader& table, bool together) {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (!is_sound_[sets[s].part]) return false;  // it has no true number of nodes
      if (!together && sets[s].own.size() != sets[0].own.size()) {
        table.error("points",
                    in_quotes(points[0]) + " has " + std::to_string(sets[0].own.size()) + " nodes, " +
                        in_quotes(points[s]) + " has " + std::to_string(sets[s].own.size()) +
                        "; only as many to as many can be joined",
                    "give both the same cells, join node by node (net.node-17), or write together = true to "
                    "gather all in one");
        return false;
      }
      for (std::size_t t = 0; t < s; ++t)
        if (sets[s].part == sets[t].part && sets[s].own == sets[t].own) {
          table.error("points", in_quotes(points[s]) + " is joined to itself");
          return false;
        }
    }
    return true;
  }

  /// Joins must leave every element its size. The first that does not is found by making them again one by
  /// one.
  void check_joins() {
    if (!joiner_->find_collapse(nodes_per_element())) return;
    Joiner again(geometries_);
    for (const auto& join : joins_) {
      join.make(again);
      if (const auto fault = again.find_collapse(nodes_per_element())) {
        diagnostics_.error(join.at.place,
                           join.at.path + ": " + in_quotes(out_.scene.parts[fault->part].name) + " element " +
                               std::to_string(fault->element) +
                               " would have two of its corners in one node, and no size",
                           "join nodes that are no neighbours: more cells make room");
        return;
      }
    }
  }

  std::vector<int> nodes_per_element() const {
    std::vector<int> counts;
    for (const auto* type : types_) counts.push_back(type->nodes());
    for (const auto* type : companions_) counts.push_back(type->nodes());
    return counts;
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

  /// "net", "net.fore", "net.node-17": own nodes of one part. If there are none, it is said where they were
  /// mentioned.
  std::optional<Joiner::Ends> find_set(const Mention& m) {
    const auto dot = m.name.find('.');
    const auto p = find_part(m, m.name.substr(0, dot));
    if (!p) return {};
    const Geometry& geometry = geometries_[*p];
    Joiner::Ends ends{*p, {}};
    if (dot == std::string::npos) {
      ends.own.resize(geometry.node_count());
      std::iota(ends.own.begin(), ends.own.end(), 0u);
      return ends;
    }
    const std::string name = m.name.substr(dot + 1);
    if (is_rider(geometry.names.name)) {
      refuse_rider(m, geometry.names.name);
      return {};
    }
    if (find_own_nodes(geometry.names, geometry.node_count(), name, ends.own)) return ends;
    const bool hangs_on_geometry =
        geometry.node_count() == 0 || name.starts_with("node-") || name == "middle";
    if (is_sound_[*p] || !hangs_on_geometry)  // else that the geometry is wrong is said already
      diagnostics_.error(m.place,
                         m.path + ": " + in_quotes(geometry.names.name) + " has no " + in_quotes(name),
                         set_hint(geometry.names, geometry.node_count(), name));
    return {};
  }

  /// The same where nodes are wanted. A part that stands on others has none of its own.
  std::optional<Joiner::Ends> find_nodes(const Mention& m) {
    auto set = find_set(m);
    if (!set || !set->own.empty() || !is_sound_[set->part]) return set;
    refuse_rider(m, m.name);
    return {};
  }

  void refuse_rider(const Mention& m, const std::string& name) {
    diagnostics_.error(m.place,
                       m.path + ": " + in_quotes(name) + " stands on other parts and has no nodes of its own",
                       "name what it stands on");
  }

  bool is_rider(const std::string& name) const {
    return std::any_of(riders_.begin(), riders_.end(), [&](const auto& r) { return r.first == name; });
  }

  std::optional<std::size_t> find_part(const Mention& m, const std::string& name) {
    std::vector<std::string> names, owners;
    for (std::size_t p = 0; p < geometries_.size(); ++p) {
      const PartGeometry& part = geometries_[p].names;
      if (part.name == name) return p;
      names.push_back(part.name);
      if (part.sets.contains(name)) owners.push_back(part.name + "." + name);
    }
    if (is_rider(name))
      refuse_rider(m, name);
    else if (m.name.empty())
      diagnostics_.error(m.place, m.path + " is empty; a part, an edge or a point is wanted (net.fore)");
    else
      diagnostics_.error(m.place, m.path + ": there is no part " + in_quotes(name),
                         owners.empty() ? name_hint(name, names) : "did you mean \"" + owners[0] + "\"?");
    return {};
  }

  void read_holds() {
    Holder holder(out_.scene);
    for (auto& table : root_.tables("hold")) {
      const int errors_before = diagnostics_.errors();
      const HoldEntry entry = read_hold(table);
      check_hold_name(entry, table);
      if (entry.on.empty() && table.kind("on") != Kind::text) continue;
      const auto set = find_nodes(mention(entry.on, table, "on"));
      if (!set || !is_sound_[set->part] || diagnostics_.errors() > errors_before) continue;
      std::vector<std::uint32_t> nodes;
      for (const auto own : set->own) nodes.push_back(out_.parts[set->part].nodes[own]);
      out_.holds.push_back(holder.hold(entry, nodes, table));
      guide(read_course(table), entry, out_.holds.back(), table);
    }
  }

  /// Lets what a hold holds go along a course.
  void guide(Course course, const HoldEntry& entry, const Hold& hold, TableReader& table) {
    if (course.knots.empty()) return;
    const char* key = table.has("velocity") ? "velocity" : "displacement";
    const bool is_turned = entry.frame || std::any_of(hold.nodes.begin(), hold.nodes.end(), [&](auto node) {
                             return out_.scene.frames.contains(node);
                           });
    if (is_turned) table.error(key, "does not go with along and plane", "hold it by axes to move it");
    out_.scene.guides.push_back({hold.nodes, hold.axes, std::move(course)});
  }

  void check_hold_name(const HoldEntry& entry, TableReader& table) {
    const char* key = table.has("name") ? "name" : "on";
    const auto [earlier, is_new] = hold_names_.emplace(entry.name, table.place(key));
    if (!is_new && !entry.name.empty())
      table.error(key,
                  "there is a hold named " + in_quotes(entry.name) + " already, at " +
                      diagnostics_.where(earlier->second),
                  "give one of them a name of its own: name = \"…\"");
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
    out_.analysis.automatic = out_.analysis.solver == "auto";
    if (out_.analysis.automatic) out_.analysis.solver = "newton";
    out_.analysis.continuation =
        keys.continuation == 1 || (keys.continuation == 0 && out_.analysis.automatic);
    if (out_.analysis.solver.empty()) {
      analysis.error("solver", "is empty; the name of a solver is wanted, such as newton");
      return;
    }
    out_.analysis.tangent = static_cast<TangentChoice>(keys.tangent);
    out_.analysis.limits = {keys.tolerance, static_cast<int>(keys.max_iterations), keys.max_seconds, nullptr};
    out_.analysis.kind = static_cast<AnalysisKind>(keys.kind);
    try {
      if (read_time(analysis)) return;
      const SolverType& solver = registry_.solver(out_.analysis.solver);
      TableReader own =
          analysis.table(out_.analysis.solver.substr(0, out_.analysis.solver.find('/')), Presence::optional);
      out_.analysis.solver_parameters = read_parameters(solver.parameters, own);
      // A step begins so near its end that Newton's method wants no damping.
      if (out_.analysis.kind == AnalysisKind::dynamics && out_.analysis.solver == "newton")
        out_.analysis.solver_parameters.try_emplace("damping", 0.0);
    } catch (const PluginRefused& e) {
      refused_ = true;
      report_refusal(analysis, "solver", e.what());
    }
  }

  /// What speaks of time. True: no solver of an equilibrium is wanted.
  bool read_time(TableReader& analysis) {
    Analysis& a = out_.analysis;
    const bool moves = a.kind == AnalysisKind::dynamics;
    a.settles = !moves && is_integrator(registry_, a.solver);
    if (!moves && !a.settles) {
      for (const auto& key : dynamics_keys()) analysis.has(key.name);  // may stay for another day
      return false;
    }
    a.dynamics = read_dynamics(analysis, registry_);
    if (!analysis.has("tangent")) a.tangent = TangentChoice::symmetric;
    if (moves && !analysis.has("tolerance")) a.limits.tolerance = 1e-5;
    if (moves && !analysis.has("max_iterations")) a.limits.iterations = 25;
    a.continuation = a.continuation && !moves && !a.settles;
    if (a.settles) read_settling(analysis);
    return a.settles;
  }

  /// An integrator as a solver: `solver` is its name, and motion has to die.
  void read_settling(TableReader& analysis) {
    Analysis& a = out_.analysis;
    a.dynamics.integrator = a.solver;
    const IntegratorType& type = registry_.integrator(a.solver);
    TableReader own = analysis.table(a.solver.substr(0, a.solver.find('/')), Presence::optional);
    a.dynamics.integrator_parameters = read_parameters(type.parameters, own);
    if (!analysis.has("mass_damping")) a.dynamics.march.mass_damping = 1;
    if (!analysis.has("duration")) a.dynamics.march.duration = 1e6;
    if (!analysis.has("max_iterations")) a.limits.iterations = 1000000;
    a.dynamics.march.output_interval = 0, a.dynamics.march.budget = false;
  }

  void read_results() {
    const bool holds_are_known = diagnostics_.errors() == 0;
    TableReader results = root_.table("results", Presence::optional);
    for (const auto& name : results.keys()) {
      if (const std::string fault = name_fault(name); !fault.empty())
        diagnostics_.error(results.place(name), "the name of a result, " + in_quotes(name) + ", " + fault);
      TableReader entry =
          results.table(name, Presence::required, "such as { of = \"net\", take = \"min z\" }");
      ResultRequest request;
      request.name = name;
      request.of = read_name(entry, "of", "a part, an edge or a point");
      request.take = read_name(entry, "take", "what of it, such as \"min z\" or \"max tension\"");
      if (request.of.empty() || request.take.empty()) continue;
      const auto set = find_set(mention(request.of, entry, "of"));
      if (!set || !types_[set->part]) continue;
      request.part = static_cast<std::uint32_t>(set->part);
      for (const auto own : set->own) request.nodes.push_back(out_.parts[set->part].nodes[own]);
      drop_repeats(request.nodes);  // of a part that is joined to itself
      if (!understand(request, *types_[set->part], entry)) continue;
      if (request.nodes.empty() && is_sound_[set->part] && request.source != ResultRequest::Source::output)
        refuse_rider(mention("", entry, "take"), request.of);
      if (holds_are_known) check_reaction(request, entry);
      out_.results.push_back(std::move(request));
    }
  }

  void check_reaction(const ResultRequest& request, TableReader& entry) {
    const int axes = request.axis == 3 ? kAllAxes : 1 << request.axis;
    const bool has_one = std::any_of(request.nodes.begin(), request.nodes.end(),
                                     [&](auto node) { return out_.scene.held[node] & axes; });
    if (request.source == ResultRequest::Source::reaction && !has_one)
      entry.error(
          "take",
          "nothing of " + in_quotes(request.of) + " is held there, so there is no " + request.quantity,
          "reactions are of what a [[hold]] holds");
  }

  void check_held() {
    for (const auto& fault : find_loose_parts(out_.scene, nodes_per_element()))
      diagnostics_.error(out_.place_of(fault.part), fault.message);
  }

  TableReader root_;
  Registry& registry_;
  Diagnostics& diagnostics_;
  bool& refused_;
  LoadedScene out_;
  /// A [[join]] that was made, and where it stands.
  struct Join {
    std::vector<Joiner::Ends> sets;
    Mention at;
    bool together;  // all nodes in one
    void make(Joiner& joiner) const { together ? joiner.gather(sets) : joiner.join(sets); }
  };

  std::vector<const ElementType*> types_, companions_;
  std::vector<std::pair<std::string, TableReader>> riders_;
  std::vector<bool> is_sound_;  // parts without an error in their table
  std::vector<Join> joins_;
  std::map<std::string, Place> hold_names_;
  std::vector<Geometry> geometries_;
  std::optional<Joiner> joiner_;
};

}  // namespace

LoadedScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       Registry& registry, Diagnostics& diagnostics, bool& refused) {
  const Document document = Document::load(file, overrides, diagnostics);
  if (diagnostics.errors()) return {};
  Value root = document.root();
  const auto catalogues = put_catalogue_parts(root, file.parent_path(), registry, diagnostics);
  LoadedScene loaded = SceneReader(root, file.stem().string(), registry, diagnostics, refused).read();
  loaded.files = document.files();
  loaded.files.insert(loaded.files.end(), catalogues.begin(), catalogues.end());
  return loaded;
}

}  // namespace netloft::io
