// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/read_scene.hpp"

#include "framework/registry/nearest.hpp"
#include "framework/scene/pairs.hpp"
#include "io/gear/check.hpp"
#include "io/gear/read_plan.hpp"
#include "io/scene/analysis.hpp"
#include "io/scene/beds.hpp"
#include "io/scene/bodies.hpp"
#include "io/scene/catalogue_parts.hpp"
#include "io/scene/current.hpp"
#include "io/scene/draft.hpp"
#include "io/scene/element_choice.hpp"
#include "io/scene/gear_parts.hpp"
#include "io/scene/halves.hpp"
#include "io/scene/holder.hpp"
#include "io/scene/idle_keys.hpp"
#include "io/scene/keys.hpp"
#include "io/scene/mesh_parts.hpp"
#include "io/scene/one_sided_holds.hpp"
#include "io/scene/own_data.hpp"
#include "io/scene/parameter_reader.hpp"
#include "io/scene/part_names.hpp"
#include "io/scene/result_request.hpp"
#include "io/scene/riders.hpp"
#include "io/scene/tauti.hpp"
#include "io/scene/thickness.hpp"
#include "io/scene/tow.hpp"
#include "io/scene/waves.hpp"
#include "io/scene/winches.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace netloft::io {

namespace {

void drop_repeats(std::vector<std::uint32_t>& nodes) {
  std::set<std::uint32_t> seen;
  std::erase_if(nodes, [&](std::uint32_t node) { return !seen.insert(node).second; });
}

/// Reads one scene; members are steps in the order they happen.
class SceneReader {
 public:
  /// `plan`: of a gear that stands in the scene; null without.
  SceneReader(const Value& root, const NetPlan* plan, const std::filesystem::path& file, Registry& registry,
              Diagnostics& diagnostics, bool& refused)
      : root_(root, diagnostics),
        registry_(registry),
        diagnostics_(diagnostics),
        refused_(refused),
        elements_(registry, refused),
        draft_(diagnostics),
        out_(draft_.out),
        meshes_(file.parent_path(), diagnostics),
        plan_(plan) {
    out_.scene.name = file.stem().string();
    root_.has("catalogue");  // read with the parts that are named
    if (plan) gear_.emplace(*plan, root_, elements_, draft_);
  }

  LoadedScene read() {
    if (gear_ && !gear_->is_divided()) return std::move(out_);
    read_water();
    if (gear_) {
      read_bodies_of_plan();
      gear_->add_parts();
    }
    read_parts();
    if (!gear_) read_bodies();
    read_joins();
    assemble_nodes();
    add_bodies(draft_, diagnostics_);
    if (gear_) gear_->add_pieces();
    read_riders();
    if (gear_) read_contacts();
    add_companions();
    if (gear_) gear_->hold_middle(), gear_->hold_blocks();
    read_holds();
    if (gear_) gear_->follow_holds();
    place_points(out_.scene);
    out_.analysis = read_analysis(root_.table("analysis", Presence::optional), registry_, refused_);
    take_model();
    if (out_.analysis.kind == AnalysisKind::statics && diagnostics_.errors() == 0)
      check_guides(), check_waves();
    read_results();
    if (!bottom_.empty() && diagnostics_.errors() == 0) lay_bottom();
    if (plan_) ready_winches(*plan_, registry_, out_, diagnostics_);
    if (gear_ && out_.gear && out_.gear->times == 2) check_symmetry();
    root_.finish();
    out_.files = meshes_.files();
    if (diagnostics_.errors() > 0) return std::move(out_);
    check_held();
    check_ground();
    check_bed();
    check_beds(out_, diagnostics_);
    check_crossings();
    one_sided_.report(draft_, diagnostics_);
    return std::move(out_);
  }

 private:
  void read_water() {
    TableReader water = root_.table("water", Presence::optional);
    const Values values = read_parameters(water_keys(), water);
    std::vector<std::string> faults;
    const ParameterBlock block(water_keys(), sizeof(WaterKeys), values, faults);
    if (faults.empty()) take_water(*static_cast<const WaterKeys*>(block.data()), water);
    out_.scene.current = read_current(water);
    if ((says_tow_ = root_.has("tow"))) read_tow(root_.table("tow"), out_.scene);
    if (root_.has("bed")) bottom_ = read_bed(root_.table("bed"), out_.scene);
    read_ship();
    out_.scene.waves = read_waves(water, out_.scene);
  }

  /// Waves act on what moves; a static result would be one of still water.
  void check_waves() {
    if (!out_.scene.waves ||
        diagnostics_.where(root_.table("analysis", Presence::optional).place("kind")).starts_with("--set"))
      return;
    TableReader water = root_.table("water");
    water.error("waves", "act on nothing in a static analysis",
                "kind = \"dynamic\" in [analysis], or leave them out");
  }

  /// A ship tows the gear of a net plan.
  void read_ship() {
    if (!root_.has("ship")) return;
    if (!plan_)
      return root_.error("ship", "tows a gear from a net plan, and there is none",
                         "[tow] speed and a [[hold]] tow other gears");
    if (says_tow_)
      diagnostics_.error(plan_->ship->speed_place, "ship.speed stands beside [tow], and either tows the gear",
                         "leave out one of them");
    says_tow_ = true;
    out_.scene.ground = {plan_->ship->speed, 0, 0};
    out_.scene.current.tow = out_.scene.ground;
  }

  /// A model at 1 : s in water of viscosity ν, with velocities smaller by √s, has the Reynolds numbers of the
  /// gear in water of viscosity ν s^1.5, and where nothing stretches all else is similar (W. Froude).
  void take_water(const WaterKeys& keys, TableReader& water) {
    out_.scene.water = keys;
    if (keys.model_twine_scale == 0) {
      out_.scene.water.viscosity *= std::pow(keys.model_scale, 1.5);
      return;
    }
    const bool is_whole = keys.model_twine_scale >= 1;
    if (!is_whole || keys.model_twine_scale > keys.model_scale)
      water.error("model_twine_scale",
                  "is outside [1, " + format(keys.model_scale) +
                      "]: by Tauti's rule twines are scaled less than lengths",
                  is_whole ? "model_scale = " + format(keys.model_twine_scale) + ", or more"
                           : "model_twine_scale = 1, or more; none for Froude's rule");
    tauti_ = TautiModel{keys.model_scale, keys.model_twine_scale};
    out_.scene.water.viscosity *= tauti_->viscosity_of_netting();
  }

  /// Forces of an equilibrium are similar by Tauti's rule, masses are not.
  void take_model() {
    if (!tauti_ || diagnostics_.errors() > 0) return;
    if (const Part* dry = find_part_above_water(out_.scene))
      root_.table("water").error("model_twine_scale", "Tauti's rule is for what is under water, and " +
                                                          in_quotes(dry->name) + " may be above it");
    if (out_.analysis.kind == AnalysisKind::dynamics)
      root_.table("water").error("model_twine_scale",
                                 "Tauti's rule knows no masses: it is for kind = \"static\"");
    tauti_->scale_ropes_and_floats(out_.scene);
  }

  void read_parts() {
    TableReader parts = root_.table("parts", gear_ ? Presence::optional : Presence::required,
                                    "the pieces of the gear, a table each");
    if (!gear_ && root_.kind("parts") == Kind::table && parts.keys().empty())
      root_.error("parts", "there are no parts: a scene needs at least one, such as [parts.net]");
    for (const auto& name : parts.keys()) {
      check_part_name(name, parts);
      if (parts.kind(name) == Kind::table) {
        TableReader part = parts.table(name);
        if (part.has("on")) {
          riders_.emplace_back(name, part);  // stands on parts that may come later
          draft_.announce_rider(name);
        } else {
          read_part(name, part);
        }
      } else {
        parts.error(name, "a part is a table, such as [parts.net]");
      }
    }
  }

  /// Parts that make rigid bodies. Their elements are those of `type`; others may stand on them.
  void read_bodies() {
    TableReader bodies = root_.table("bodies", Presence::optional, "rigid bodies, a table each");
    for (const auto& name : bodies.keys()) {
      check_part_name(name, bodies);
      if (const auto same = draft_.part_number(name))
        diagnostics_.error(bodies.place(name), "there is a part named " + in_quotes(name) + " already, at " +
                                                   diagnostics_.where(draft_.geometries[*same].names.place));
      if (bodies.kind(name) != Kind::table) {
        bodies.error(name, "a body is a table, such as [bodies.door]");
        continue;
      }
      TableReader body = bodies.table(name);
      read_part(name, body, Home::bodies);
    }
  }

  /// Those of a net plan, to starboard and to port.
  void read_bodies_of_plan() {
    TableReader bodies = root_.table("bodies", Presence::optional);
    for (const GearBody& body : gear_->bodies()) {
      if (!draft_.is_sound.empty() && !draft_.is_sound.back()) return;  // said once, not for both sides
      const BodyOfPlan place = gear_->place_of(body);
      TableReader table = bodies.table(body.body->name);
      table.has("stands");
      read_part(body.name, table, Home::bodies, body.body->stands == Standing::pair ? &place : nullptr);
      gear_->tie(body, draft_.geometries.size() - 1);
    }
  }

  void check_part_name(const std::string& name, TableReader& parts) {
    const bool has_dot = name.find('.') != std::string::npos;
    const std::string fault =
        has_dot ? "must not hold a dot, which leads to its edges (net.fore)" : name_fault(name);
    if (!fault.empty())
      diagnostics_.error(parts.place(name), "the name of a part, " + in_quotes(name) + ", " + fault);
    if (gear_ && gear_->has_name(name))
      diagnostics_.error(
          parts.place(name), "the net plan has something named " + in_quotes(name) + " already",
          "[elements." + name + "] says more of it; parts of the scene have names of their own");
  }

  enum class Home { parts, bodies };

  void read_part(const std::string& name, TableReader& table, Home home = Home::parts,
                 const BodyOfPlan* place = nullptr) {
    const int errors_before = diagnostics_.errors();
    const std::string type_name = read_type_name(name, table);
    const ElementType* type = elements_.find(type_name, table);
    if (type && type->is_on_body() != (home == Home::bodies)) {
      table.error("type",
                  type->type + (type->is_on_body() ? " stands on a rigid body" : " stands on no rigid body"),
                  type->is_on_body() ? "[bodies." + name + "] makes one; on = \"…\" names one that there is"
                                     : "[parts." + name + "], or a type such as body/solid");
      type = nullptr;
    }
    Geometry geometry;
    Part part;
    part.name = name, part.type = type_name;
    if (type) {
      elements_.read(*type, table, part);
      geometry = place ? read_body(table, place) : read_geometry(*type, name, table);
      read_extra_data(*type, geometry, table);
    } else {
      for (const auto& key : table.keys()) table.raw(key);  // nobody knows what may stand here
    }
    geometry.names.name = name, geometry.names.place = table.place();
    if (is_turned(table) && diagnostics_.errors() == errors_before)
      check_turned_netting(part, table.table("panel").place("netting"), diagnostics_);
    const auto fault =
        table.has("mesh") ? std::nullopt : thickness_fault(part, geometry);  // meshes have joints
    if (fault && diagnostics_.errors() == errors_before)
      table.error(fault->key, fault->message, kThicknessCure);
    const bool is_sound =
        diagnostics_.errors() == errors_before && !(table.has("mesh") && meshes_.has_failed());
    draft_.add_part(std::move(part), std::move(geometry), type, is_sound);
  }

  static bool is_turned(TableReader& part) {
    const Value* panel = part.kind("panel") == Kind::table ? part.raw("panel") : nullptr;
    const Member* netting = panel ? panel->as<Table>()->find("netting") : nullptr;
    const std::string* word = netting ? netting->value.as<std::string>() : nullptr;
    return word && *word == "t90";
  }

  /// Parts on other parts, once the scene has its nodes.
  void read_riders() {
    for (auto& [name, table] : riders_) read_rider(name, table);
  }

  const ElementType* read_rider(const std::string& name, TableReader& table) {
    const int errors_before = diagnostics_.errors();
    const ElementType* type = elements_.find(read_type_name(name, table), table);
    Part part;
    part.name = name;
    if (type) {
      elements_.read(*type, table, part);
      stand_on_others(*type, table, draft_, part);
    } else {
      for (const auto& key : table.keys()) table.raw(key);
    }
    draft_.add_rider(std::move(part), table.place(), type, diagnostics_.errors() == errors_before);
    return type;
  }

  /// Parts of the plan that touch the bed.
  void read_contacts() {
    const std::set<std::uint32_t> carried = carried_by_beds();
    if (const auto all = gear_->contacts(carried); !all.empty() && !out_.scene.bed.is_there)
      return diagnostics_.error(
          all.front().second.place,
          "elements." + std::string(kContact) + ": there is no bed that the gear could touch",
          "[bed] depth = \"100 m\"");
    for (const auto& [name, said] : gear_->contacts(carried)) {
      TableReader table(said, diagnostics_, "elements." + std::string(kContact));
      const ElementType* type = elements_.find(read_type_name(name, table), table);
      if (type && !rests_on_bed(*type))
        return table.error("type", type->type + " does not rest on the bed of the scene",
                           "such as seabed/bed");
      read_rider(name, table);
      table.finish();
      if (diagnostics_.errors()) return;  // said once, not of every rope
    }
    if (out_.scene.bed.is_there && gear_->sinks_into_bed(carried))
      diagnostics_.warning(
          root_.table("bed").place(), "the footrope passes through the bed: no part carries the gear there",
          "[elements.contact] seabed = { friction = 0.47 } lets all of the plan that touches the bed "
          "rest on it");
  }

  /// Nodes that parts of the scene carry which stand on a bed.
  std::set<std::uint32_t> carried_by_beds() const {
    std::set<std::uint32_t> nodes;
    for (std::size_t p = 0; p < draft_.types.size(); ++p)
      if (draft_.types[p] && rests_on_bed(*draft_.types[p]))
        nodes.insert(out_.scene.parts[p].nodes.begin(), out_.scene.parts[p].nodes.end());
    return nodes;
  }

  static bool rests_on_bed(const ElementType& type) {
    const auto both = NETLOFT_READS_BED | NETLOFT_FROM_OUTSIDE;
    return type.element.stencil == NETLOFT_NODE && std::ranges::any_of(type.terms, [&](const auto& term) {
             return (term.traits & both) == std::uint32_t{both};
           });
  }

  void add_companions() {
    if (diagnostics_.errors()) return;
    for (std::size_t p = 0, parts = out_.scene.parts.size(); p < parts; ++p) {
      const ElementType& type = *draft_.types[p];
      for (const auto* rider : elements_.companions_of(type)) {
        Part companion = make_companion(out_.scene.parts[p], type, *rider);
        if (companion.nodes.empty() && may_act(*rider, companion.parameters)) continue;  // it has no pairs
        companions_.push_back(rider);
        out_.scene.parts.push_back(std::move(companion));
        out_.parts.push_back({out_.scene.parts[p].name, out_.parts[p].place, {}, {}, {}, {}});
      }
      keep_own_parameters(out_.scene.parts[p], type);
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
    for (const auto& part : draft_.geometries) others.push_back(part.names.name);
    if (const auto near = nearest(name, others); near && !table.has("type")) {
      table.error("type", "is missing: element type, plugin/element, such as priour/triangle",
                  "did you mean the part \"" + *near + "\"?");
      return {};
    }
    return read_name(table, "type", "element type, plugin/element, such as priour/triangle");
  }

  Geometry read_geometry(const ElementType& type, const std::string& name, TableReader& table) {
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
        table.error("type", "has no place of its own: it stands between parts that meet",
                    "name them: on = [\"first\", \"second\"]");
        return {};
    }
  }

  /// Data of elements that the geometry does not give: the same number for every element of the part.
  void read_extra_data(const ElementType& type, Geometry& geometry, TableReader& table) {
    const std::size_t elements = geometry.elements.size() / static_cast<std::size_t>(type.nodes());
    for (const auto& datum : type.data)
      if (!find_datum_on(type.element.stencil, datum.name))
        read_own_datum(type, datum, elements, table, geometry.data);
  }

  void read_joins() {
    joiner_.emplace(draft_.geometries);
    meshes_.connect(*joiner_);
    if (gear_) gear_->join(*joiner_);
    for (auto& table : root_.tables("join")) {
      if (gear_ && is_seam(table)) continue;
      read_join(table);
    }
    if (diagnostics_.errors() == 0) check_joins();
  }

  void read_join(TableReader& table) {
    const int errors_before = diagnostics_.errors();
    const bool together = table.boolean("together", {.doc = "all nodes become one", .fallback = false});
    const auto points = table.texts("points", {.doc = "two or more points or edges that become one",
                                               .count = {.least = together ? 1u : 2u}});
    if (diagnostics_.errors() > errors_before) return;
    std::vector<Joiner::Ends> sets;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (auto set = draft_.find_nodes(mention_of_item(points[i], table, "points", i))) sets.push_back(*set);
    if (sets.size() != points.size() || !can_be_joined(sets, points, table, together)) return;
    joins_.push_back({sets, mention("", table, "points"), together});
    joins_.back().make(*joiner_);
  }

  bool can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                     TableReader& table, bool together) {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (!draft_.is_sound[sets[s].part]) return false;  // it has no true number of nodes
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
    Joiner again(draft_.geometries);
    meshes_.connect(again);
    if (gear_) gear_->join(again);
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
    for (const auto* type : draft_.types) counts.push_back(type->nodes());
    for (const auto* type : companions_) counts.push_back(type->nodes());
    return counts;
  }

  void assemble_nodes() {
    joiner_->number(out_.scene);
    for (std::size_t p = 0; p < draft_.geometries.size(); ++p) {
      PartGeometry& names = draft_.geometries[p].names;
      names.nodes = joiner_->nodes(p);
      for (const auto own : draft_.geometries[p].elements)
        out_.scene.parts[p].nodes.push_back(names.nodes[own]);
      out_.parts.push_back(names);
    }
  }

  void read_holds() {
    Holder holder(out_.scene);
    for (auto& table : root_.tables("hold")) {
      const int errors_before = diagnostics_.errors();
      const HoldEntry entry = read_hold(table);
      check_hold_name(entry, table);
      if (table.kind("on") != Kind::text && table.kind("on") != Kind::array) continue;
      const auto nodes = find_held(entry, table);
      if (nodes.empty() || diagnostics_.errors() > errors_before) continue;
      out_.holds.push_back(holder.hold(entry, nodes, table));
      guide(read_course(table), entry, out_.holds.back(), table);
      if (gear_ && out_.gear->times == 1) one_sided_.add(entry, table.place("on"));
    }
  }

  /// Nodes of all that a hold names; empty where something is wrong with it.
  std::vector<std::uint32_t> find_held(const HoldEntry& entry, TableReader& table) {
    std::vector<std::uint32_t> nodes;
    std::size_t sets = 0;
    for (std::size_t i = 0; i < entry.on.size(); ++i)
      for (const auto& m : draft_.expand(mention_of_item(entry.on[i], table, "on", i))) {
        const auto set = draft_.find_nodes(m);
        if (!set || !draft_.is_sound[set->part]) return {};
        const auto own = draft_.scene_nodes(*set);
        if (const auto carried = std::find_if(own.begin(), own.end(), [&](auto n) { return is_carried(n); });
            carried != own.end()) {
          refuse_carried(m, *carried);
          return {};
        }
        nodes.insert(nodes.end(), own.begin(), own.end());
        ++sets;
      }
    if (sets > 1) drop_repeats(nodes);
    return nodes;
  }

  bool is_carried(std::uint32_t node) const { return body_that_carries(out_.scene, node); }
  void refuse_carried(const Mention& m, std::uint32_t node) {
    const std::string body = body_that_carries(out_.scene, node)->name;
    diagnostics_.error(m.place,
                       m.path + ": " + in_quotes(m.name) + " holds a point of the body " + in_quotes(body) +
                           ", which carries it",
                       "hold its origin, on = \"" + body + ".origin\"; turns = \"not\" in [bodies." + body +
                           "] holds its attitude");
  }

  /// Lets what a hold holds go along a course.
  void guide(Course course, const HoldEntry& entry, const Hold& hold, TableReader& table) {
    if (course.knots.empty()) return;
    guides_.push_back(table);
    const char* key = table.has("velocity") ? "velocity" : "displacement";
    const bool is_turned = entry.frame || std::any_of(hold.nodes.begin(), hold.nodes.end(), [&](auto node) {
                             return out_.scene.frames.contains(node);
                           });
    if (is_turned) table.error(key, "does not go with along and plane", "hold it by axes to move it");
    out_.scene.guides.push_back({hold.nodes, hold.axes, std::move(course)});
  }

  /// Nothing moves in a static analysis, unless somebody looks at a motion that way for once.
  void check_guides() {
    TableReader analysis = root_.table("analysis", Presence::optional);
    if (diagnostics_.where(analysis.place("kind")).starts_with("--set")) return;
    for (auto& hold : guides_)
      hold.error(hold.has("velocity") ? "velocity" : "displacement", "nothing moves in a static analysis",
                 "kind = \"dynamic\" in [analysis], or leave it out");
    if (!plan_) return;
    const auto refuse = [&](const char* what, Place place) {
      diagnostics_.error(place, std::string(what) + ": nothing moves in a static analysis",
                         "kind = \"dynamic\" in [analysis], or leave it out");
    };
    if (plan_->ship && !plan_->ship->path.empty()) refuse("ship.path", plan_->ship->path_place);
    for (const auto& rope : plan_->ropes)
      if (!rope.winch.empty()) refuse("ship.warp.winch", rope.winch_place);
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

  void read_results() {
    const bool holds_are_known = diagnostics_.errors() == 0;
    TableReader results = root_.table("results", Presence::optional);
    for (const auto& name : results.keys()) {
      if (const std::string fault = name_fault(name); !fault.empty())
        diagnostics_.error(results.place(name), "the name of a result, " + in_quotes(name) + ", " + fault);
      TableReader entry =
          results.table(name, Presence::required, "such as { of = \"net\", take = \"min z\" }");
      read_result(name, entry, holds_are_known);
    }
  }

  void read_result(const std::string& name, TableReader& entry, bool holds_are_known) {
    ResultRequest request;
    request.name = name;
    request.of = read_name(entry, "of", "a part, an edge or a point");
    request.take = read_name(entry, "take", "what of it, such as \"min z\" or \"max tension\"");
    if (request.of.empty() || request.take.empty()) return;
    const auto set = draft_.find_set(mention(request.of, entry, "of"));
    if (!set || !draft_.types[set->part]) return;
    request.part = static_cast<std::uint32_t>(set->part);
    request.nodes = draft_.scene_nodes(*set);
    if (draft_.geometries[set->part].body && request.of.find('.') == std::string::npos) {
      request.nodes.resize(1);  // of a body as a whole its origin
      request.body = static_cast<std::uint32_t>(out_.scene.body_at(request.nodes[0]).value_or(0));
    }
    drop_repeats(request.nodes);  // of a part that is joined to itself
    if (!understand(request, *draft_.types[set->part], entry)) return;
    if (request.nodes.empty() && draft_.is_sound[set->part] &&
        request.source != ResultRequest::Source::output)
      draft_.refuse_rider(mention("", entry, "take"), request.of);
    if (holds_are_known) check_reaction(request, entry);
    out_.results.push_back(std::move(request));
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

  /// What the bed is made of, under all parts that rest on it.
  void lay_bottom() {
    bool is_felt = false;
    for (std::size_t p = 0; p < draft_.types.size(); ++p)
      is_felt |= bottom_.lay_under(*draft_.types[p], out_.scene.parts[p]);
    if (!is_felt)
      root_.table("bed").error("bottom", "has no effect: nothing rests on the bed that would feel it",
                               "a part of the type seabed/bed, or a board that ploughs");
  }

  /// The key of the bed that tells port from starboard; null: none does.
  const char* uneven_key() const {
    const SeaBed& bed = out_.scene.bed;
    if (bed.slope_y != 0) return "slope_y";
    if (!bed.relief.empty() && !bed.relief.is_even_in_y()) return "relief";
    return bottom_.is_symmetric() ? nullptr : "bottom";
  }

  /// Half a gear stands for a whole one only if nothing tells port from starboard.
  void check_symmetry() {
    const std::string cure = "[gear] extent = \"whole\"";
    const auto across = [](const auto& all) {
      return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.velocity[1] != 0; });
    };
    if (across(out_.scene.current.samples) || across(out_.scene.current.drifts)) {
      TableReader water = root_.table("water", Presence::optional);
      water.error("current", "flows across the plane y = 0, of which half a gear is the mirror image", cure);
    }
    if (out_.scene.ground[1] != 0) {
      TableReader tow = root_.table("tow");
      tow.error("leeway", "leads across the plane y = 0, of which half a gear is the mirror image", cure);
    }
    if (const char* key = uneven_key()) {
      TableReader bed = root_.table("bed");
      bed.error(key, "tells port from starboard of the plane y = 0, of which half a gear is the mirror image",
                cure);
    }
    for (std::size_t p = 0; p < draft_.types.size(); ++p) {
      const ElementType* type = draft_.types[p];  // null for one that is not there, which was said
      if (!type || type->is_on_body()) continue;  // whose y is outward
      const Part& part = out_.scene.parts[p];
      for (const auto& [name, value] : part.parameters)
        if (const auto* number = std::get_if<double>(&value); number && *number != 0 && name.ends_with("_y"))
          diagnostics_.error(out_.place_of(part.name),
                             part.name + ": " + name + " is not zero, and tells port from starboard", cure);
    }
  }

  /// A start from which a gear can come free is a warning; what is held stays where it is.
  void check_crossings() {
    for (const auto& crossing : find_crossings(out_, out_.scene.positions)) {
      const Place place = out_.parts[crossing.part].place;
      const std::string fault = "at the start " + crossing.sentence;
      if (crossing.is_held)
        diagnostics_.error(place, fault, "hold what is to starboard at a positive y");
      else
        diagnostics_.warning(place, fault, "let it start at a positive y");
    }
  }

  void check_held() {
    for (const auto& fault : find_loose_parts(out_.scene, nodes_per_element()))
      diagnostics_.error(out_.place_of(fault.part), fault.message);
  }

  /// Friction of what the gear is towed over points aft only if the ground passes, too.
  void check_ground() {
    for (std::size_t p = 0; !says_tow_ && p < draft_.types.size(); ++p)
      if (is_rubbed_by_standing_ground(out_.scene, out_.scene.parts[p], *draft_.types[p]))
        diagnostics_.warning(
            out_.parts[p].place,
            out_.scene.parts[p].name +
                ": its friction is that of a ground that stands, in "
                "water that flows; a towed gear passes both",
            "[tow] speed = \"3 kn\" lets both pass, instead of water.current; [tow] speed = 0 says "
            "that the ground stands");
  }

  /// What lies on the bed of the scene wants one.
  void check_bed() {
    for (std::size_t p = 0; !out_.scene.bed.is_there && p < draft_.types.size(); ++p)
      for (const auto& term : draft_.types[p]->terms)
        if (const auto both = NETLOFT_READS_BED | NETLOFT_FROM_OUTSIDE;
            (term.traits & both) == std::uint32_t{both} && names_needed_by(term).empty())
          diagnostics_.error(out_.parts[p].place,
                             out_.scene.parts[p].name + ": " + draft_.types[p]->type +
                                 " stands on the bed of the scene, and there is none",
                             "[bed] depth = \"100 m\"");
  }

  /// A [[join]] that was made, and where it stands.
  struct Join {
    std::vector<Joiner::Ends> sets;
    Mention at;
    bool together;  // all nodes in one
    void make(Joiner& joiner) const { together ? joiner.gather(sets) : joiner.join(sets); }
  };

  TableReader root_;
  Registry& registry_;
  Diagnostics& diagnostics_;
  bool& refused_;
  ElementChoice elements_;
  Draft draft_;
  LoadedScene& out_;  // of the draft
  MeshParts meshes_;
  const NetPlan* plan_;
  std::optional<GearParts> gear_;
  std::vector<const ElementType*> companions_;
  std::vector<std::pair<std::string, TableReader>> riders_;
  std::vector<Join> joins_;
  std::vector<TableReader> guides_;  // holds that move
  OneSidedHolds one_sided_;
  std::map<std::string, Place> hold_names_;
  bool says_tow_ = false;
  SeaBottom bottom_;
  std::optional<Joiner> joiner_;
  std::optional<TautiModel> tauti_;
};

/// The net plan in a scene, checked; nothing if there is none.
std::optional<NetPlan> read_plan_of(const Document& document, const std::filesystem::path& folder,
                                    Diagnostics& diagnostics) {
  if (!holds_plan(document)) return {};
  NetPlan plan = read_plan(document, folder, diagnostics);
  if (diagnostics.errors() == 0) check_plan(plan, diagnostics);
  return plan;
}

void append_new(std::vector<SourceFile>& files, const std::vector<SourceFile>& more) {
  for (const auto& file : more)
    if (std::none_of(files.begin(), files.end(), [&](const auto& f) { return f.path == file.path; }))
      files.push_back(file);
}

}  // namespace

LoadedScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       Registry& registry, Diagnostics& diagnostics, bool& refused) {
  const Document document = Document::load(file, overrides, diagnostics);
  if (diagnostics.errors()) return {};
  Value root = document.root();
  std::map<std::string, Strength> strengths;
  const auto catalogues = put_catalogue_parts(root, file.parent_path(), registry, diagnostics, strengths);
  const auto plan = read_plan_of(document, file.parent_path(), diagnostics);
  if (diagnostics.errors() && plan) return {};  // nothing in a scene can be judged without its gear
  LoadedScene loaded =
      SceneReader(root, plan ? &*plan : nullptr, file, registry, diagnostics, refused).read();
  loaded.strengths.merge(strengths);
  if (auto& start = loaded.analysis.dynamics.start_file; !start.empty()) start = file.parent_path() / start;
  const auto meshes = std::exchange(loaded.files, document.files());
  append_new(loaded.files, meshes);
  append_new(loaded.files, catalogues);
  if (plan) append_new(loaded.files, plan->files);
  return loaded;
}

}  // namespace netloft::io
