// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/gear_parts.hpp"

#include "io/formats/toml/merge.hpp"
#include "io/formats/units/in_metres.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/catalogue/part_kinds.hpp"
#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/twine_coordinates.hpp"
#include "io/scenes/reading/gear_model.hpp"
#include "io/scenes/reading/idle_keys.hpp"
#include "io/scenes/reading/inventory.hpp"
#include "io/scenes/reading/known_parameters.hpp"
#include "io/scenes/reading/part_names.hpp"
#include "io/scenes/reading/part_reader.hpp"
#include "io/scenes/reading/plan_contact.hpp"
#include "io/scenes/reading/read_winches.hpp"
#include "io/scenes/reading/riding.hpp"
#include "io/scenes/reading/ship_course.hpp"
#include "io/scenes/reading/thickness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netloft::scenes {

namespace {

/// Stores the breaking load of a part, if the plan states it.
void keep_strength(LoadedScene& loaded, const std::string& part, const formats::Value& numbers, int twines,
                   const std::string& material) {
  const double load = breaking_load_of(numbers) * twines;
  if (load > 0) loaded.strengths[part] = {load, material};
}

/// The geometry of a panel without positions. It depends only on the division of the panel into elements.
Geometry geometry_of(const gears::Panel& plan, const gears::PanelMesh& mesh) {
  Geometry geometry;
  geometry.names.panel = mesh.meshes;
  geometry.names.sets = mesh.sets;
  geometry.elements = mesh.triangles;
  auto &us = geometry.data[datum::kU.name], &vs = geometry.data[datum::kV.name],
       &to_aft = geometry.data[datum::kToAft.name];
  for (const auto own : mesh.triangles) {
    const auto [U, V] = mesh.meshes[own];
    const auto [u, v] = gears::twine_coordinates(plan.orientation, plan.angle, U, V);
    us.push_back(u);
    vs.push_back(v);
    to_aft.push_back(plan.depth - V);
  }
  geometry.data[datum::kBarLength.name].assign(mesh.triangles.size() / 3, plan.mesh / 2);
  geometry.data[datum::kOutward.name].assign(mesh.triangles.size() / 3, 1);
  return geometry;
}

}  // namespace

bool GearParts::is_seam(formats::TableReader& join) const {
  const bool sews = join.has("edges") && !join.has("points");
  if (sews) join.has("take_up");
  return sews;
}

GearParts::GearParts(const gears::NetPlan& plan, formats::TableReader& root, const ElementChoice& choice,
                     Draft& draft, GearMemory& memory)
    : plan_(plan),
      draft_(draft),
      diagnostics_(root.diagnostics()),
      place_(root.place("gear")),
      memory_(memory) {
  for (const char* key : {"panels", "ropes", "hang", "floats", "points", "bodies", "ship"}) root.has(key);
  const int errors_before = diagnostics_.errors();
  GearInScene& in_scene = draft_.out.gear.emplace();
  if (auto model = read_gear_model(plan, root)) {
    gear_ = std::move(model->gear);
    fineness_ = model->fineness;
    in_scene.times = gear_.extent == gears::Extent::half ? 2 : 1;
    in_scene.nodes = fineness_.nodes;
    in_scene.size = fineness_.size;
    in_scene.bill = bill_of(plan);
    in_scene.netting = netting_of(plan);
  } else {
    gear_ = gears::make_gear(plan, gears::Extent::whole);  // only for the names of the parts of the gear
  }
  insert_names();
  formats::TableReader table = root.table("elements", formats::Presence::optional);
  elements_.emplace(plan, gear_, table, choice, memory);
  is_sound_ = diagnostics_.errors() == errors_before;
}

bool GearParts::divide(const std::shared_ptr<gears::Division>& like) {
  if (!is_sound_) return false;
  try {
    division_ = memory_.divisions.of(plan_, gear_.extent, fineness_, like);
  } catch (const gears::CannotDivide& refused) {
    refused.report(plan_, diagnostics_);
    return false;
  } catch (const std::invalid_argument& cannot_be_meshed) {
    diagnostics_.error(place_, cannot_be_meshed.what());
    return false;
  }
  panels_ = memory_.panels.of(division_, [&](const auto& division) {
    auto panels = std::make_shared<DividedPanels>();
    for (std::size_t p = 0; p < division->mesh().panels.size(); ++p)
      panels->geometries.push_back(geometry_of(*gear_.panels[p].panel, division->mesh().panels[p]));
    panels->sheet = sheet_of(plan_, gear_);
    return panels;
  });
  draft_.out.gear->sheet = panels_->sheet;
  draft_.out.gear->division = division_;
  if (fineness_.knots) draft_.out.gear->nodes = mesh().nodes;
  first_.resize(mesh().nodes);
  return mesh().nodes > 0;
}

/// Reads the bodies of the plan. An error in the table of a pair is reported only once, not for both sides.
void GearParts::read_bodies(PartReader& parts) {
  std::set<const gears::PlanBody*> faulty;
  for (const gears::GearBody& body : gear_.bodies) {
    if (faulty.contains(body.body)) continue;
    const BodyOfPlan place = place_of(body);
    const bool is_pair = body.body->stands == gears::Standing::pair;
    const std::size_t part = parts.read_body_of_plan(body.name, body.body->name, is_pair ? &place : nullptr);
    if (!draft_.is_sound[part])
      faulty.insert(body.body);
    else if (division_)
      tie(body, part);
  }
}

void GearParts::read_undivided(PartReader& parts) {
  read_bodies(parts);
  if (!is_sound_) return;
  for (const auto& panel : gear_.panels) {
    Geometry one;
    one.data[datum::kBarLength.name] = {panel.panel->mesh / 2};
    add_netting(panel, std::move(one), {});
  }
  for (const auto& rope : gear_.ropes) {
    gears::RopeMesh one;
    one.rest_lengths = {rope.length};
    add_rope(rope, one);
  }
  for (const auto& pieces : gear_.pieces) {
    Part part;
    const bool is_sound = read_pieces(pieces, part);
    Geometry none;
    none.names.name = pieces.name;
    none.names.place = pieces.pieces->place;
    draft_.add_part(std::move(part), std::move(none), elements_->type_of("floats"), is_sound);
  }
}

void GearParts::insert_names() {
  const auto insert = [&](const auto& all) {
    for (const auto& one : all) names_.insert(one.name);
  };
  insert(gear_.panels);
  insert(gear_.ropes);
  insert(gear_.pieces);
  insert(gear_.points);
  insert(gear_.bodies);
}

/// The initial guess for the position of a board: the usual depth of boards behind warps of this length, but
/// not below the bed. If there are several equilibria, the guess affects which of them is found.
BodyOfPlan GearParts::place_of(const gears::GearBody& body) const {
  BodyOfPlan place{body.is_mirrored ? -1.0 : 1.0, {}};
  const gears::Rope* warp = plan_.find_rope(gears::kWarp);
  if (!plan_.ship || !warp) return place;
  place.guess = [this, warp, side = place.side](double lowest) {
    constexpr double kDepth = 0.3, kSpread = 0.09;  // usual depth and spread of a board, as fractions of the
                                                    // warp length
    const double L = warp->length, y = plan_.ship->block_gap / 2 + kSpread * L;
    const SeaBed& bed = draft_.out.scene.bed;
    const double reach = plan_.ship->block_height - kDepth * L;
    const double z = bed.is_there ? std::max(reach, bed.at(L, side * y)[0] - lowest) : reach;
    const double down = plan_.ship->block_height - z;
    return std::array{std::sqrt(std::max(L * L - down * down, 0.25 * L * L)), side * y, z};
  };
  return place;
}

/// The nodes of a closed edge, by their numbers in the gear, with the fraction of the way round at which they
/// are: 0 at the top, 1/4 to starboard, -1/4 to port.
std::map<std::uint32_t, double> GearParts::nodes_round(const BodyRim& rim) const {
  const auto dot = rim.edge.find('.');
  const auto* panel = gear_.find_panel(rim.edge.substr(0, dot));
  const auto& divided =
      panel ? mesh().panels[static_cast<std::size_t>(panel - gear_.panels.data())] : mesh().panels.front();
  const auto set = divided.sets.find(rim.edge.substr(dot + 1));
  std::map<std::uint32_t, double> nodes;
  if (!panel || set == divided.sets.end()) return nodes;
  const auto [first, last] =
      std::ranges::minmax(set->second, {}, [&](std::uint32_t own) { return divided.meshes[own][0]; });
  const double from = divided.meshes[first][0], round = divided.meshes[last][0] - from;
  if (divided.nodes[first] != divided.nodes[last]) return nodes;
  for (const auto own : set->second)
    nodes[divided.nodes[own]] = (divided.meshes[own][0] - from) / round - 0.5;
  return nodes;
}

/// Refuses a rim that is longer than the meshes of its edge can be stretched.
void GearParts::check_rim_length(const BodyRim& rim) {
  formats::Diagnostics silent;  // the check of the plan reports unknown edges
  const double stretched = gears::find_edge(plan_, rim.edge, {}, "", silent).stretched();
  if (const double length = length_of(rim); length > (1 + gears::CheckLimits{}.stretching) * stretched)
    diagnostics_.error(rim.place,
                       fmt::format("rim.edge: {} is {} long when its meshes are stretched, but the rim {}",
                                   formats::in_quotes(rim.edge), formats::in_metres(stretched, 3),
                                   formats::in_metres(length, 3)),
                       "give the rim a smaller width, or the panel more meshes round");
}

void GearParts::hang_on_rim(std::size_t part) {
  Geometry& geometry = draft_.geometries[part];
  const BodyRim& rim = *geometry.body->rim;
  const auto nodes = nodes_round(rim);
  if (nodes.empty())
    diagnostics_.error(rim.place, "rim.edge: " + formats::in_quotes(rim.edge) + " does not close to a ring",
                       "name the fore or aft edge of a panel with `round`, which goes once round the rim");
  check_rim_length(rim);
  std::size_t number = 0;
  for (const auto& [node, fraction] : nodes) {
    add_body_point(geometry, "rim-" + std::to_string(++number), point_on(rim, fraction));
    tie_point(part, geometry.body->r.size(), node);
  }
}

void GearParts::tie_point(std::size_t part, std::size_t own_node, std::uint32_t gear_node) {
  own(gear_node, {part, static_cast<std::uint32_t>(own_node)});
  for (std::size_t axis = 0; axis < 3; ++axis)
    known_.push_back(
        {gear_node, static_cast<int>(axis), draft_.geometries[part].positions[3 * own_node + axis]});
}

void GearParts::tie(const gears::GearBody& body, std::size_t part) {
  const Geometry& geometry = draft_.geometries[part];
  if (body.body->stands == gears::Standing::pair)
    draft_.out.gear->pairs[body.body->name].push_back(static_cast<std::uint32_t>(part));
  for (std::uint32_t k = 0; geometry.body && k < geometry.body->names.size(); ++k) {
    const auto node = mesh().points.find(body.name + "." + geometry.body->names[k]);
    if (node != mesh().points.end()) tie_point(part, k + 1, node->second);
  }
  if (geometry.body && geometry.body->rim) hang_on_rim(part);
}

void GearParts::read_parts(PartReader& parts) {
  read_bodies(parts);
  add_parts();
  parts.read_parts(formats::Presence::optional);
}

void GearParts::add_parts() {
  start_ = division_->start_shapes().with(gear_, known_);
  for (std::size_t p = 0; p < mesh().panels.size(); ++p)
    add_netting(gear_.panels[p], panels_->geometries[p], mesh().panels[p].nodes);
  for (std::size_t r = 0; r < mesh().ropes.size(); ++r) add_rope(gear_.ropes[r], mesh().ropes[r]);
  for (const auto& pieces : gear_.pieces) draft_.announce_rider(pieces.name);
  name_points();
}

/// Adds a panel with its twine. `nodes` contains, for each node of the panel, its number in the gear.
void GearParts::add_netting(const gears::GearPanel& panel, Geometry geometry,
                            const std::vector<std::uint32_t>& nodes) {
  const gears::Panel& plan = *panel.panel;
  geometry.names.place = plan.place;
  formats::Value twine = plan.twine;
  keep_strength(draft_.out, panel.name, plan.twine, plan.twines, plan.twine_name);
  if (plan.twines > 1 && twine.as<formats::Table>())
    formats::put(*twine.as<formats::Table>(), "number", {plan.place, std::int64_t{plan.twines}});
  add_part("netting", panel.name, "panels." + plan.name, std::move(twine), !plan.twine_name.empty(),
           std::move(geometry), nodes);
  if (plan.orientation == "t90")
    check_turned_netting(draft_.out.scene.parts.back(), plan.place, diagnostics_);
}

void GearParts::add_rope(const gears::GearRope& rope, const gears::RopeMesh& mesh) {
  Geometry geometry;
  geometry.names.sets = mesh.sets;
  geometry.names.place = rope.rope->place;
  for (std::uint32_t i = 0; i + 1 < mesh.nodes.size(); ++i)
    for (const auto end : {i, i + 1}) geometry.elements.push_back(end);
  geometry.data[datum::kRestLength.name] = mesh.rest_lengths;
  keep_strength(draft_.out, rope.name, rope.rope->rope, 1, rope.rope->part_name);
  add_part("ropes", rope.name, "ropes." + rope.rope->name, rope.rope->rope, !rope.rope->part_name.empty(),
           std::move(geometry), mesh.nodes);
}

/// Adds a panel or a rope as a part. `nodes` contains, for each node of the part, its number in the gear.
void GearParts::add_part(std::string_view kind, const std::string& name, const std::string& path,
                         formats::Value numbers, bool is_of_catalogue, Geometry geometry,
                         const std::vector<std::uint32_t>& nodes) {
  Part part;
  part.name = name;
  const bool is_sound = elements_->read_part(kind, path, std::move(numbers), is_of_catalogue, part);
  if (const auto fault = thickness_fault(part, geometry); fault && is_sound)
    diagnostics_.error(geometry.names.place, path + "." + fault->key + ": " + fault->message, kThicknessCure);
  geometry.names.name = name;
  const std::size_t p = draft_.geometries.size();
  geometry.positions.resize(3 * nodes.size());
  for (std::uint32_t own = 0; own < nodes.size(); ++own) {
    this->own(nodes[own], {p, own});
    std::copy_n(start_.begin() + 3 * std::ptrdiff_t{nodes[own]}, 3,
                geometry.positions.begin() + 3 * std::ptrdiff_t{own});
  }
  GearInScene& gear = *draft_.out.gear;
  (kind == "netting" ? gear.panels : gear.ropes).push_back(static_cast<std::uint32_t>(p));
  draft_.add_part(std::move(part), std::move(geometry), elements_->type_of(kind), is_sound);
}

void GearParts::own(std::uint32_t gear_node, const Joiner::OwnNode& node) {
  if (first_[gear_node])
    others_.push_back({gear_node, node});
  else
    first_[gear_node] = node;
}

/// Names the points of the plan that belong to no part, such as towing points.
void GearParts::name_points() {
  for (const auto& [name, node] : mesh().points)
    if (name.find('.') == std::string::npos && first_[node])
      draft_.points[name] = {first_[node]->first, {first_[node]->second}};
}

void GearParts::join(Joiner& joiner) const {
  for (const auto& [gear_node, other] : others_) joiner.join(*first_[gear_node], other);
}

std::uint32_t GearParts::scene_node(std::uint32_t gear_node) const {
  const auto& [part, own] = *first_[gear_node];
  return draft_.out.parts[part].nodes[own];
}

void GearParts::add_pieces() {
  GearInScene& gear = *draft_.out.gear;
  for (const auto& pieces : gear_.pieces) put_pieces(pieces);
  for (const auto& [name, node] : mesh().points) gear.points[point_name(name)] = scene_node(node);
  name_lines(gear);
}

bool GearParts::read_pieces(const gears::GearPieces& pieces, Part& part) const {
  part.name = pieces.name;
  return elements_->read_part("floats", "floats." + pieces.pieces->name, pieces.pieces->piece,
                              !pieces.pieces->part_name.empty(), part);
}

void GearParts::put_pieces(const gears::GearPieces& pieces) {
  formats::report({"reading", pieces.name, draft_.geometries.size(), "parts"});
  Part part;
  const bool is_sound = read_pieces(pieces, part);
  const std::map<std::uint32_t, double> carried = carried_by(pieces);
  std::vector<std::uint32_t> nodes;
  std::vector<double> lengths;
  for (const auto& [node, length] : carried) {
    nodes.push_back(node);
    lengths.push_back(length);
  }
  ride_on_nodes(nodes, lengths, pieces.number, part);
  draft_.out.gear->pieces.push_back(static_cast<std::uint32_t>(draft_.out.scene.parts.size()));
  draft_.add_rider(std::move(part), pieces.pieces->place, elements_->type_of("floats"), is_sound);
}

/// The nodes to which floats or weights are attached. Each has the length of rope or edge that it represents
/// [m].
std::map<std::uint32_t, double> GearParts::carried_by(const gears::GearPieces& pieces) const {
  std::map<std::uint32_t, double> carried;
  const auto carry = [&](std::uint32_t from, std::uint32_t to, double length) {
    carried[scene_node(from)] += length / 2;
    carried[scene_node(to)] += length / 2;
  };
  if (!pieces.point.empty()) return {{scene_node(mesh().points.at(pieces.point)), 0.0}};
  if (!pieces.rope.empty()) {
    const gears::RopeMesh& rope =
        mesh().ropes[static_cast<std::size_t>(gear_.find_rope(pieces.rope) - gear_.ropes.data())];
    for (std::size_t i = 1; i < rope.nodes.size(); ++i)
      carry(rope.nodes[i - 1], rope.nodes[i], rope.rest_lengths[i - 1]);
  }
  for (const auto& ref : pieces.edges) {
    const gears::PanelMesh& panel = mesh().panels[ref.panel];
    const auto& edge = panel.sets.at(gear_.panels[ref.panel].outline.edges[ref.edge].name);
    for (std::size_t i = 1; i < edge.size(); ++i) {
      const auto &a = panel.meshes[edge[i - 1]], &b = panel.meshes[edge[i]];
      carry(panel.nodes[edge[i - 1]], panel.nodes[edge[i]], std::hypot(b[0] - a[0], b[1] - a[1]));
    }
  }
  return carried;
}

/// Stores in `gear` the roles that the plan gives to its ropes.
void GearParts::name_lines(GearInScene& gear) const {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r) {
    const gears::Rope& rope = *gear_.ropes[r].rope;
    if (rope.stands == gears::Standing::middle) gear.across.insert(gear.ropes[r]);
    if (rope.role == "headline")
      gear.headline = gear_.ropes[r].name;
    else if (rope.role == "footrope")
      gear.footrope = gear_.ropes[r].name;
    else if (!rope.role.empty())
      gear.roles[rope.role].push_back(gear.ropes[r]);
  }
}

/// The name of a point in reports. An end of a rope that runs from port to starboard has the same name in the
/// whole gear and in half a gear.
std::string GearParts::point_name(const std::string& name) const {
  const auto dot = name.find('.');
  const gears::GearRope* rope = dot == std::string::npos ? nullptr : gear_.find_rope(name.substr(0, dot));
  if (!rope || rope->rope->stands != gears::Standing::middle) return name;
  const bool is_whole = gear_.extent == gears::Extent::whole;
  const std::string end = name.substr(dot + 1);
  if (end == "start") return rope->name + (is_whole ? ".port" : ".middle");
  return end == "end" ? rope->name + ".starboard" : name;
}

/// Whether all nodes of a rope of the plan are in `carried`. For a pair of ropes, only the starboard rope is
/// tested.
bool GearParts::is_carried(const std::string& rope, const std::set<std::uint32_t>& carried) const {
  if (carried.empty()) return false;
  const gears::GearRope* one = gear_.find_rope(rope);
  if (!one) one = gear_.find_rope("starboard-" + rope);
  return one && std::ranges::all_of(mesh().ropes[static_cast<std::size_t>(one - gear_.ropes.data())].nodes,
                                    [&](auto node) { return carried.contains(scene_node(node)); });
}

bool GearParts::is_carried_at(const std::string& point, const std::set<std::uint32_t>& carried) const {
  if (carried.empty()) return false;
  for (const std::string& name : {point, "starboard-" + point})
    if (const auto node = mesh().points.find(name); node != mesh().points.end())
      return carried.contains(scene_node(node->second));
  return false;
}

namespace {

/// Replaces the key `number`, the number of pieces on one board, by the key `each`, the number at each of its
/// contact points. `each` is the same whether one board or both are modelled. `shoes` is the number of
/// contact points of one board.
void count_on_one_side(formats::Table& contact, double shoes) {
  if (contact.find("each")) return;
  double pieces = 1;
  if (const formats::Member* said = contact.find("number")) {
    const double* real = said->value.as<double>();
    const std::int64_t* whole = said->value.as<std::int64_t>();
    pieces = real ? *real : whole ? static_cast<double>(*whole) : -1;
    if (!(pieces >= 0)) return;  // this error is reported when `pieces` is read
    std::erase_if(contact.members, [](const formats::Member& m) { return m.key == "number"; });
  }
  formats::put(contact, "each", {contact.members.front().place, pieces / shoes});
}

}  // namespace

std::vector<std::pair<std::string, formats::Value>> GearParts::contacts(
    const std::set<std::uint32_t>& carried) const {
  std::vector<std::pair<std::string, formats::Value>> all;
  if (!elements_->has_contact()) return all;
  for (const gears::Rope& rope : plan_.ropes)
    if (rests_on_bed(rope) && !is_carried(rope.name, carried))
      all.emplace_back(rope.name + "-on-bed", elements_->contact_of(rope.name, {rope.name}, rope.place));
  for (const gears::PlanBody& body : plan_.bodies) {
    auto shoes = shoes_of(body);
    std::erase_if(shoes, [&](const auto& shoe) { return is_carried_at(shoe, carried); });
    if (shoes.empty()) continue;
    const auto of_one_side = static_cast<double>(shoes.size());
    formats::Value contact = elements_->contact_of(body.name, std::move(shoes), body.place);
    count_on_one_side(*contact.as<formats::Table>(), of_one_side);
    all.emplace_back(body.name + "-on-bed", std::move(contact));
  }
  return all;
}

bool GearParts::sinks_into_bed(const std::set<std::uint32_t>& carried) const {
  if (!plan_.ship || elements_->has_contact()) return false;
  return std::ranges::any_of(plan_.ropes, [&](const gears::Rope& rope) {
    return rope.role == "footrope" && !is_carried(rope.name, carried);
  });
}

/// The rope in the middle with a role; nullptr if there is none, with the reason. The plan has at most one.
const gears::RopeMesh* GearParts::rope_of_role(const std::string& role, std::string& why_not) const {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r)
    if (gear_.ropes[r].rope->role == role && gear_.ropes[r].rope->stands == gears::Standing::middle)
      return &mesh().ropes[r];
  why_not = "no rope in the middle of the net plan has the role " + role;
  return nullptr;
}

/// Whether a panel is a wing. One side of a wing hangs on the headline or the footrope. A wing is ahead of
/// the mouth, with undisturbed water on both faces.
bool GearParts::is_wing(const gears::GearPanel& panel) const {
  return std::ranges::any_of(plan_.hangings, [&](const gears::Hanging& hanging) {
    const gears::Rope* rope = plan_.find_rope(hanging.rope);
    if (!rope || (rope->role != "headline" && rope->role != "footrope")) return false;
    return std::ranges::any_of(panel.panel->outline.edges, [&](const gears::OutlineEdge& edge) {
      const bool is_side = edge.kind == gears::EdgeKind::inner || edge.kind == gears::EdgeKind::outer;
      return is_side && hanging.edge == panel.panel->name + "." + edge.name;
    });
  });
}

std::optional<Bag> GearParts::bag(std::string& why_not) const {
  const gears::RopeMesh *headline = rope_of_role("headline", why_not),
                        *footrope = headline ? rope_of_role("footrope", why_not) : nullptr;
  if (!headline || !footrope) return {};
  Bag bag;
  for (const auto node : footrope->nodes) bag.rim.push_back(scene_node(node));
  for (auto node = headline->nodes.rbegin(); node != headline->nodes.rend(); ++node)
    bag.rim.push_back(scene_node(*node));
  for (std::size_t p = 0; p < gear_.panels.size(); ++p) {
    const bool wing = is_wing(gear_.panels[p]);
    (wing ? bag.ahead : bag.behind).push_back(draft_.out.gear->panels[p]);
    for (const auto& edge : gear_.panels[p].panel->open)
      if (!wing) bag.open.insert(gear_.panels[p].panel->name + "." + edge.name);
  }
  const auto bears_netting = [&](const gears::Rope& rope) {
    return std::ranges::any_of(plan_.hangings,
                               [&](const auto& hanging) { return hanging.rope == rope.name; });
  };
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r)
    if (bears_netting(*gear_.ropes[r].rope)) bag.ahead.push_back(draft_.out.gear->ropes[r]);
  for (std::size_t i = 0; i < gear_.pieces.size(); ++i) {
    const gears::GearRope* rope = gear_.find_rope(gear_.pieces[i].rope);
    if (rope ? bears_netting(*rope->rope) : !gear_.pieces[i].edges.empty())
      bag.ahead.push_back(draft_.out.gear->pieces[i]);
  }
  return bag;
}

void GearParts::add_holds() {
  hold_middle();
  hold_blocks();
}

void GearParts::hold_middle() {
  if (mesh().middle.empty()) return;
  Scene& scene = draft_.out.scene;
  Hold hold{kPlaneOfSymmetry, {}, {}};
  for (const auto node : mesh().middle) {
    hold.nodes.push_back(scene_node(node));
    hold.axes.push_back(kAxisY);
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
    if (point.point->name != gears::kBlock) continue;
    const std::uint32_t node = scene_node(mesh().points.at(point.name));
    hold.nodes.push_back(node);
    hold.axes.push_back(kAllAxes);
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

/// Prepares warps on winches; each warp starts at its block. If a warp has a given tension, its length
/// becomes an unknown of the search for the equilibrium (Setting in framework/scene/scene.hpp). In a motion,
/// a winch follows the program in the plan; without a program, it keeps the tension constant.
void GearParts::set_winches() {
  for (std::size_t r = 0; r < gear_.ropes.size(); ++r) {
    const gears::GearRope& rope = gear_.ropes[r];
    const gears::Rope& plan = *rope.rope;
    if (!plan.tension && plan.winch.empty()) continue;
    const std::uint32_t block = scene_node(mesh().ropes[r].nodes.front());
    const double tension = plan.tension.value_or(0),
                 wanted = rope.is_mirrored ? plan.tension_port.value_or(tension) : tension;
    if (plan.tension)
      draft_.out.scene.settings.push_back({"length of " + rope.name, rope.name, datum::kRestLength.name,
                                           datum::kRestLength.unit, block, wanted});
    Winch winch{rope.name, parameter::kLengthShare.name, block,
                rope.is_mirrored ? plan.length_port.value_or(plan.length) : plan.length, plan.winch};
    if (winch.stages.empty())
      winch.stages.push_back({.max_speed = gears::kWinchSpeed, .band = gears::kWinchBand * tension});
    WinchStage& first = winch.stages.front();
    if (plan.tension && first.follows == WinchStage::Follows::tension && first.rows.size() < 2)
      first.rows = {{0, wanted}};
    draft_.out.scene.winches.push_back(std::move(winch));
  }
}

void GearParts::follow_holds() {
  if (mesh().nodes == 0) return;
  Scene& scene = draft_.out.scene;
  std::vector<gears::KnownCoordinate> known = known_;
  for (std::uint32_t node = 0; node < mesh().nodes; ++node) {
    const auto in = scene_node(node);
    for (int axis = 0; axis < 3; ++axis)
      if (scene.held[in] & (1 << axis) && !scene.frames.contains(in))
        known.push_back({node, axis, scene.positions[3 * std::size_t{in} + static_cast<std::size_t>(axis)]});
  }
  const auto start = division_->start_shapes().with(gear_, known);
  for (std::uint32_t node = 0; node < mesh().nodes; ++node)
    std::copy_n(start.begin() + 3 * std::ptrdiff_t{node}, 3,
                scene.positions.begin() + 3 * std::ptrdiff_t{scene_node(node)});
}

void GearParts::refuse_motions() const {
  const auto refuse = [&](const char* what, formats::Place place) {
    diagnostics_.error(place,
                       std::string(what) + " has no effect, because nothing moves in a static analysis",
                       "kind = \"dynamic\" in [analysis], or leave it out");
  };
  if (plan_.ship && !plan_.ship->path.empty()) refuse("ship.path", plan_.ship->path_place);
  for (const auto& rope : plan_.ropes)
    if (!rope.winch.empty()) refuse("ship.warp.winch", rope.winch_place);
}

void GearParts::complete_winches(Registry& registry) const {
  ready_winches(plan_, registry, draft_.out, diagnostics_);
}

bool GearParts::has_name(const std::string& name) const { return names_.contains(name); }

}  // namespace netloft::scenes
