// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/part_names.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>
#include <charconv>

namespace netloft::scenes {

namespace {

constexpr std::size_t kLongestName = 100;

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

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

std::string name_fault(const std::string& name) {
  if (name.empty()) return "must not be empty";
  if (name.size() > kLongestName) return "is longer than " + std::to_string(kLongestName) + " bytes";
  if (name.find('/') != std::string::npos) return "must not hold a slash, which leads into a result file";
  if (name.find_first_not_of('.') == std::string::npos) return "must not be made of dots only";
  if (std::any_of(name.begin(), name.end(), is_control)) return "must not hold control characters";
  return {};
}

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
