// SPDX-License-Identifier: BSD-3-Clause
#include "io/catalogue/part_kinds.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

constexpr bool kRequired = true;

/// Lines: spun, laid or linked; values per metre.
std::vector<PartKey> line_numbers(const char* diameter, double thickest, double strongest) {
  return {
      {"diameter", "m", diameter, 1e-5, thickest, kRequired},
      {"EA", "N", "axial stiffness", 0, strongest, kRequired},
      {"EA_compression", "N", "axial stiffness when slack", 0, strongest},
      {"mass", "kg/m", "mass of a metre in air, dry", 0, 1e4},
      {"material_density", "kg/m3", "density of its material", 1, 3e4},
      {"density", "kg/m3", "density of a cylinder of this diameter, with voids filled with sea water", 1,
       3e4},
      {"breaking_load", "N", "tension at which it breaks", 0, 1e9},
  };
}

std::vector<PartKey> piece_numbers() {
  return {
      {"diameter", "m", "diameter across the flow", 0, 20},
      {"buoyancy", "N", "net upward force of one in sea water; negative if it sinks", -1e7, 1e7},
      {"mass", "kg", "mass of one in air", 0, 1e6},
      {"volume", "m3", "volume of the water displaced by one", 0, 1e3},
      {"material_density", "kg/m3", "density of its material", 1, 3e4},
      {"area", "m2", "area across the flow", 0, 1e3},
      {"drag_coefficient", "1", "drag coefficient on the area across the flow", 0, 10},
      {"added_mass", "1", "added mass over the mass of the water displaced", 0, 10},
      {"depth_limit", "m", "depth that it withstands", 0, 2e4},
  };
}

}  // namespace

std::span<const PartKind> part_kinds() {
  static const std::vector<PartKind> kinds = {
      {"twine", "twine", "twines of netting", line_numbers("diameter of the twine", 0.1, 1e9)},
      {"netting",
       "",
       "sheets of meshes",
       {{"mesh", "m", "stretched mesh size, two bars", 1e-4, 100, kRequired}},
       {"twine"}},
      {"rope", "rope", "ropes of fibres", line_numbers("diameter of the rope", 1, 1e12)},
      {"wire", "rope", "ropes of steel wire", line_numbers("diameter of the rope", 1, 1e12)},
      {"chain", "rope", "chains", line_numbers("diameter of the links' steel", 1, 1e12)},
      {"float", "float", "what lifts", piece_numbers()},
      {"weight", "float", "what sinks", piece_numbers()},
      {"ground", "float", "pieces of ground gear", piece_numbers()},
  };
  return kinds;
}

const PartKind* find_kind(std::string_view name) {
  for (const auto& kind : part_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

std::vector<std::string> kinds_under(std::string_view key) {
  std::vector<std::string> names;
  for (const auto& kind : part_kinds())
    if (kind.key == key) names.emplace_back(kind.name);
  return names;
}

std::vector<std::string> part_keys() {
  std::vector<std::string> keys;
  for (const auto& kind : part_kinds())
    if (*kind.key && std::find(keys.begin(), keys.end(), kind.key) == keys.end()) keys.emplace_back(kind.key);
  return keys;
}

}  // namespace netloft::io
