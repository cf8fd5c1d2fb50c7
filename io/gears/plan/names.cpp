// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/names.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>

namespace netloft::gears {

namespace {

struct DottedName {
  std::string owner, rest;
};

DottedName split(const std::string& name) {
  const auto dot = name.find('.');
  if (dot == std::string::npos) return {name, ""};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

bool stands_for(std::string_view word, const OutlineEdge& edge) {
  switch (edge.kind) {
    case EdgeKind::fore:
      return word == "fore" || word == edge.name;
    case EdgeKind::aft:
      return word == "aft" || word == edge.name;
    case EdgeKind::outer:
      return word == "outer" || word == "sides" || word == edge.name;
    case EdgeKind::inner:
      return word == "inner" || word == edge.name;
    default:
      return false;  // such an edge is sewn to its mirror image only
  }
}

std::vector<std::string> edge_names(const Panel& panel) {
  std::vector<std::string> names;
  for (const auto& edge : panel.outline.edges)
    if (edge.kind != EdgeKind::middle) names.push_back(panel.name + "." + edge.name);
  return names;
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(one.name);
  return names;
}

/// A hint for a wrong name: "did you mean …" with the nearest of `names`, or a list of all names.
std::string near_names(const std::string& name, const std::vector<std::string>& names) {
  if (const auto near = nearest(name, names)) return "did you mean \"" + *near + "\"?";
  std::string text;
  for (const auto& n : names) text += (text.empty() ? "there are " : ", ") + n;
  return text.empty() ? "there are none" : text;
}

const Panel* find_panel_or_say(const NetPlan& plan, const std::string& name, const formats::Place& place,
                               const std::string& path, formats::Diagnostics& diagnostics) {
  const Panel* panel = plan.find_panel(name);
  if (!panel)
    diagnostics.error(place, path + ": there is no panel \"" + name + "\"",
                      plan.find_rope(name)        ? "\"" + name + "\" is a rope"
                      : diagnostics.wants_hints() ? near_names(name, names_of(plan.panels))
                                                  : "");
  return panel;
}

}  // namespace

HangingsByRope hangings_by_rope(const NetPlan& plan) {
  HangingsByRope all;
  for (const Hanging& hanging : plan.hangings) all.emplace(hanging.rope, &hanging);
  return all;
}

double EdgeSet::meshes() const {
  double sum = 0;
  for (const auto& edge : edges) sum += edge.meshes;
  return is_across_middle() ? 2 * sum : sum;
}

double EdgeSet::stretched() const {
  double sum = 0;
  for (const auto& edge : edges) sum += edge.stretched;
  return (is_across_middle() ? 2 : 1) * sum * (panel ? panel->mesh : 0);
}

int EdgeSet::times() const {
  const bool once = !panel || panel->stands == Standing::alone || is_across_middle();
  return once ? 1 : 2;
}

bool EdgeSet::is_side() const {
  return !edges.empty() && (edges[0].kind == EdgeKind::outer || edges[0].kind == EdgeKind::inner);
}

bool EdgeSet::is_across_middle() const {
  return panel && panel->stands == Standing::middle && !is_side() &&
         std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.from.x == 0 || e.to.x == 0; });
}

EdgeSet find_edge(const NetPlan& plan, const std::string& name, const formats::Place& place,
                  const std::string& path, formats::Diagnostics& diagnostics) {
  const DottedName dotted = split(name);
  const Panel* panel = find_panel_or_say(plan, dotted.owner, place, path, diagnostics);
  if (!panel) return {};
  EdgeSet set{panel, {}};
  if (panel->is_empty()) return set;  // for a panel without edges, an error was reported before
  for (const auto& edge : panel->outline.edges)
    if (stands_for(dotted.rest, edge)) set.edges.push_back(edge);
  if (set.edges.empty())
    diagnostics.error(place, path + ": the panel " + panel->name + " has no edge \"" + dotted.rest + "\"",
                      near_names(name, edge_names(*panel)));
  return set;
}

std::vector<std::string> corner_names(const Panel& panel) {
  std::vector<std::string> names = {"fore-outer", "fore-inner", "aft-outer", "aft-inner"};
  for (const auto* side : {&panel.outer, &panel.inner})
    for (std::size_t i = 0; i + 1 < side->size(); ++i) names.push_back((*side)[i].name + "-aft");
  return names;
}

Standing standing_of(const NetPlan& plan, const std::string& name) {
  if (const Rope* rope = plan.find_rope(name)) return rope->stands;
  if (const Panel* panel = plan.find_panel(name)) return panel->stands;
  if (const Point* point = plan.find_point(name)) return point->stands;
  if (const PlanBody* body = plan.find_body(name)) return body->stands;
  return Standing::alone;
}

bool is_on_both_sides(const NetPlan& plan, const std::string& name) {
  const auto [owner, rest] = split(name);
  const PlanBody* body = plan.find_body(owner);
  return body && body->stands == Standing::middle && body->find_point("port-" + rest) &&
         body->find_point("starboard-" + rest);
}

bool is_corner_in_middle(const std::string& corner) {
  return corner == "fore-inner" || corner == "aft-inner";
}

Standing standing_of_point(const NetPlan& plan, const std::string& name) {
  if (is_on_both_sides(plan, name)) return Standing::pair;
  const auto [owner, rest] = split(name);
  const Standing stands = standing_of(plan, owner);
  const bool is_aside = plan.find_panel(owner) ? !is_corner_in_middle(rest) : rest == "end";
  return stands == Standing::middle && is_aside ? Standing::pair : stands;
}

std::string find_point_owner(const NetPlan& plan, const std::string& name, const formats::Place& place,
                             const std::string& path, formats::Diagnostics& diagnostics) {
  const DottedName dotted = split(name);
  const auto is_one_of = [&](const std::vector<std::string>& words) {
    return std::find(words.begin(), words.end(), dotted.rest) != words.end();
  };
  std::vector<std::string> known;
  if (const Panel* panel = plan.find_panel(dotted.owner)) {
    if (is_one_of(corner_names(*panel))) return panel->name;
    for (const auto& corner : corner_names(*panel)) known.push_back(panel->name + "." + corner);
  } else if (const Rope* rope = plan.find_rope(dotted.owner)) {
    if (is_one_of({"middle", "end"}) || (dotted.rest == "start" && rope->stands != Standing::middle))
      return rope->name;
    known = {rope->name + ".middle", rope->name + ".end"};
    if (rope->stands != Standing::middle) known.insert(known.begin(), rope->name + ".start");
  } else {
    if (plan.find_point(name) || is_on_both_sides(plan, name)) return name;
    if (diagnostics.wants_hints()) known = names_of(plan.points);
    for (std::size_t r = 0; diagnostics.wants_hints() && r < plan.ropes.size(); ++r)
      known.push_back(plan.ropes[r].name + ".end");
  }
  diagnostics.error(place, path + ": there is no point \"" + name + "\"", near_names(name, known));
  return {};
}

const Rope* find_rope_or_say(const NetPlan& plan, const std::string& name, const formats::Place& place,
                             const std::string& path, formats::Diagnostics& diagnostics) {
  const Rope* rope = plan.find_rope(name);
  if (!rope)
    diagnostics.error(place, path + ": there is no rope \"" + name + "\"",
                      plan.find_panel(name)       ? "\"" + name + "\" is a panel"
                      : diagnostics.wants_hints() ? near_names(name, names_of(plan.ropes))
                                                  : "");
  return rope;
}

}  // namespace netloft::gears
