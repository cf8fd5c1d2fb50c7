// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/scene_draft.hpp"

#include <algorithm>
#include <set>

namespace netloft::scenes::femnet {

namespace {

/// Converts a text such as "Warp tension (N)" to a name such as "warp-tension-n".
std::string word_of(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool is_capital = c >= 'A' && c <= 'Z', is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (is_capital || is_plain)
      out += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!out.empty() && out.back() != '-')
      out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out.substr(0, 60);
}

/// A name for a node of the mesh, formed with the first part that has the node: "cable-3.node-5"; empty if no
/// part has it.
std::string node_name(const SceneDraft& from, int number) {
  for (const auto& region : from.out.mesh.regions) {
    const std::set<std::uint32_t> own(region.nodes.begin(), region.nodes.end());
    const auto at = own.find(static_cast<std::uint32_t>(number - 1));
    if (number > 0 && at != own.end())
      return region.name + ".node-" + std::to_string(std::distance(own.begin(), at));
  }
  return {};
}

bool is_held(const SceneDraft& from, int node, int axis) {
  if (node < 1 || static_cast<std::size_t>(node) > from.file.nodes.size() || axis < 1 || axis > 3)
    return false;
  const auto type = static_cast<std::size_t>(from.file.nodes[static_cast<std::size_t>(node) - 1].type);
  const auto a = static_cast<std::size_t>(axis) - 1;
  return from.gear.types[type].fixed[a] != 0 || from.gear.types[type].symmetry[a] != 0;
}

/// The name of the part with the bars of a cable that no drum hauls. If there is no such part, the name of
/// the first hauled bar of the cable; empty if the mesh has neither.
std::string part_of_cable(const SceneDraft& from, std::size_t cable) {
  for (const auto& region : from.out.mesh.regions)
    if (region.name == cable_name(cable) || region.name.starts_with(cable_name(cable) + "-bar-"))
      return region.name;
  return {};
}

std::string result_of(const SceneDraft& from, const Wanted& w) {
  const auto entry = [](const std::string& of, const std::string& take) {
    return "{ of = " + quoted(of) + ", take = " + quoted(take) + " }";
  };
  const std::string node = node_name(from, w.first);
  const bool has_axis = w.second >= 1 && w.second <= 3;
  const std::string axis = has_axis ? kAxis[static_cast<std::size_t>(w.second) - 1] : "";
  if (w.kind == Wanted::Kind::position && !node.empty() && has_axis) return entry(node, axis);
  if (w.kind == Wanted::Kind::force && !node.empty() && is_held(from, w.first, w.second))
    return entry(node, "reaction " + axis);
  const std::string cable = w.first > 0 ? part_of_cable(from, static_cast<std::size_t>(w.first) - 1) : "";
  return w.kind == Wanted::Kind::tension && !cable.empty() ? entry(cable, "max tension") : std::string();
}

}  // namespace

void write_results(SceneDraft& to) {
  std::string lines;
  std::set<std::string> used;
  for (const auto& w : to.gear.wanted) {
    const std::string entry = result_of(to, w);
    std::string name = word_of(w.text);
    if (entry.empty()) continue;
    if (name.empty()) name = "result";
    for (int i = 2; !used.insert(name).second; ++i) name = word_of(w.text) + "-" + std::to_string(i);
    lines += name + " = " + entry + "\n";
  }
  if (!lines.empty()) to.body.add("\n[results]\n" + lines);
}

}  // namespace netloft::scenes::femnet
