// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/flow_reader.hpp"

#include "framework/scene/scene_plan.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace netloft::scenes {

namespace {

constexpr const char *kFlow = "flow", *kRim = "rim", *kBehind = "behind", *kAhead = "ahead";

/// Whether some force term of an element type depends on the water in a way that a flow can change.
bool sees_water(const ElementType& type) {
  return std::ranges::any_of(type.terms, [](const auto& term) { return sees_changed_water(term.traits); });
}

/// Joins the node lists of consecutive edges into one. An edge is reversed if its end is nearer to the
/// previous edge than its beginning.
std::vector<std::uint32_t> chained(std::vector<std::vector<std::uint32_t>> edges, const Scene& scene) {
  const auto apart = [&](std::uint32_t a, std::uint32_t b) {
    double squares = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      squares += std::pow(
          scene.positions[3 * std::size_t{a} + axis] - scene.positions[3 * std::size_t{b} + axis], 2);
    return squares;
  };
  const auto to_ends = [&](std::uint32_t node, const std::vector<std::uint32_t>& edge) {
    return std::min(apart(node, edge.front()), apart(node, edge.back()));
  };
  std::vector<std::uint32_t> chain;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    auto& edge = edges[i];
    const bool turns =
        !chain.empty() ? apart(chain.back(), edge.back()) < apart(chain.back(), edge.front())
                       : edges.size() > 1 && to_ends(edge.front(), edges[1]) < to_ends(edge.back(), edges[1]);
    if (turns) std::ranges::reverse(edge);
    for (const auto node : edge)
      if (chain.empty() || chain.back() != node) chain.push_back(node);
  }
  if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
  return chain;
}

}  // namespace

/// The element type of the flow; nullptr after an error, or if `type` is "none".
const ElementType* FlowReader::find_type(formats::TableReader& table) const {
  const std::string name =
      read_name(table, "type", "how the net changes the water, such as \"flow/momentum\"");
  return name == "none" ? nullptr : elements_.find_flow(name, table);
}

void FlowReader::read_undivided() {
  if (!root_.has(kFlow)) return;
  formats::TableReader table = root_.table(kFlow);
  Part part;
  if (const ElementType* type = find_type(table)) elements_.read(*type, table, part);
  for (const char* key : {kRim, kBehind, kAhead}) table.has(key);
  table.finish();
}

void FlowReader::read() {
  if (!root_.has(kFlow)) return;
  formats::TableReader table = root_.table(kFlow);
  const int errors_before = diagnostics_.errors();
  Part flow;
  flow.name = kFlow;
  const ElementType* type = find_type(table);
  if (type) elements_.read(*type, table, flow);
  const std::optional<Bag> bag = find_bag(table);
  table.finish();
  if (!type || !bag || diagnostics_.errors() > errors_before) return;
  if (!draft_.out.scene.current.flows())
    diagnostics_.warning(table.place(),
                         "the water is at rest, so that no net can slow it: [flow] has no effect, and the "
                         "report has no figures of the water in the net",
                         "add [tow] speed = \"3 kn\", or leave [flow] out");
  warn_of_openings(*bag, table.place());
  warn_of_shielding(*bag, table.place());
  for (std::size_t i = 0; i < bag->rim.size(); ++i)
    flow.nodes.insert(flow.nodes.end(), {bag->rim[i], bag->rim[(i + 1) % bag->rim.size()]});
  put_in_reach(bag->ahead, 0);
  put_in_reach(bag->behind, 1);
  draft_.add_rider(std::move(flow), table.place(), type, true);
}

/// The bag that the table describes; if it describes none, the bag of the net plan.
std::optional<Bag> FlowReader::find_bag(formats::TableReader& table) const {
  if (table.has(kRim)) return read_bag(table);
  for (const char* key : {kBehind, kAhead})
    if (table.has(key))
      table.error(key, "needs the rim of the mouth", "add rim = [\"PART.EDGE\", …], a closed curve of edges");
  std::string why_not;
  auto bag = gear_.bag(why_not);
  if (!bag)
    table.error(
        "type",
        "the scene has no mouth through which water could enter a net" +
            (why_not.empty() ? "" : ": " + why_not),
        "give one rope of the net plan role = \"headline\" and one role = \"footrope\", both with stands "
        "= \"middle\"; or name the rim and the netting: rim = [\"net.fore\"], behind = [\"net\"]");
  return bag;
}

Bag FlowReader::read_bag(formats::TableReader& table) const {
  Bag bag;
  bag.rim = read_rim(table);
  bag.behind = read_parts(table, kBehind, "parts of the net behind the mouth");
  if (table.has(kAhead)) bag.ahead = read_parts(table, kAhead, "parts of the net that meet the water first");
  for (std::size_t i = 0; i < bag.ahead.size(); ++i)
    if (std::ranges::count(bag.behind, bag.ahead[i]))
      table.error(kAhead, formats::in_quotes(draft_.out.scene.parts[bag.ahead[i]].name) +
                              " is behind the mouth, too; name it once");
  if (diagnostics_.errors() == 0) bag.open = find_openings(bag);
  return bag;
}

/// The nodes of the rim in the order in which its edges are named, in the direction that momentum.hpp
/// expects.
std::vector<std::uint32_t> FlowReader::read_rim(formats::TableReader& table) const {
  const auto names = table.texts(kRim, {.doc = "edges that form a closed curve", .count = {.least = 1}});
  std::vector<std::vector<std::uint32_t>> edges;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto set = draft_.find_nodes(mention_of_item(names[i], table, kRim, i)))
      edges.push_back(draft_.scene_nodes(*set));
  std::vector<std::uint32_t> rim = chained(std::move(edges), draft_.out.scene);
  if (diagnostics_.errors() == 0 && !turn_to_current(rim))
    table.error(kRim, "encloses no area across the current, so that no water enters",
                "name the edges around the mouth in their order, with a sketch in which the mouth is open");
  return rim;
}

/// Turns the rim such that it is counter-clockwise for an observer towards whom the water flows, in
/// projection on the plane across the current. Returns false if the rim encloses no area.
bool FlowReader::turn_to_current(std::vector<std::uint32_t>& rim) const {
  const Scene& scene = draft_.out.scene;
  const auto at = [&](std::size_t i, std::size_t axis) {
    return scene.positions[3 * std::size_t{rim[i % rim.size()]} + axis];
  };
  double flux = 0, length = 0, speed = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    std::array<double, 3> u{}, dz{};
    scene.current.at(0.5 * (at(i, 2) + at(i + 1, 2)), u, dz);
    const auto across = [&](std::size_t k) { return u[0] * at(k, 1) - u[1] * at(k, 0); };
    flux += 0.5 * (across(i) + across(i + 1)) * (at(i + 1, 2) - at(i, 2));
    length += std::hypot(at(i + 1, 0) - at(i, 0), at(i + 1, 1) - at(i, 1), at(i + 1, 2) - at(i, 2));
    speed = std::max(speed, std::hypot(u[0], u[1]));
  }
  if (flux < 0) std::ranges::reverse(rim);
  constexpr double kClosed = 1e-9;  // area over length², which is 0.08 for a circle; rounding leaves 1e-15
  return speed == 0 || std::abs(flux) > kClosed * speed * length * length;
}

/// The indices of the parts that a list names.
std::vector<std::uint32_t> FlowReader::read_parts(formats::TableReader& table, const char* key,
                                                  const char* doc) const {
  std::vector<std::uint32_t> parts;
  const auto names = table.texts(key, {.doc = doc, .count = {.least = 1}});
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Mention mention = mention_of_item(names[i], table, key, i);
    const auto part = draft_.part_number(names[i]);
    if (!part) draft_.find_nodes(mention);  // reports the unknown name
    // the type is nullptr after an error in the part
    const ElementType* type = part ? draft_.types[*part] : nullptr;
    if (type && !sees_water(*type))
      diagnostics_.error(mention.place, mention.path + ": " + formats::in_quotes(names[i]) +
                                            " has no drag that depends on the water");
    if (!type) continue;
    if (std::ranges::count(parts, *part))
      diagnostics_.error(mention.place,
                         mention.path + ": " + formats::in_quotes(names[i]) + " is named twice");
    parts.push_back(static_cast<std::uint32_t>(*part));
  }
  return parts;
}

/// Names of the netting behind the mouth with open edges apart from the rim and the plane of symmetry, y = 0.
std::set<std::string> FlowReader::find_openings(const Bag& bag) const {
  const Scene& scene = draft_.out.scene;
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> parts_at;  // of every edge of netting
  for (const auto* parts : {&bag.behind, &bag.ahead})
    for (const std::uint32_t p : *parts) {
      const auto& nodes = scene.parts[p].nodes;
      if (draft_.types[p]->element.stencil != NETLOFT_TRIANGLE) continue;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const auto [a, b] = std::minmax(nodes[n], nodes[n % 3 == 2 ? n - 2 : n + 1]);
        if (a != b) parts_at[{a, b}].push_back(p);
      }
    }
  const std::set<std::uint32_t> rim(bag.rim.begin(), bag.rim.end());
  std::set<std::string> open;
  for (const auto& [edge, parts] : parts_at) {
    const auto is_cut = [&](std::uint32_t node) { return scene.positions[3 * std::size_t{node} + 1] == 0; };
    const bool is_closed = parts.size() > 1 || !std::ranges::count(bag.behind, parts[0]) ||
                           (rim.contains(edge[0]) && rim.contains(edge[1])) ||
                           (is_cut(edge[0]) && is_cut(edge[1]));
    if (!is_closed) open.insert(scene.parts[parts[0]].name);
  }
  return open;
}

void FlowReader::warn_of_openings(const Bag& bag, const formats::Place& place) const {
  if (bag.open.empty()) return;
  std::string names;
  for (const auto& name : bag.open) names += (names.empty() ? "" : ", ") + name;
  diagnostics_.warning(place,
                       "water leaves the bag through open edges, " + names +
                           ": the flow supposes that all water that enters the mouth passes the netting",
                       "close them, or name as `behind` all netting up to the cod-end");
}

/// Warns if a law of drag reduces the velocity that the flow reduces, too.
void FlowReader::warn_of_shielding(const Bag& bag, const formats::Place& place) const {
  for (const auto* parts : {&bag.behind, &bag.ahead})
    for (const std::uint32_t p : *parts)
      for (const auto& [slot, law] : draft_.out.scene.parts[p].laws) {
        const auto given = law.parameters.find("shielding");
        const double* factor = given == law.parameters.end() ? nullptr : std::get_if<double>(&given->second);
        if (!factor || *factor == 1) continue;
        diagnostics_.warning(place,
                             "the " + slot + " of " + draft_.out.scene.parts[p].name +
                                 " has a shielding other than 1, so that the water is slowed twice",
                             "leave out shielding, or [flow]");
        return;
      }
}

void FlowReader::put_in_reach(const std::vector<std::uint32_t>& parts, double reach) {
  Scene& scene = draft_.out.scene;
  for (const std::uint32_t p : parts) {
    Part& part = scene.parts[p];
    part.flow = static_cast<std::uint32_t>(scene.parts.size());
    part.reach.assign(part.nodes.size() / static_cast<std::size_t>(draft_.types[p]->nodes()), reach);
  }
}

}  // namespace netloft::scenes
