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

  /// The number of meshes behind the aft edge of a panel, averaged over the nodes of the edge.
  double behind(std::size_t panel) {
    Panel& p = panels_[panel];
    if (p.is_counted) return p.behind;
    p.is_counted = true;  // set before the recursion, which would not end if panels are sewn in a ring
    double sum = 0, count = 0;
    for (const auto node : p.aft_edge)
      if (const double most = most_behind(node, panel); most > 0) sum += most, ++count;
    return p.behind = count > 0 ? sum / count : 0;
  }

 private:
  struct Panel {
    std::vector<std::uint32_t> aft_edge;  // nodes of the aft edge
    double behind = 0;
    bool is_counted = false;
  };

  /// The largest number of meshes behind a node, in the panels other than `panel` that continue there.
  double most_behind(std::uint32_t node, std::size_t panel) {
    double most = 0;
    for (const auto& [other, meshes] : seams_[node])
      if (other != panel && meshes >= kOnEdge) most = std::max(most, meshes + behind(other));
    return most;
  }

  std::vector<Panel> panels_;
  // Node -> panel -> meshes from the node to the panel's aft edge.
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
