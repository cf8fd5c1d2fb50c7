// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace netloft::gears {

namespace {

std::string name_of(const Panel& panel, const OutlineEdge& edge) { return panel.name + "." + edge.name; }

/// The edges of a plan that are sewn or hung, and the line of the plan that says so: for example, "body.aft"
/// is sewn at line 40.
class EdgeUses {
 public:
  explicit EdgeUses(const NetPlan& plan) {
    for (const auto& join : plan.joins)
      for (std::size_t row = 0; row < join.edges.size(); ++row)
        for (const auto& name : join.edges[row]) enter(plan, name, "sewn", join.places[row]);
    for (const auto& hanging : plan.hangings) enter(plan, hanging.edge, "hung", hanging.edge_place);
    for (const auto& body : plan.bodies)
      if (!body.rim.empty()) enter(plan, body.rim, "hung", body.rim_place);
  }

  struct Use {
    const char* word;
    formats::Place place;
  };
  const Use* find(const std::string& edge) const {
    const auto at = done_.find(edge);
    return at == done_.end() ? nullptr : &at->second;
  }

 private:
  void enter(const NetPlan& plan, const std::string& name, const char* word, const formats::Place& place) {
    formats::Diagnostics silent;
    const EdgeSet set = find_edge(plan, name, {}, "", silent);
    for (const auto& edge : set.edges) done_.emplace(name_of(*set.panel, edge), Use{word, place});
  }
  std::map<std::string, Use> done_;
};

/// Proposals of other edges that a panel could list as open.
Cures cures_of_open(const Panel& panel, const std::vector<std::string>& names) {
  formats::Array array;
  for (const auto& name : names) array.items.push_back(as_text(name));
  return {set(path_of({"panels", panel.name, "open"}), {{}, array})};
}

std::vector<std::string> without(const Panel& panel, const OpenEdge& edge) {
  std::vector<std::string> names;
  for (const auto& said : panel.open)
    if (said.name != edge.name) names.push_back(said.name);
  return names;
}

std::vector<std::string> with(const Panel& panel, const std::string& edge) {
  std::vector<std::string> names;
  for (const auto& said : panel.open) names.push_back(said.name);
  names.push_back(edge);
  return names;
}

/// The names of the edges that a panel declares open. Reports declared edges that are sewn or hung.
std::set<std::string> said_open(const NetPlan& plan, const Panel& panel, const EdgeUses& uses,
                                formats::Diagnostics& diagnostics) {
  std::set<std::string> open;
  const std::string path = "panels." + panel.name + ".open";
  for (const auto& said : panel.open) {
    const EdgeSet set = find_edge(plan, panel.name + "." + said.name, said.place, path, diagnostics);
    for (const auto& edge : set.edges) {
      open.insert(name_of(panel, edge));
      if (const auto* use = uses.find(name_of(panel, edge)))
        diagnostics.error(said.place,
                          fmt::format("{}: {} is declared open, but is {} at {}", path, name_of(panel, edge),
                                      use->word, diagnostics.where(use->place)),
                          "leave one of them out", cures_of_open(panel, without(panel, said)));
    }
  }
  return open;
}

/// The place in the file at which a plan defines an edge.
formats::Place place_of(const Panel& panel, const OutlineEdge& edge) {
  for (const auto* counts : {&panel.fore, &panel.aft})
    for (const auto& count : *counts)
      if (count.name == edge.name) return count.place;
  for (const auto* side : {&panel.outer, &panel.inner})
    for (const auto& cut : *side)
      if (cut.name == edge.name) return cut.place;
  return panel.place;
}

}  // namespace

void check_open_edges(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  const EdgeUses uses(plan);
  for (const auto& panel : plan.panels) {
    const auto open = said_open(plan, panel, uses, diagnostics);
    for (const auto& edge : panel.outline.edges) {
      const std::string name = name_of(panel, edge);
      if (edge.kind == EdgeKind::middle || uses.find(name) || open.contains(name)) continue;
      diagnostics.warning(place_of(panel, edge), name + " is neither sewn nor hung: the net is open there",
                          "sew it with [[join]], hang it with [[hang]], or declare it open",
                          diagnostics.wants_cures() ? cures_of_open(panel, with(panel, edge.name)) : Cures{});
    }
  }
}

}  // namespace netloft::gears
