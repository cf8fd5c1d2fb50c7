// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/panels_in_row.hpp"

#include "framework/registry/element_data.hpp"

#include <algorithm>
#include <map>

namespace netloft::scenes {

namespace {

constexpr double kOnEdge = 1e-6;  // distance within which a node lies on the aft edge [meshes]

class PanelsInRow {
 public:
  PanelsInRow(const std::vector<PanelBelow>& panels, const std::vector<std::uint32_t>& nodes,
              const std::vector<double>& to_aft)
      : panels_(panels.size()) {
    for (std::size_t p = 0; p < panels.size(); ++p)
      for (std::size_t i = panels[p].begin; i < (p + 1 < panels.size() ? panels[p + 1].begin : nodes.size());
           ++i) {
        seams_[nodes[i]][p] = to_aft[i];
        if (to_aft[i] < kOnEdge) panels_[p].aft_edge.push_back(nodes[i]);
      }
    for (auto& panel : panels_) {
      std::ranges::sort(panel.aft_edge);
      panel.aft_edge.erase(std::unique(panel.aft_edge.begin(), panel.aft_edge.end()), panel.aft_edge.end());
    }
  }

  /// The number of meshes behind the aft edge of a panel, averaged over the nodes of the edge. The panels
  /// behind this one are computed first. A list of waiting panels replaces recursion, because a row of panels
  /// may be very long.
  double behind(std::size_t panel) {
    std::vector<std::size_t> to_count{panel};
    while (!to_count.empty()) {
      const std::size_t now = to_count.back();
      const std::size_t waiting = to_count.size();
      if (panels_[now].state == State::uncounted) {
        panels_[now].state = State::waits;  // a panel in a ring waits for itself: no meshes are behind it
        for (const auto node : panels_[now].aft_edge) add_those_behind(node, now, to_count);
      }
      if (to_count.size() > waiting) continue;
      to_count.pop_back();
      if (panels_[now].state == State::waits) count(now);
    }
    return panels_[panel].behind;
  }

 private:
  enum class State { uncounted, waits, counted };
  struct Panel {
    std::vector<std::uint32_t> aft_edge;  // nodes of the aft edge
    double behind = 0;
    State state = State::uncounted;
  };

  void add_those_behind(std::uint32_t node, std::size_t panel, std::vector<std::size_t>& to_count) const {
    for (const auto& [other, meshes] : seams_.at(node))
      if (other != panel && meshes >= kOnEdge && panels_[other].state == State::uncounted)
        to_count.push_back(other);
  }

  void count(std::size_t panel) {
    Panel& p = panels_[panel];
    double sum = 0, nodes = 0;
    for (const auto node : p.aft_edge)
      if (const double most = most_behind(node, panel); most > 0) sum += most, ++nodes;
    p.behind = nodes > 0 ? sum / nodes : 0;
    p.state = State::counted;
  }

  /// The largest number of meshes behind a node, over all panels except `panel` that continue from this node.
  double most_behind(std::uint32_t node, std::size_t panel) const {
    double most = 0;
    for (const auto& [other, meshes] : seams_.at(node))
      if (other != panel && meshes >= kOnEdge) most = std::max(most, meshes + panels_[other].behind);
    return most;
  }

  std::vector<Panel> panels_;
  // For each node and each panel that has it: the number of meshes from the node to the aft edge of the
  // panel.
  std::map<std::uint32_t, std::map<std::size_t, double>> seams_;
};

}  // namespace

void count_meshes_through_seams(const std::vector<PanelBelow>& panels, Part& rider) {
  const auto data = rider.data.find(datum::kToAft.name);
  if (data == rider.data.end()) return;
  auto& to_aft = data->second;
  PanelsInRow row(panels, rider.nodes, to_aft);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double behind = row.behind(p);
    for (std::size_t i = panels[p].begin; i < (p + 1 < panels.size() ? panels[p + 1].begin : to_aft.size());
         ++i)
      to_aft[i] += behind;
  }
}

}  // namespace netloft::scenes
