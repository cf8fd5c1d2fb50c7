// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/mesh_builder.hpp"

#include "io/formats/mesh/text_rows.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::formats {

namespace {

bool may_stand_in_a_name(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
}

std::string as_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !may_stand_in_a_name(c); }, '-');
  return name.empty() ? "mesh" : name;
}

}  // namespace

double MeshBuilder::real(std::string_view word, const Place& place) {
  const auto value = number_in(word);
  if (value && std::abs(*value) <= kFarthest) return *value;
  error(place, in_quotes(word) + (value ? " is beyond a million" : " is no number"));
  return 0;
}

void MeshBuilder::add_coordinate(double x, const Place& place) {
  if (mesh_.positions.size() >= 3 * kMostNodes)
    return error(place, "there are more than " + std::to_string(kMostNodes) + " nodes");
  mesh_.positions.push_back(x);
}

MeshRegion& MeshBuilder::region(const std::string& name, RegionKind kind) {
  const auto [known, is_new] = known_.try_emplace({as_name(name), kind}, mesh_.regions.size());
  if (is_new) {
    std::string own = as_name(name);
    while (mesh_.find(own)) own += "-" + std::string(name_of(kind));
    mesh_.regions.push_back({kind, own});
    places_.emplace_back();
  }
  return mesh_.regions[known->second];
}

MeshSet& MeshBuilder::set(const std::string& name) {
  const auto known = std::find_if(mesh_.sets.begin(), mesh_.sets.end(),
                                  [&](const auto& s) { return s.name == as_name(name); });
  if (known != mesh_.sets.end()) return *known;
  mesh_.sets.push_back({as_name(name)});
  return mesh_.sets.back();
}

void MeshBuilder::add_element(MeshRegion& region, const std::uint32_t* nodes, const double* numbers,
                              const Place& place) {
  if (++elements_ > kMostElements)
    return error(place, "there are more than " + std::to_string(kMostElements) + " elements");
  region.nodes.insert(region.nodes.end(), nodes, nodes + nodes_in(region.kind));
  if (numbers) region.numbers.insert(region.numbers.end(), numbers, numbers + numbers_in(region.kind));
  places_[static_cast<std::size_t>(&region - mesh_.regions.data())].push_back(place);
}

InputMesh MeshBuilder::finish(const Place& end) {
  if (mesh_.positions.empty() && errors() == 0) error(end, "the mesh has no nodes");
  std::erase_if(mesh_.sets, [](const auto& s) { return s.nodes.empty(); });
  if (errors() > 0) return std::move(mesh_);
  for (std::size_t r = 0; r < mesh_.regions.size(); ++r) {
    MeshRegion& region = mesh_.regions[r];
    if (region.numbers.size() != region.size() * numbers_in(region.kind)) share_out(region);
    for (std::size_t e = 0; e < region.size() && goes_on(); ++e)
      if (const auto fault = fault_of(region, e)) error(places_[r][e], fault->message);
  }
  return std::move(mesh_);
}

/// Computes the fractions of a rope at the ends of its bars from the distances between its nodes.
void MeshBuilder::share_out(MeshRegion& region) const {
  std::vector<double> ends{0};
  for (std::size_t e = 0; e < region.size(); ++e) {
    const double *a = &mesh_.positions[3 * std::size_t{region.nodes[2 * e]}],
                 *b = &mesh_.positions[3 * std::size_t{region.nodes[2 * e + 1]}];
    ends.push_back(ends.back() + std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  region.numbers.clear();
  for (std::size_t e = 0; e < region.size(); ++e) {
    region.numbers.push_back(ends[e] / ends.back());
    region.numbers.push_back(e + 1 == region.size() ? 1 : ends[e + 1] / ends.back());
  }
}

}  // namespace netloft::formats
