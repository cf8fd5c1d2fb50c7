// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/pairs.hpp"

#include <algorithm>
#include <map>

namespace netloft {

namespace {

/// Two neighbouring elements. For each node of the pair, `corners` has an element to which the node belongs,
/// and the number of the node (the corner) in that element.
struct Pair {
  std::size_t first, second;
  std::vector<std::pair<std::size_t, std::size_t>> corners;  // (element, corner)
};

std::vector<Pair> pair_bars(const std::vector<std::uint32_t>& nodes) {
  std::vector<Pair> pairs;
  for (std::size_t e = 0; 2 * e + 3 < nodes.size(); ++e)
    if (nodes[2 * e + 1] == nodes[2 * e + 2]) pairs.push_back({e, e + 1, {{e, 0}, {e, 1}, {e + 1, 1}}});
  return pairs;
}

std::vector<Pair> pair_triangles(const std::vector<std::uint32_t>& nodes) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>>
      edges;  // edge -> (element, opposite corner)
  std::vector<Pair> pairs;
  for (std::size_t e = 0; 3 * e < nodes.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = nodes[3 * e + (k + 1) % 3], b = nodes[3 * e + (k + 2) % 3];
      const auto [at, is_new] = edges.try_emplace(std::minmax(a, b), e, k);
      if (is_new) continue;
      const auto [first, opposite] = at->second;
      pairs.push_back(
          {first, e, {{first, (opposite + 1) % 3}, {first, (opposite + 2) % 3}, {first, opposite}, {e, k}}});
    }
  return pairs;
}

std::vector<double> pair_data(const std::vector<Pair>& pairs, const std::vector<double>& data,
                              std::size_t width, std::size_t corners) {
  std::vector<double> out;
  for (const auto& pair : pairs) {
    if (width == corners && corners > 1)
      for (const auto& [element, corner] : pair.corners) out.push_back(data[element * width + corner]);
    else
      for (const std::size_t element : {pair.first, pair.second})
        for (std::size_t k = 0; k < width; ++k) out.push_back(data[element * width + k]);
  }
  return out;
}

}  // namespace

bool may_act(const ElementType& type, const Values& parameters) {
  const auto is_zero = [&](const std::string& name) {
    if (const auto at = parameters.find(name); at != parameters.end()) {
      const double* value = std::get_if<double>(&at->second);
      return value && *value == 0;
    }
    return std::any_of(type.parameters.begin(), type.parameters.end(),
                       [&](const netloft_parameter& p) { return name == p.name && p.fallback == 0; });
  };
  return std::any_of(type.terms.begin(), type.terms.end(),
                     [&](const netloft_term& t) { return !t.needs || !is_zero(t.needs); });
}

Part make_companion(const Part& part, const ElementType& ridden, const ElementType& rider) {
  Part out;
  out.name = part.name;
  out.type = rider.type;
  out.companion = true;
  for (const auto& p : rider.parameters)
    if (const auto at = part.parameters.find(p.name); at != part.parameters.end()) out.parameters.insert(*at);
  const auto corners = static_cast<std::size_t>(ridden.nodes());
  std::vector<Pair> pairs;
  if (may_act(rider, out.parameters))
    pairs = ridden.element.stencil == NETLOFT_BAR ? pair_bars(part.nodes) : pair_triangles(part.nodes);
  for (const auto& pair : pairs)
    for (const auto& [element, corner] : pair.corners)
      out.nodes.push_back(part.nodes[element * corners + corner]);
  for (const auto& datum : ridden.data)
    for (const auto& wanted : rider.data)
      if (std::string_view(datum.name) == wanted.name)
        out.data[datum.name] = pair_data(pairs, part.data.at(datum.name), datum.width, corners);
  return out;
}

}  // namespace netloft
