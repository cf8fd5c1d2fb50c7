// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/gear_parts.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/catalogue/part_kinds.hpp"
#include "io/gear/twine_coordinates.hpp"
#include "io/scene/idle_keys.hpp"
#include "io/scene/inventory.hpp"
#include "io/scene/known_parameters.hpp"
#include "io/scene/parameter_reader.hpp"
#include "io/scene/part_names.hpp"
#include "io/scene/plan_contact.hpp"
#include "io/scene/riding.hpp"
#include "io/scene/ship_course.hpp"
#include "io/scene/thickness.hpp"
#include "io/toml/merge.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

constexpr double kMostFiner = 100;
constexpr std::int64_t kFewestNodes = 20;

/// Numbers of the catalogue's that a part may know and its element need not: what is left is known.
void drop_unknown_numbers(Table& numbers, const ElementType& type, const std::string& key) {
  std::erase_if(numbers.members, [&](const Member& number) {
    const std::string name = key + "." + number.key;
    return std::none_of(type.parameters.begin(), type.parameters.end(),
                        [&](const auto& p) { return name == p.name; });
  });
}

void put(Table& table, const std::string& key, Value value) {
  const Place place = value.place;
  table.members.push_back({key, place, std::move(value)});
}

/// Whether `nodes = "knots"`, beside which no other key says how fine the mesh is.
bool wants_knots(TableReader& table) {
  const Value* nodes = table.kind("nodes") == Kind::text ? table.raw("nodes") : nullptr;
  return nodes && *nodes->as<std::string>() == kKnots;
}

/// The keys of `[gear]`, without the number of nodes where it is a word.
Values read_gear_keys(TableReader& table, bool knots) {
  std::vector<netloft_parameter> keys(gear_keys().begin(), gear_keys().end());
  if (knots) std::erase_if(keys, [](const auto& key) { return std::string_view(key.name) == "nodes"; });
  return read_parameters(keys, table);
}

/// Either the number of nodes or the length of sides says how fine a mesh is.
void check_fineness(const GearKeys& keys, TableReader& table) {
  if (keys.size > 0 && table.has("nodes") && keys.nodes > 0)
    table.error("size", "stands beside nodes, and either says how fine the mesh is",
                "leave one of them out; nodes = 0 leaves it to size, size = 0 to nodes");
  if (keys.nodes < kFewestNodes && !(keys.nodes == 0 && keys.size > 0))
    table.error("nodes", "= " + std::to_string(keys.nodes) + " is outside [20, 1000000]",
                "0 goes with a size alone");
}

/// Of the names in a gear those that a plan's name stands for: itself, or in the whole both of a pair.
std::vector<std::string> meant_by(const std::string& name, const std::vector<std::string>& names) {
  const auto is_there = [&](const std::string& one) { return std::ranges::find(names, one) != names.end(); };
  if (is_there(name)) return {name};
  const std::string starboard = "starboard-" + name, port = "port-" + name;
  return is_there(starboard) && is_there(port) ? std::vector{starboard, port} : std::vector<std::string>{};
}

/// What the part of a plan bears, where it says so.
void keep_strength(LoadedScene& loaded, const std::string& part, const Value& numbers, int twines,
                   const std::string& material) {
  const double load = breaking_load_of(numbers) * twines;
  if (load > 0) loaded.strengths[part] = {load, material};
}

}  // namespace

bool is_seam(TableReader& join) {
  const bool sews = join.has("edges") && !join.has("points");
  if (sews) join.has("take_up");
  return sews;
}

GearParts::GearParts(const NetPlan& plan, TableReader& root, const ElementChoice& elements, Draft& draft)
    : plan_(plan), elements_(elements), draft_(draft), diagnostics_(root.diagnostics()) {
  for (const char* key : {"panels", "ropes", "hang", "floats", "points", "ship"}) root.has(key);
  const int errors_before = diagnostics_.errors();
  draft_.out.gear.emplace();
  read_model(root, plan);
  TableReader table = root.table("elements", Presence::optional);
  for (const auto& of : gear_elements())
    if (of.kind != std::string_view(kContact))
      made_.push_back(read_elements(table, of));
    else if (const Value* said = table.has(of.kind) ? table.raw(of.kind) : nullptr; said && said->as<Table>())
      contact_ = *said;
  read_exceptions(table);
  if (diagnostics_.errors() > errors_before) return;
  mesh_ = divide(gear_, fineness_);
  if (fineness_.knots) draft_.out.gear->nodes = mesh_.nodes;
  own_.resize(mesh_.nodes);
}

void GearParts::read_model(TableReader& root, const NetPlan& plan) {
  TableReader table = root.table("gear", Presence::optional);
  fineness_.knots = wants_knots(table);
  const Values values = read_gear_keys(table, fineness_.knots);
  std::vector<std::string> faults;
  const ParameterBlock block(gear_keys(), sizeof(GearKeys), values, faults);
  if (!faults.empty()) return;
  const auto& keys = *static_cast<const GearKeys*>(block.data());
  fineness_.knots ? check_knots(table) : check_fineness(keys, table);
  gear_ = make_gear(plan, keys.extent == 1 ? Extent::half : Extent::whole);
  fineness_.nodes = static_cast<std::size_t>(keys.nodes), fineness_.size = keys.size;
  read_finer(table);
  check_halves(table);
  draft_.out.gear->times = gear_.extent == Extent::half ? 2 : 1;
  draft_.out.gear->nodes = fineness_.nodes, draft_.out.gear->size = fineness_.size;
  draft_.out.gear->bill = bill_of(plan), draft_.out.gear->sheet = sheet_of(plan, gear_);
}

void GearParts::check_knots(TableReader& gear) const {
  for (const char* key : {"size", "finer"})
    if (gear.has(key))
      gear.error(key, "stands beside nodes = \"knots\", which says how fine the mesh is",
                 "leave one of them out");
}

/// What the half of a gear cannot have.
void GearParts::check_halves(TableReader& table) const {
  if (gear_.extent == Extent::whole) return;
  for (const auto& body : plan_.bodies)
    if (body.stands != io::Standing::pair)
      table.error("extent", "= \"half\", and " + in_quotes(body.name) + " is a body that stands once",
                  "extent = \"whole\"; half a body is none");
  if (plan_.ship)
    for (const auto& moment : plan_.ship->path)
      if (moment.heading != 0) {
        table.error("extent", "= \"half\", and the ship turns",
                    "extent = \"whole\", or leave out ship.path.heading");
        break;
      }
  if (plan_.ship && !plan_.ship->path_port.empty())
    table.error("extent", "= \"half\", and two ships go ways of their own",
                "extent = \"whole\", or leave out ship.path_port");
  for (const auto& rope : plan_.ropes)
    if (rope.length_port.value_or(rope.length) != rope.length)
      table.error("extent", "= \"half\", and " + in_quotes(rope.name) + " has another length to port",
                  "extent = \"whole\", or leave out length_port");
  for (const auto& rope : plan_.ropes)
    if (rope.tension_port.value_or(rope.tension.value_or(0)) != rope.tension.value_or(0))
      table.error("extent", "= \"half\", and " + in_quotes(rope.name) + " has another tension to port",
                  "extent = \"whole\", or leave out tension_port");
}

/// `finer = { top-codend = 2 }`, by panels and ropes.
void GearParts::read_finer(TableReader& table) {
  TableReader finer = table.table("finer", Presence::optional);
  std::vector<std::string> names;
  for (const auto& panel : gear_.panels) names.push_back(panel.name);
  for (const auto& rope : gear_.ropes) names.push_back(rope.name);
  for (const auto& name : finer.keys()) {
    const double times = finer.real(name, {.unit = "1",
                                           .doc = "sides of triangles, or bars, that many times shorter",
                                           .range = between(1 / kMostFiner, kMostFiner)});
    const auto meant = meant_by(name, names);
    if (meant.empty())
      finer.error(name, "there is no panel or rope " + in_quotes(name), name_hint(name, names));
    for (const auto& one : meant)
      if (one == name || !finer.has(one)) fineness_.finer[one] = times;
  }
}

/// Whether the name of a rope, a body or of the kind itself stands for what rests on the bed.
bool GearParts::touches_bed(const std::string& name) const {
  if (!contact_) return false;
  const io::Rope* rope = plan_.find_rope(name);
  const PlanBody* body = plan_.find_body(name);
  return name == kContact || (rope && rests_on_bed(*rope)) || (body && !shoes_of(*body).empty());
}

/// `[elements.top-codend]`: what one part of the plan is made of, over what all of its kind are.
void GearParts::read_exceptions(TableReader& elements) {
  std::vector<std::string> names;
  for (const auto& panel : gear_.panels) names.push_back(panel.name);
  for (const auto& rope : gear_.ropes) names.push_back(rope.name);
  for (const auto& pieces : gear_.pieces) names.push_back(pieces.name);
  for (const auto& body : gear_.bodies) names.push_back(body.name);
  for (const auto& of : gear_elements()) names.push_back(of.kind);
  for (const auto& name : elements.keys()) {
    const Value* said = elements.raw(name);
    const auto meant = meant_by(name, names);
    if (meant.empty())
      elements.error(name, "there is nothing named " + in_quotes(name) + " in the net plan",
                     name_hint(name, names));
    else if (said->as<Table>() && said->as<Table>()->find(contact_elements().key) && !touches_bed(name))
      elements.error(name,
                     std::string("says ") + contact_elements().key + ", and " +
                         (contact_ ? "does not touch the bed" : "nothing of the plan rests on the bed"),
                     contact_ ? "footropes, bridles, sweeps, legs and boards with a toe or heel do"
                              : "[elements.contact] lets all that touches it rest there");
    else if (!said->as<Table>())
      elements.error(name, "a table is expected, such as { drag = \"hydro/morison\" }");
    else if (meant.front() == name)
      exceptions_[name] = *said;
    else
      for (const auto& side : meant) exceptions_of_pairs_[side] = *said;
  }
}

GearParts::Made GearParts::read_elements(TableReader& elements, const GearElements& of) const {
  TableReader table = elements.table(of.kind, Presence::optional);
  for (const auto& key : table.keys()) table.raw(key);  // read with each part
  Made made{&of, {table.place(), Table{}}, nullptr};
  if (const Value* said = elements.raw(of.kind); said && said->as<Table>()) made.said = *said;
  made.type = elements_.find(
      table.has("type") ? read_name(table, "type", "element type, such as priour/triangle") : of.type, table);
  if (made.type && made.type->element.stencil != of.stencil) {
    table.error("type", made.type->type + " does not stand on what " + of.doc + " are divided into",
                std::string("such as ") + of.type);
    made.type = nullptr;
  }
  return made;
}

const GearParts::Made& GearParts::made(std::string_view kind) const {
  return *std::find_if(made_.begin(), made_.end(), [&](const auto& m) { return m.of->kind == kind; });
}

/// Parameters of a part: its numbers in the plan, over them what `[elements.KIND]` says of all, and over both
/// what `[elements.NAME]` says of this one.
bool GearParts::read_part(const Made& made, const std::string& path, Value numbers, bool is_of_catalogue,
                          Part& part) const {
  const int errors_before = diagnostics_.errors();
  if (Table* table = numbers.as<Table>(); table && is_of_catalogue)
    drop_unknown_numbers(*table, *made.type, made.of->key);
  Value whole{numbers.place, Table{}};
  put(*whole.as<Table>(), made.of->key, std::move(numbers));
  merge(whole, made.said);
  for (const auto* exceptions : {&exceptions_of_pairs_, &exceptions_})
    if (const auto said = exceptions->find(part.name); said != exceptions->end())
      merge(whole, without_contact(said->second));
  TableReader reader(whole, diagnostics_, path);
  reader.has("type");
  elements_.read(*made.type, reader, part);
  reader.finish();
  return diagnostics_.errors() == errors_before;
}

/// A board starts where warps of such boards have it: as deep as they reach, on the bed where there is one.
/// Only a start: what is found does not depend on it, unless a gear has several equilibria.
BodyOfPlan GearParts::place_of(const GearBody& body) const {
  BodyOfPlan place{body.is_mirrored ? -1.0 : 1.0, {}};
  const io::Rope* warp = plan_.find_rope(kWarp);
  if (!plan_.ship || !warp) return place;
  place.guess = [this, warp, side = place.side](double lowest) {
    constexpr double kDepth = 0.3, kSpread = 0.09;  // over the length of warp
    const double L = warp->length, y = plan_.ship->block_gap / 2 + kSpread * L;
    const SeaBed& bed = draft_.out.scene.bed;
    const double reach = plan_.ship->block_height - kDepth * L;
    const double z = bed.is_there ? std::max(reach, bed.at(L, side * y)[0] - lowest) : reach;
    const double down = plan_.ship->block_height - z;
    return std::array{std::sqrt(std::max(L * L - down * down, 0.25 * L * L)), side * y, z};
  };
  return place;
}

void GearParts::tie(const GearBody& body, std::size_t part) {
  const Geometry& geometry = draft_.geometries[part];
  if (body.body->stands == io::Standing::pair)
    draft_.out.gear->pairs[body.body->name].push_back(static_cast<std::uint32_t>(part));
  for (std::uint32_t k = 0; geometry.body && k < geometry.body->names.size(); ++k) {
    const auto node = mesh_.points.find(body.name + "." + geometry.body->names[k]);
    if (node == mesh_.points.end()) continue;
    own_[node->second].push_back({part, k + 1});
    for (int axis = 0; axis < 3; ++axis)
      known_.push_back({node->second, axis,
                        geometry.positions[3 * (k + std::size_t{1}) + static_cast<std::size_t>(axis)]});
  }
}

void GearParts::add_parts() {
  start_ = start_shape(gear_, mesh_, known_);
  for (std::size_t p = 0; p < mesh_.panels.size(); ++p) add_panel(gear_.panels[p], mesh_.panels[p]);
  for (std::size_t r = 0; r < mesh_.ropes.size(); ++r) add_rope(gear_.ropes[r], mesh_.ropes[r]);
  for (const auto& pieces : gear_.pieces) draft_.announce_rider(pieces.name);
  name_points();
}

void GearParts::add_panel(const GearPanel& panel, const PanelMesh& mesh) {
  const io::Panel& plan = *panel.panel;
  Geometry geometry;
  geometry.names.panel = mesh.meshes, geometry.names.sets = mesh.sets, geometry.names.place = plan.place;
  geometry.elements = mesh.triangles;
  for (const auto own : mesh.triangles) {
    const auto [U, V] = mesh.meshes[own];
    const auto [u, v] = twine_coordinates(plan.orientation, plan.angle, U, V);
    geometry.data[datum::kU.name].push_back(u);
    geometry.data[datum::kV.name].push_back(v);
    geometry.data[datum::kToAft.name].push_back(plan.depth - V);
  }
  geometry.data[datum::kBarLength.name].assign(mesh.triangles.size() / 3, plan.mesh / 2);
  Value twine = plan.twine;
  keep_strength(draft_.out, panel.name, plan.twine, plan.twines, plan.twine_name);
  if (plan.twines > 1 && twine.as<Table>())
    put(*twine.as<Table>(), "number", {plan.place, std::int64_t{plan.twines}});
  add_part("netting", panel.name, "panels." + plan.name, std::move(twine), !plan.twine_name.empty(),
           std::move(geometry), mesh.nodes);
  if (plan.orientation == "t90")
    check_turned_netting(draft_.out.scene.parts.back(), plan.place, diagnostics_);
}

void GearParts::add_rope(const GearRope& rope, const RopeMesh& mesh) {
  Geometry geometry;
  geometry.names.sets = mesh.sets, geometry.names.place = rope.rope->place;
  for (std::uint32_t i = 0; i + 1 < mesh.nodes.size(); ++i)
    geometry.elements.insert(geometry.elements.end(), {i, i + 1});
  geometry.data[datum::kRestLength.name] = mesh.rest_lengths;
  keep_strength(draft_.out, rope.name, rope.rope->rope, 1, rope.rope->part_name);
  add_part("ropes", rope.name, "ropes." + rope.rope->name, rope.rope->rope, !rope.rope->part_name.empty(),
           std::move(geometry), mesh.nodes);
}

/// `nodes`: own number -> node of the gear.
void GearParts::add_part(std::string_view kind, const std::string& name, const std::string& path,
                         Value numbers, bool is_of_catalogue, Geometry geometry,
                         const std::vector<std::uint32_t>& nodes) {
  const Made& how = made(kind);
  Part part;
  part.name = name;
  const bool is_sound = read_part(how, path, std::move(numbers), is_of_catalogue, part);
  if (const auto fault = thickness_fault(part, geometry); fault && is_sound)
    diagnostics_.error(geometry.names.place, path + "." + fault->key + ": " + fault->message, kThicknessCure);
  geometry.names.name = name;
  const std::size_t p = draft_.geometries.size();
  for (std::uint32_t own = 0; own < nodes.size(); ++own) {
    own_[nodes[own]].push_back({p, own});
    const auto x = start_.begin() + 3 * std::ptrdiff_t{nodes[own]};
    geometry.positions.insert(geometry.positions.end(), x, x + 3);
  }
  GearInScene& gear = *draft_.out.gear;
  (kind == "netting" ? gear.panels : gear.ropes).push_back(static_cast<std::uint32_t>(p));
  draft_.add_part(std::move(part), std::move(geometry), how.type, is_sound);
}

/// Points of the plan that no part has for its own: towing points.
void GearParts::name_points() {
  for (const auto& [name, node] : mesh_.points)
    if (name.find('.') == std::string::npos && !own_[node].empty()) {
      const auto& [part, own] = own_[node].front();
      draft_.points[name] = {part, {own}};
    }
}

void GearParts::join(Joiner& joiner) const {
  for (const auto& same : own_) {
    std::vector<Joiner::Ends> ends;
    for (const auto& [part, own] : same) ends.push_back({part, {own}});
    if (ends.size() > 1) joiner.join(ends);
  }
}

std::uint32_t GearParts::scene_node(std::uint32_t gear_node) const {
  const auto& [part, own] = own_[gear_node].front();
  return draft_.out.parts[part].nodes[own];
}

void GearParts::add_pieces() {
  GearInScene& gear = *draft_.out.gear;
  for (const auto& pieces : gear_.pieces) put_pieces(pieces);
  for (const auto& [name, node] : mesh_.points) gear.points[point_name(name)] = scene_node(node);
  name_lines(gear);
}

void GearParts::put_pieces(const GearPieces& pieces) {
  const Made& how = made("floats");
  Part part;
  part.name = pieces.name;
  const bool is_sound = read_part(how, "floats." + pieces.pieces->name, pieces.pieces->piece,
                                  !pieces.pieces->part_name.empty(), part);
  std::vector<double> carried(draft_.out.scene.node_count(), 0.0);
  ride_on_nodes(nodes_of(pieces, carried), carried, pieces.number, part);
  draft_.out.gear->pieces.push_back(static_cast<std::uint32_t>(draft_.out.scene.parts.size()));
  draft_.add_rider(std::move(part), pieces.pieces->place, how.type, is_sound);
}

/// Where pieces are hung, and how much of the rope or edge every node carries.
std::vector<std::uint32_t> GearParts::nodes_of(const GearPieces& pieces, std::vector<double>& carried) const {
  std::vector<std::uint32_t> nodes;
  const auto carry = [&](std::uint32_t from, std::uint32_t to, double length) {
    carried[from] += length / 2, carried[to] += length / 2;
  };
  if (!pieces.point.empty()) return {scene_node(mesh_.points.at(pieces.point))};
  if (!pieces.rope.empty()) {
    const RopeMesh& rope =
        mesh_.ropes[static_cast<std::size_t>(gear_.find_rope(pieces.rope) - gear_.ropes.data())];
    for (const auto node : rope.nodes) nodes.push_back(scene_node(node));
    for (std::size_t i = 1; i < nodes.size(); ++i) carry(nodes[i - 1], nodes[i], rope.rest_lengths[i - 1]);
  }
  for (const auto& ref : pieces.edges) {
    const PanelMesh& panel = mesh_.panels[ref.panel];
    const auto& edge = panel.sets.at(gear_.panels[ref.panel].outline.edges[ref.edge].name);
    for (std::size_t i = 0; i < edge.size(); ++i) {
      nodes.push_back(scene_node(panel.nodes[edge[i]]));
      if (i == 0) continue;
      const auto &a = panel.meshes[edge[i - 1]], &b = panel.meshes[edge[i]];
      carry(nodes[nodes.size() - 2], nodes.back(), std::hypot(b[0] - a[0], b[1] - a[1]));
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The roles that the plan gives its ropes; parts of ropes are in the order of the gear's.
void GearParts::name_lines(GearInScene& gear) const {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r) {
    const io::Rope& rope = *gear_.ropes[r].rope;
    if (rope.stands == io::Standing::middle) gear.across.insert(gear.ropes[r]);
    if (rope.role == "headline")
      gear.headline = gear_.ropes[r].name;
    else if (rope.role == "footrope")
      gear.footrope = gear_.ropes[r].name;
    else if (!rope.role.empty())
      gear.roles[rope.role].push_back(gear.ropes[r]);
  }
}

/// Ends of a rope across the gear have the same names in the whole and in the half.
std::string GearParts::point_name(const std::string& name) const {
  const auto dot = name.find('.');
  const GearRope* rope = dot == std::string::npos ? nullptr : gear_.find_rope(name.substr(0, dot));
  if (!rope || rope->rope->stands != io::Standing::middle) return name;
  const bool is_whole = gear_.extent == Extent::whole;
  const std::string end = name.substr(dot + 1);
  if (end == "start") return rope->name + (is_whole ? ".port" : ".middle");
  return end == "end" ? rope->name + ".starboard" : name;
}

namespace {

const Value* find_exception(const std::map<std::string, Value>& exceptions, const std::string& name) {
  const auto said = exceptions.find(name);
  return said == exceptions.end() ? nullptr : &said->second;
}

}  // namespace

Value GearParts::contact_of(const std::string& name, std::vector<std::string> on, Place place) const {
  const GearElements& of = contact_elements();
  Value table{contact_->place, Table{}};
  put(*table.as<Table>(), "type", {contact_->place, std::string(of.type)});
  if (const double radius = radius_along(plan_, name); radius > 0) {
    Table seabed;
    put(seabed, "radius", {place, radius});
    put(*table.as<Table>(), of.key, {place, std::move(seabed)});
  }
  merge(table, *contact_);
  for (const auto* said :
       {find_exception(exceptions_of_pairs_, "starboard-" + name), find_exception(exceptions_, name)})
    if (said) merge(table, only_contact(*said));
  Array names;
  for (auto& point : on) names.items.push_back({place, std::move(point)});
  put(*table.as<Table>(), "on", {place, std::move(names)});
  return table;
}

/// Of a pair, by the one to starboard.
bool GearParts::is_carried(const std::string& rope, const std::set<std::uint32_t>& carried) const {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r)
    if (gear_.ropes[r].rope->name == rope)
      return std::ranges::all_of(mesh_.ropes[r].nodes,
                                 [&](auto node) { return carried.contains(scene_node(node)); });
  return false;
}

bool GearParts::is_carried_at(const std::string& point, const std::set<std::uint32_t>& carried) const {
  for (const std::string& name : {point, "starboard-" + point})
    if (const auto node = mesh_.points.find(name); node != mesh_.points.end())
      return carried.contains(scene_node(node->second));
  return false;
}

std::vector<std::pair<std::string, Value>> GearParts::contacts(const std::set<std::uint32_t>& carried) const {
  std::vector<std::pair<std::string, Value>> all;
  if (!contact_) return all;
  for (const io::Rope& rope : plan_.ropes)
    if (rests_on_bed(rope) && !is_carried(rope.name, carried))
      all.emplace_back(rope.name + "-on-bed", contact_of(rope.name, {rope.name}, rope.place));
  for (const PlanBody& body : plan_.bodies) {
    auto shoes = shoes_of(body);
    std::erase_if(shoes, [&](const auto& shoe) { return is_carried_at(shoe, carried); });
    if (!shoes.empty())
      all.emplace_back(body.name + "-on-bed", contact_of(body.name, std::move(shoes), body.place));
  }
  return all;
}

bool GearParts::sinks_into_bed(const std::set<std::uint32_t>& carried) const {
  if (!plan_.ship || contact_) return false;
  return std::ranges::any_of(plan_.ropes, [&](const io::Rope& rope) {
    return rope.role == "footrope" && !is_carried(rope.name, carried);
  });
}

void GearParts::hold_middle() {
  if (mesh_.middle.empty()) return;
  Scene& scene = draft_.out.scene;
  Hold hold{kPlaneOfSymmetry, {}, {}};
  for (const auto node : mesh_.middle) {
    hold.nodes.push_back(scene_node(node)), hold.axes.push_back(kAxisY);
    scene.held[hold.nodes.back()] |= kAxisY;
    scene.positions[3 * std::size_t{hold.nodes.back()} + 1] = 0;
  }
  draft_.out.holds.push_back(std::move(hold));
}

void GearParts::hold_blocks() {
  if (!plan_.ship) return;
  Scene& scene = draft_.out.scene;
  Hold hold{kShip, {}, {}};
  for (const auto& point : gear_.points) {
    if (point.point->name != kBlock) continue;
    const std::uint32_t node = scene_node(mesh_.points.at(point.name));
    hold.nodes.push_back(node), hold.axes.push_back(kAllAxes);
    scene.held[node] = kAllAxes;
    std::copy(point.at->begin(), point.at->end(), scene.positions.begin() + 3 * std::ptrdiff_t{node});
    if (!plan_.ship->path.empty())
      scene.guides.push_back({{node}, {kAllAxes}, course_of_block(*plan_.ship, (*point.at)[1])});
  }
  draft_.out.holds.push_back(std::move(hold));
  set_winches();
  draft_.out.gear->ship_speed = plan_.ship->speed;
  draft_.out.gear->ship_efficiency = plan_.ship->efficiency;
}

/// Of a warp with a tension the length is found, and its winch holds the tension in a motion unless it is
/// said how it runs. It starts at its block.
void GearParts::set_winches() {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r) {
    const GearRope& rope = gear_.ropes[r];
    const io::Rope& plan = *rope.rope;
    if (!plan.tension && plan.winch.empty()) continue;
    const std::uint32_t block = scene_node(mesh_.ropes[r].nodes.front());
    const double tension = plan.tension.value_or(0),
                 wanted = rope.is_mirrored ? plan.tension_port.value_or(tension) : tension;
    if (plan.tension)
      draft_.out.scene.settings.push_back({"length of " + rope.name, rope.name, datum::kRestLength.name,
                                           datum::kRestLength.unit, block, wanted});
    Winch winch{rope.name, parameter::kLengthShare.name, block,
                rope.is_mirrored ? plan.length_port.value_or(plan.length) : plan.length, plan.winch};
    if (winch.stages.empty())
      winch.stages.push_back({.max_speed = kWinchSpeed, .band = kWinchBand * tension});
    WinchStage& first = winch.stages.front();
    if (plan.tension && first.follows == WinchStage::Follows::tension && first.rows.size() < 2)
      first.rows = {{0, wanted}};
    draft_.out.scene.winches.push_back(std::move(winch));
  }
}

void GearParts::follow_holds() {
  if (mesh_.nodes == 0) return;
  Scene& scene = draft_.out.scene;
  std::vector<KnownCoordinate> known = known_;
  for (std::uint32_t node = 0; node < mesh_.nodes; ++node)
    for (int axis = 0; axis < 3; ++axis)
      if (const auto in = scene_node(node); scene.held[in] & (1 << axis) && !scene.frames.contains(in))
        known.push_back({node, axis, scene.positions[3 * std::size_t{in} + static_cast<std::size_t>(axis)]});
  const auto start = start_shape(gear_, mesh_, known);
  for (std::uint32_t node = 0; node < mesh_.nodes; ++node)
    std::copy_n(start.begin() + 3 * std::ptrdiff_t{node}, 3,
                scene.positions.begin() + 3 * std::ptrdiff_t{scene_node(node)});
}

bool GearParts::has_name(const std::string& name) const {
  const auto is_it = [&](const auto& one) { return one.name == name; };
  return std::any_of(gear_.panels.begin(), gear_.panels.end(), is_it) ||
         std::any_of(gear_.ropes.begin(), gear_.ropes.end(), is_it) ||
         std::any_of(gear_.pieces.begin(), gear_.pieces.end(), is_it) ||
         std::any_of(gear_.points.begin(), gear_.points.end(), is_it) ||
         std::any_of(gear_.bodies.begin(), gear_.bodies.end(), is_it);
}

}  // namespace netloft::io
