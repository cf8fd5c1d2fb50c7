// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/draft.hpp"

#include "io/scenes/reading/part_names.hpp"

#include <algorithm>
#include <numeric>

namespace netloft::scenes {

void drop_repeats(std::vector<std::uint32_t>& nodes) {
  if (nodes.empty()) return;
  std::vector<bool> seen(std::size_t{*std::ranges::max_element(nodes)} + 1);
  std::erase_if(nodes, [&](std::uint32_t node) {
    const bool again = seen[node];
    seen[node] = true;
    return again;
  });
}

Mention mention(const std::string& name, const formats::TableReader& table, std::string_view key) {
  return {name, table.place(key), table.path(key)};
}

Mention mention_of_item(const std::string& name, formats::TableReader& table, std::string_view key,
                        std::size_t i) {
  Mention m = mention(name, table, key);
  const formats::Array* array = table.raw(key) ? table.raw(key)->as<formats::Array>() : nullptr;
  if (!array || i >= array->items.size()) return m;
  m.place = array->items[i].place;
  m.path += "[" + std::to_string(i) + "]";
  return m;
}

void Draft::add_part(Part part, Geometry geometry, const ElementType* type, bool sound) {
  part.data = std::move(geometry.data);
  types.push_back(type);
  is_sound.push_back(sound);
  out.scene.parts.push_back(std::move(part));
  geometries.push_back(std::move(geometry));
}

void Draft::add_rider(Part part, formats::Place place, const ElementType* type, bool sound) {
  Geometry none;
  none.names.name = part.name;
  none.names.place = place;
  types.push_back(type);
  is_sound.push_back(sound);
  out.parts.push_back(none.names);
  out.scene.parts.push_back(std::move(part));
  geometries.push_back(std::move(none));
}

std::optional<Joiner::Ends> Draft::find_set(const Mention& m) {
  if (const auto point = points.find(m.name); point != points.end()) return point->second;
  const auto dot = m.name.find('.');
  const auto p = find_part(m, m.name.substr(0, dot));
  if (!p) return {};
  const Geometry& geometry = geometries[*p];
  Joiner::Ends ends{*p, {}};
  if (dot == std::string::npos) {
    ends.own.resize(geometry.node_count());
    std::iota(ends.own.begin(), ends.own.end(), 0u);
    return ends;
  }
  const std::string name = m.name.substr(dot + 1);
  if (riders_.contains(geometry.names.name)) {
    refuse_rider(m, geometry.names.name);
    return {};
  }
  if (find_own_nodes(geometry.names, geometry.node_count(), name, ends.own)) return ends;
  const bool hangs_on_geometry = geometry.node_count() == 0 || name.starts_with("node-") || name == "middle";
  // An error in the geometry of the part, which has been reported, may be the reason why the name is missing.
  if (is_sound[*p] || !hangs_on_geometry)
    diagnostics_.error(
        m.place,
        m.path + ": " + formats::in_quotes(geometry.names.name) + " has no " + formats::in_quotes(name),
        set_hint(geometry.names, geometry.node_count(), name));
  return {};
}

/// The names of edges and points of a part. These names move from `geometries` to `out.parts` when nodes are
/// numbered.
PartGeometry& Draft::names_of(std::size_t part) {
  return part < out.parts.size() ? out.parts[part] : geometries[part].names;
}

std::optional<Joiner::Ends> Draft::find_nodes(const Mention& m) {
  auto set = find_set(m);
  if (set && m.name.find(".node-") != std::string::npos) names_of(set->part).is_numbered = true;
  if (!set || !set->own.empty() || !is_sound[set->part]) return set;
  refuse_rider(m, m.name);
  return {};
}

std::vector<std::uint32_t> Draft::scene_nodes(const Joiner::Ends& ends) const {
  std::vector<std::uint32_t> nodes;
  for (const auto own : ends.own) nodes.push_back(out.parts[ends.part].nodes[own]);
  return nodes;
}

const NodeElements& Draft::node_elements() const {
  if (!node_elements_) node_elements_.emplace(out.scene, types);
  return *node_elements_;
}

void Draft::refuse_rider(const Mention& m, const std::string& name) {
  diagnostics_.error(
      m.place,
      m.path + ": " + formats::in_quotes(name) + " uses nodes of other parts and has none of its own",
      "name the parts in its `on` instead");
}

std::optional<std::size_t> Draft::part_number(const std::string& name) const {
  return numbers_.find(name, geometries, [](const Geometry& geometry) { return geometry.names.name; });
}

std::vector<Mention> Draft::expand(const Mention& m) {
  if (!m.name.starts_with("*.")) return {m};
  const std::string set = m.name.substr(2);
  std::vector<Mention> all;
  std::vector<std::string> there;
  for (const auto& geometry : geometries) {
    if (geometry.names.sets.contains(set)) all.push_back({geometry.names.name + "." + set, m.place, m.path});
    for (const auto& [name, nodes] : geometry.names.sets) there.push_back(name);
  }
  const bool all_sound = std::find(is_sound.begin(), is_sound.end(), false) == is_sound.end();
  if (all.empty() && all_sound)
    diagnostics_.error(m.place, m.path + ": no part has " + formats::in_quotes(set), name_hint(set, there));
  return all;
}

bool Draft::has(const std::string& name) const {
  return points.contains(name) || part_number(name.substr(0, name.find('.')));
}

std::vector<Mention> Draft::both_sides(const Mention& m) const {
  const Mention starboard{"starboard-" + m.name, m.place, m.path}, port{"port-" + m.name, m.place, m.path};
  if (has(m.name) || !has(starboard.name) || !has(port.name)) return {m};
  return {starboard, port};
}

std::optional<std::size_t> Draft::find_part(const Mention& m, const std::string& name) {
  if (const auto p = part_number(name)) return p;
  if (riders_.contains(name))
    refuse_rider(m, name);
  else if (m.name.empty())
    diagnostics_.error(m.place, m.path + " is empty; a part, an edge or a point is expected (net.fore)");
  else
    diagnostics_.error(m.place, m.path + ": there is no part " + formats::in_quotes(name),
                       diagnostics_.wants_hints() ? part_hint(name) : "");
  return {};
}

/// A hint for the name of a part that does not exist: a part with a similar name, or a part that has an edge
/// of this name.
std::string Draft::part_hint(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& geometry : geometries) {
    if (geometry.names.sets.contains(name))
      return "did you mean \"" + geometry.names.name + "." + name + "\"?";
    names.push_back(geometry.names.name);
  }
  for (const auto& [point, ends] : points) names.push_back(point);
  return name_hint(name, names);
}

}  // namespace netloft::scenes
