// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/part_names.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>
#include <charconv>

namespace netloft::scenes {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& n : names) text += (text.empty() ? "" : ", ") + n;
  return text;
}

std::vector<std::string> set_names(const PartGeometry& part) {
  std::vector<std::string> names;
  for (const auto& [name, set] : part.sets) names.push_back(name);
  return names;
}

}  // namespace

bool find_own_nodes(const PartGeometry& part, std::size_t count, const std::string& name,
                    std::vector<std::uint32_t>& own) {
  if (const auto set = part.sets.find(name); set != part.sets.end()) {
    own = set->second;
    return true;
  }
  if (!name.starts_with("node-")) return false;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + 5, name.data() + name.size(), number);
  if (error != std::errc() || end != name.data() + name.size() || number >= count) return false;
  own = {number};
  return true;
}

std::string name_hint(const std::string& name, const std::vector<std::string>& there) {
  if (const auto near = nearest(name, there)) return "did you mean \"" + *near + "\"?";
  return there.empty() ? "there are none" : "there is: " + joined(there);
}

std::string set_hint(const PartGeometry& part, std::size_t count, const std::string& name) {
  const std::string nodes = "node-0 to node-" + std::to_string(count - 1);
  if (name.starts_with("node")) return "there is: " + nodes;
  if (name == "middle" && part.sets.contains("start"))
    return "a rope has a node in its middle only if its number of cells is even";
  const auto there = set_names(part);
  if (const auto near = nearest(name, there)) return "did you mean \"" + part.name + "." + *near + "\"?";
  return "there is: " + joined(there) + ", " + nodes;
}

}  // namespace netloft::scenes
