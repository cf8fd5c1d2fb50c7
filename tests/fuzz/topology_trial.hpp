// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/meshing/start_shape.hpp"
#include "io/gears/plan/check.hpp"
#include "tests/fuzz/topology.hpp"
#include "tests/support/mesh_faults.hpp"

#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace netloft::fuzz {

/// The result for one plan: it was meshed, or refused with messages. `faults` should be empty.
struct TopologyTrial {
  std::vector<std::string> refusals, faults;
  bool is_meshed() const { return refusals.empty(); }
};

namespace topology {

using namespace gears;

constexpr std::size_t kMostNodesOfATopology = 20000;  // dozens of times the requested number of nodes

/// Faults of the nodes of seams: both rows of a seam should have the same nodes.
inline std::vector<std::string> row_faults(const Gear& gear, const GearMesh& mesh) {
  std::vector<std::string> faults;
  for (const Seam& seam : gear.seams) {
    std::array<std::set<std::uint32_t>, 2> nodes;
    for (const std::size_t r : {0u, 1u})
      for (const EdgeRef& ref : seam.edges[r])
        for (const auto own :
             mesh.panels[ref.panel].sets.at(gear.panels[ref.panel].outline.edges[ref.edge].name))
          nodes[r].insert(mesh.panels[ref.panel].nodes[own]);
    if (nodes[0] != nodes[1])
      faults.push_back("the rows of the seam of " + gear.name_of(seam.edges[0][0]) + " and " +
                       gear.name_of(seam.edges[1][0]) + " have different nodes");
  }
  return faults;
}

/// Faults of the numbering: each node belongs to a panel or a rope, or is a point, and no other node is used.
inline std::vector<std::string> node_faults(const GearMesh& mesh) {
  std::vector<bool> is_used(mesh.nodes);
  std::vector<std::string> faults;
  const auto use = [&](std::uint32_t node) {
    if (node >= mesh.nodes)
      faults.push_back("there is no node " + std::to_string(node));
    else
      is_used[node] = true;
  };
  for (const auto& panel : mesh.panels)
    for (const auto node : panel.nodes) use(node);
  for (const auto& rope : mesh.ropes)
    for (const auto node : rope.nodes) use(node);
  for (const auto& [name, node] : mesh.points) use(node);
  if (mesh.nodes > kMostNodesOfATopology)
    faults.push_back("there are " + std::to_string(mesh.nodes) + " nodes");
  const auto unused = std::count(is_used.begin(), is_used.end(), false);
  if (unused) faults.push_back(std::to_string(unused) + " nodes belong to nothing");
  return faults;
}

inline std::vector<std::string> rope_faults(const Gear& gear, const GearMesh& mesh) {
  std::vector<std::string> faults;
  for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
    const auto& lengths = mesh.ropes[r].rest_lengths;
    const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    if (!(std::abs(sum - gear.ropes[r].length) <= 1e-9 * gear.ropes[r].length))
      faults.push_back("rope " + gear.ropes[r].name + " has bars of " + std::to_string(sum) + " m together");
    if (!std::all_of(lengths.begin(), lengths.end(), [](double l) { return l > 0; }))
      faults.push_back("rope " + gear.ropes[r].name + " has a bar without length");
    for (std::size_t k = 1; k < mesh.ropes[r].nodes.size(); ++k)
      if (mesh.ropes[r].nodes[k] == mesh.ropes[r].nodes[k - 1])
        faults.push_back("rope " + gear.ropes[r].name + " has a bar from a node to itself");
  }
  return faults;
}

inline std::vector<std::string> shape_faults(const Gear& gear, const GearMesh& mesh) {
  const auto shape = StartShapes(gear, mesh).with(gear);
  const bool is_finite = std::all_of(shape.begin(), shape.end(), [](double x) { return std::isfinite(x); });
  return is_finite && shape.size() == 3 * mesh.nodes
             ? std::vector<std::string>{}
             : std::vector<std::string>{"the start shape is not finite"};
}

inline void append(TopologyTrial& trial, const char* extent, const std::vector<std::string>& faults) {
  for (const auto& fault : faults) trial.faults.push_back(extent + (": " + fault));
}

/// Meshes a gear and checks the mesh; returns the area of its netting, in square meshes.
inline double try_extent(const NetPlan& plan, Extent extent, const Fineness& fineness, TopologyTrial& trial) {
  const char* word = extent == Extent::whole ? "whole" : "half";
  const Gear gear = make_gear(plan, extent);
  const GearMesh mesh = divide(gear, fineness);
  append(trial, word, area_faults(gear, mesh));
  append(trial, word, seam_faults(gear, mesh));
  append(trial, word, row_faults(gear, mesh));
  append(trial, word, node_faults(mesh));
  append(trial, word, rope_faults(gear, mesh));
  append(trial, word, shape_faults(gear, mesh));
  double area = 0;
  for (const auto& panel : gear.panels)
    if (panel.panel->stands != Standing::alone) area += outline_area(panel.outline);
  return area;
}

}  // namespace topology

/// Reads, checks and meshes a plan, as a whole gear and as half of one.
inline TopologyTrial try_topology(const std::string& text, const gears::Fineness& fineness) {
  TopologyTrial trial;
  formats::Diagnostics diagnostics;
  gears::NetPlan plan = gears::read_plan_text(text, "plan.toml", {}, diagnostics);
  if (diagnostics.errors() == 0) gears::check_plan(plan, diagnostics);
  if (diagnostics.errors() == 0) gears::check_seams(plan, diagnostics);
  for (const auto& said : diagnostics.sorted()) {
    if (said.place.line < 1) trial.faults.push_back("a message without a place: " + said.message);
    if (said.severity == formats::Severity::error) trial.refusals.push_back(said.message);
  }
  if (!trial.refusals.empty()) return trial;
  try {
    const double whole = topology::try_extent(plan, gears::Extent::whole, fineness, trial),
                 half = topology::try_extent(plan, gears::Extent::half, fineness, trial);
    if (!(std::abs(whole - 2 * half) <= 1e-9 * whole))
      trial.faults.push_back("two halves are not a whole gear");
  } catch (const gears::CannotDivide& refused) {
    trial.refusals.push_back(std::string("while dividing: ") + refused.what());
  } catch (const std::invalid_argument& refused) {
    trial.faults.push_back(std::string("refused without a place: ") + refused.what());
    trial.refusals.push_back(refused.what());
  } catch (const std::exception& e) {
    trial.faults.push_back(std::string("an internal error: ") + e.what());
  }
  return trial;
}

inline gears::Fineness draw_fineness(Choices& choices) {
  gears::Fineness fineness;
  fineness.knots = choices.in(0, 9) == 9;
  fineness.nodes = choices.in<std::size_t>(20, 400);
  return fineness;
}

}  // namespace netloft::fuzz
