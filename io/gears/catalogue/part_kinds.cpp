// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/part_kinds.hpp"

#include <algorithm>

namespace netloft::gears {

namespace {

constexpr bool kRequired = true;

/// The numbers of a line (a twine, a rope, a wire or a chain). `mass` is per metre.
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
      {"loss_factor", "1", "energy lost per radian of an oscillation, over the elastic energy", 0, 1},
  };
}

/// The numbers of a rope: those of a line, and optionally its weight per metre in water.
std::vector<PartKey> rope_numbers(const char* diameter) {
  auto numbers = line_numbers(diameter, 1, 1e12);
  numbers.push_back(
      {"weight_in_water", "N/m", "weight of a metre in sea water; negative: the rope floats", -1e6, 1e6});
  return numbers;
}

std::vector<PartKey> piece_numbers() {
  return {
      {"diameter", "m", "diameter across the flow", 0, 20},
      {"buoyancy", "N", "net upward force of one piece in sea water; negative: it sinks", -1e7, 1e7},
      {"mass", "kg", "mass of one in air", 0, 1e6},
      {"volume", "m3", "volume of the water that one piece displaces", 0, 1e3},
      {"material_density", "kg/m3", "density of its material", 1, 3e4},
      {"area", "m2", "area across the flow", 0, 1e3},
      {"drag_coefficient", "1", "drag coefficient on the area across the flow", 0, 10},
      {"added_mass", "1", "added mass over the mass of the water displaced", 0, 10},
      {"depth_limit", "m", "depth that it withstands", 0, 2e4},
  };
}

/// Adds one number of a rigid body for each of its axes: x aft, y outward, z up.
void add_axes(std::vector<PartKey>& numbers, const char* const (&names)[3], const char* unit, const char* doc,
              double most) {
  for (const char* name : names) numbers.push_back({name, unit, doc, -most, most});
}

std::vector<PartKey> board_numbers() {
  std::vector<PartKey> numbers = {
      {"mass", "kg", "mass of the board in air", 0, 1e6, kRequired},
      {"volume", "m3", "volume of the water that it displaces", 0, 1e3},
      {"area", "m2", "projected area", 1e-4, 1e3, kRequired},
      {"chord", "m", "length along the flow", 1e-2, 100, kRequired},
      {"span", "m", "height of a board, width of a kite", 1e-2, 100, kRequired},
      {"lift", "1", "factor on the force across the flow", 0, 5},
      {"drag", "1", "factor on the force along the flow", 0, 5},
      {"parasite", "1", "drag coefficient of brackets and edges, added to that of a flat plate", 0, 5},
  };
  add_axes(numbers, {"centre_x", "centre_y", "centre_z"}, "m", "centre of mass from the middle", 1e3);
  add_axes(numbers, {"float_x", "float_y", "float_z"}, "m", "centre of volume from the middle", 1e3);
  add_axes(numbers, {"inertia_x", "inertia_y", "inertia_z"}, "kg m2", "moment of inertia", 1e9);
  add_axes(numbers, {"added_x", "added_y", "added_z"}, "kg", "added mass", 1e9);
  add_axes(numbers, {"turning_x", "turning_y", "turning_z"}, "kg m2", "added inertia", 1e9);
  add_axes(numbers, {"inertia_turned_x", "inertia_turned_y", "inertia_turned_z"}, "rad", "axes of inertia",
           6.3);
  add_axes(numbers, {"added_turned_x", "added_turned_y", "added_turned_z"}, "rad", "axes of added mass", 6.3);
  add_axes(numbers, {"added_at_x", "added_at_y", "added_at_z"}, "m", "centre of the added mass", 1e3);
  return numbers;
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
      {"rope", "rope", "ropes of fibres", rope_numbers("diameter of the rope")},
      {"wire", "rope", "ropes of steel wire", rope_numbers("diameter of the rope")},
      {"chain", "rope", "chains", rope_numbers("diameter of the links' steel")},
      {"float", "float", "floats, which lift", piece_numbers()},
      {"weight", "float", "weights, which sink", piece_numbers()},
      {"ground", "float", "pieces of ground gear", piece_numbers()},
      {"board",
       "board",
       "otter boards, kites",
       board_numbers(),
       {},
       {"polar", "polar_slip", "pressure"},
       {"points", "outline", "turned"}},
      {"polar",
       "",
       "forces of boards over the direction of the flow",
       {},
       {},
       {"attack", "sideslip", "lift", "drag", "side", "chord", "span"}},
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

}  // namespace netloft::gears
