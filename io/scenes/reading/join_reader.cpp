// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/join_reader.hpp"

#include "io/formats/units/in_quotes.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/scenes/reading/element_choice.hpp"

namespace netloft::scenes {

void JoinReader::read() {
  Joiner joiner(draft_.geometries);
  join_by_others(joiner);
  for (auto& table : root_.tables("join")) {
    if (gear_.is_seam(table)) continue;
    read_join(table, joiner);
  }
  if (diagnostics_.errors() == 0) check_joins(joiner);
  number(joiner);
}

/// Joins nodes that parts have in common because a mesh file or the net plan says so.
void JoinReader::join_by_others(Joiner& joiner) const {
  meshes_.connect(joiner);
  gear_.join(joiner);
}

void JoinReader::read_join(formats::TableReader& table, Joiner& joiner) {
  const int errors_before = diagnostics_.errors();
  const bool together = table.boolean("together", {.doc = "all nodes become one", .fallback = false});
  const auto points = table.texts(
      "points",
      {.doc =
           "two or more points or edges that are joined, or one edge whose nodes are gathered in one point",
       .count = {.least = together ? 1u : 2u}});
  if (diagnostics_.errors() > errors_before) return;
  formats::report({"joining", points[0], joins_.size(), "joins"});
  std::vector<Joiner::Ends> sets;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (auto set = draft_.find_nodes(mention_of_item(points[i], table, "points", i))) sets.push_back(*set);
  if (sets.size() != points.size() || !can_be_joined(sets, points, table, together)) return;
  joins_.push_back({sets, mention("", table, "points"), together});
  joins_.back().make(joiner);
}

bool JoinReader::can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                               formats::TableReader& table, bool together) {
  std::set<std::pair<std::size_t, std::vector<std::uint32_t>>> seen;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (!draft_.is_sound[sets[s].part]) return false;  // the number of nodes may be wrong
    if (!together && sets[s].own.size() != sets[0].own.size()) {
      table.error("points",
                  formats::in_quotes(points[0]) + " has " + std::to_string(sets[0].own.size()) + " nodes, " +
                      formats::in_quotes(points[s]) + " has " + std::to_string(sets[s].own.size()) +
                      "; only sets with equally many nodes can be joined",
                  "give both the same cells, join node by node (net.node-17), or write together = true to "
                  "gather all in one");
      return false;
    }
    if (!seen.emplace(sets[s].part, sets[s].own).second) {
      table.error("points", formats::in_quotes(points[s]) + " is joined to itself");
      return false;
    }
  }
  return true;
}

/// The first element that has two nodes which the first `number` joins merge.
std::optional<Joiner::Collapse> JoinReader::find_collapse(std::size_t number) const {
  formats::hear_interruption();
  Joiner joiner(draft_.geometries);
  join_by_others(joiner);
  for (std::size_t j = 0; j < number; ++j) joins_[j].make(joiner);
  return joiner.find_collapse(nodes_per_element(draft_.types));
}

/// Reports the first join that merges two nodes of an element, as an error. It is found by bisection.
void JoinReader::check_joins(Joiner& joiner) const {
  if (joins_.empty() || !joiner.find_collapse(nodes_per_element(draft_.types))) return;
  std::size_t without = 0, with = joins_.size();
  while (with - without > 1) {
    const std::size_t middle = without + (with - without) / 2;
    (find_collapse(middle) ? with : without) = middle;
  }
  const Mention& at = joins_[with - 1].at;
  const Joiner::Collapse fault = *find_collapse(with);
  diagnostics_.error(at.place,
                     at.path + ": " + formats::in_quotes(draft_.out.scene.parts[fault.part].name) +
                         " element " + std::to_string(fault.element) +
                         " would have two of its corners in one node, and no size",
                     "join nodes that are not neighbours; with more cells there are nodes between them");
}

/// Numbers the nodes of the scene, and replaces the node numbers in the elements of parts by these numbers.
void JoinReader::number(Joiner& joiner) {
  LoadedScene& out = draft_.out;
  joiner.number(out.scene);
  for (std::size_t p = 0; p < draft_.geometries.size(); ++p) {
    PartGeometry& names = draft_.geometries[p].names;
    names.nodes = joiner.nodes(p);
    const auto& elements = draft_.geometries[p].elements;
    out.scene.parts[p].nodes.reserve(elements.size());
    for (const auto own : elements) out.scene.parts[p].nodes.push_back(names.nodes[own]);
    out.parts.push_back(names);
  }
}

}  // namespace netloft::scenes
