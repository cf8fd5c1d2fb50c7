// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/riding.hpp"

#include <array>
#include <cmath>
#include <set>

namespace netloft::scenes {

namespace {

/// The length of twine in a triangle, for both twine directions together: |d| bars of length `bar`, where d
/// is twice the area of the triangle in twine coordinates.
double twine_length(const std::vector<double>& u, const std::vector<double>& v, double bar, std::size_t e) {
  const double d = (u[3 * e + 1] - u[3 * e]) * (v[3 * e + 2] - v[3 * e]) -
                   (u[3 * e + 2] - u[3 * e]) * (v[3 * e + 1] - v[3 * e]);
  return std::abs(d) * bar;
}

}  // namespace

CarriedLength::CarriedLength(const Part& part, const ElementType& type)
    : rest_(find_data(part.data, datum::kRestLength)),
      parallel_(find_data(part.data, datum::kParallel)),
      u_(find_data(part.data, datum::kU)),
      v_(find_data(part.data, datum::kV)),
      bar_(find_data(part.data, datum::kBarLength)),
      nodes_(type.nodes()) {}

double CarriedLength::at(std::span<const NodeElements::At> node) const {
  double carried = 0;
  for (const auto& [p, e] : node) {
    const double length = rest_              ? (*rest_)[e] * (parallel_ ? (*parallel_)[e] : 1)
                          : u_ && v_ && bar_ ? twine_length(*u_, *v_, (*bar_)[e], e)
                                             : 0;
    carried += length / static_cast<double>(nodes_);
  }
  return carried;
}

void ride_on_nodes(const std::vector<std::uint32_t>& nodes, const std::vector<double>& carried, double number,
                   Part& rider) {
  double total = 0;
  for (const double length : carried) total += length;
  auto &pieces = rider.data[datum::kPieces.name], &lengths = rider.data[datum::kLength.name];
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rider.nodes.push_back(nodes[i]);
    pieces.push_back(number * (total > 0 ? carried[i] / total : 1 / static_cast<double>(nodes.size())));
    lengths.push_back(carried[i]);
  }
}

void ride_on_every_node(const std::vector<std::uint32_t>& nodes, double pieces, Part& rider) {
  rider.nodes = nodes;
  rider.data[datum::kPieces.name].assign(nodes.size(), pieces);
  rider.data[datum::kLength.name].assign(nodes.size(), 0.0);
}

void ride_on_bars_at(const Scene& scene, std::size_t rope, const NodeElements& elements,
                     const std::vector<std::uint32_t>& nodes, Part& rider) {
  const std::set<std::uint32_t> ends(nodes.begin(), nodes.end());
  std::set<std::uint32_t> bars;
  for (const auto node : ends)
    for (const auto& [part, bar] : elements.at(node, rope)) bars.insert(bar);
  for (const std::size_t b : bars) {
    const std::uint32_t first = scene.parts[rope].nodes[2 * b], second = scene.parts[rope].nodes[2 * b + 1];
    if (ends.contains(first) == ends.contains(second)) continue;
    rider.nodes.push_back(ends.contains(first) ? first : second);
    rider.nodes.push_back(ends.contains(first) ? second : first);
    for (const auto& [name, values] : scene.parts[rope].data) rider.data[name].push_back(values[b]);
  }
}

void ride_on_meeting_bars(const Scene& scene, std::size_t first, std::size_t second,
                          const NodeElements& elements, Part& rider) {
  const Part &one = scene.parts[first], &other = scene.parts[second];
  for (std::size_t a = 0; 2 * a < one.nodes.size(); ++a) {
    // For each meeting of two bars: bar b, and the ends of a and b at the shared node.
    std::set<std::array<std::size_t, 3>> meetings;
    for (const std::size_t end : {0u, 1u})
      for (const auto& [part, b] : elements.at(one.nodes[2 * a + end], second))
        for (const std::size_t begin : {0u, 1u})
          if (other.nodes[2 * b + begin] == one.nodes[2 * a + end]) meetings.insert({b, end, begin});
    for (const auto& [b, end, begin] : meetings) {
      rider.nodes.insert(rider.nodes.end(), {one.nodes[2 * a + 1 - end], one.nodes[2 * a + end],
                                             other.nodes[2 * b + 1 - begin]});
      for (const auto& [name, values] : one.data)
        if (const auto others = other.data.find(name); others != other.data.end())
          rider.data[name].insert(rider.data[name].end(), {values[a], others->second[b]});
    }
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
