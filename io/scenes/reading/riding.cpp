// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/riding.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes {

namespace {

/// The length of twine in a triangle, counting both twine directions: |d| bars of length `bar`, where d is
/// twice its area in twine coordinates.
double twine_length(const std::vector<double>& u, const std::vector<double>& v, double bar, std::size_t e) {
  const double d = (u[3 * e + 1] - u[3 * e]) * (v[3 * e + 2] - v[3 * e]) -
                   (u[3 * e + 2] - u[3 * e]) * (v[3 * e + 1] - v[3 * e]);
  return std::abs(d) * bar;
}

}  // namespace

std::vector<double> carried_length(const Scene& scene, const Part& part, const ElementType& type) {
  std::vector<double> carried(scene.node_count(), 0.0);
  const auto of = [&](const HostDatum& datum) { return find_data(part.data, datum); };
  const auto *rest = of(datum::kRestLength), *parallel = of(datum::kParallel), *u = of(datum::kU),
             *v = of(datum::kV), *bar = of(datum::kBarLength);
  const auto corners = static_cast<std::size_t>(type.nodes());
  for (std::size_t e = 0; e * corners < part.nodes.size(); ++e) {
    const double length = rest            ? (*rest)[e] * (parallel ? (*parallel)[e] : 1)
                          : u && v && bar ? twine_length(*u, *v, (*bar)[e], e)
                                          : 0;
    for (std::size_t c = 0; c < corners; ++c)
      carried[part.nodes[e * corners + c]] += length / static_cast<double>(corners);
  }
  return carried;
}

void ride_on_nodes(const std::vector<std::uint32_t>& nodes, const std::vector<double>& carried, double number,
                   Part& rider) {
  double total = 0;
  for (const auto node : nodes) total += carried[node];
  for (const auto node : nodes) {
    rider.nodes.push_back(node);
    rider.data[datum::kPieces.name].push_back(
        number * (total > 0 ? carried[node] / total : 1 / static_cast<double>(nodes.size())));
    rider.data[datum::kLength.name].push_back(carried[node]);
  }
}

void ride_on_every_node(const std::vector<std::uint32_t>& nodes, double pieces, Part& rider) {
  rider.nodes = nodes;
  rider.data[datum::kPieces.name].assign(nodes.size(), pieces);
  rider.data[datum::kLength.name].assign(nodes.size(), 0.0);
}

void ride_on_bars_at(const Part& rope, const std::vector<std::uint32_t>& nodes, Part& rider) {
  const auto is_there = [&](std::uint32_t node) {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  for (std::size_t b = 0; 2 * b < rope.nodes.size(); ++b) {
    const std::uint32_t first = rope.nodes[2 * b], second = rope.nodes[2 * b + 1];
    if (is_there(first) == is_there(second)) continue;
    rider.nodes.push_back(is_there(first) ? first : second);
    rider.nodes.push_back(is_there(first) ? second : first);
    for (const auto& [name, values] : rope.data) rider.data[name].push_back(values[b]);
  }
}

void ride_on_meeting_bars(const Part& first, const Part& second, Part& rider) {
  for (std::size_t a = 0; 2 * a < first.nodes.size(); ++a)
    for (std::size_t b = 0; 2 * b < second.nodes.size(); ++b)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t end = i / 2, begin = i % 2;  // end: the shared end of bar a, begin: that of bar b
        if (first.nodes[2 * a + end] != second.nodes[2 * b + begin]) continue;
        rider.nodes.insert(rider.nodes.end(), {first.nodes[2 * a + 1 - end], first.nodes[2 * a + end],
                                               second.nodes[2 * b + 1 - begin]});
        for (const auto& [name, values] : first.data)
          if (const auto others = second.data.find(name); others != second.data.end())
            rider.data[name].insert(rider.data[name].end(), {values[a], others->second[b]});
      }
}

void ride_on_elements(const Part& part, Part& rider) {
  rider.nodes.insert(rider.nodes.end(), part.nodes.begin(), part.nodes.end());
  for (const auto& [name, values] : part.data) {
    auto& own = rider.data[name];
    own.insert(own.end(), values.begin(), values.end());
  }
}

}  // namespace netloft::scenes
