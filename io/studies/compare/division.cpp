// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/division.hpp"

#include "io/formats/toml/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace netloft::studies {

namespace {

constexpr std::int64_t kMostCells = 100000;  // limit along one direction, as for scenes
constexpr std::int64_t kFewestWorthwhile = 2;

// Least number of nodes of a coarser gear. In a test with 10 gears, 8 % of all errors exceeded the error bars
// from meshes of 150, 300 and 600 nodes, and 3 % exceeded those from 300, 600 and 1200 nodes.
constexpr std::int64_t kFewestNodes = 300;

/// A factor by which numbers of cells are multiplied: up/down.
struct Factor {
  std::int64_t up = 1, down = 1;
  bool divides(std::int64_t cells) const { return cells * up % down == 0 && cells * up / down >= 1; }
  std::int64_t of(std::int64_t cells) const { return cells * up / down; }
};

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

std::int64_t read_count(const std::string& word, const std::string& all) {
  std::int64_t count = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (fault != std::errc{} || end != word.data() + word.size() || count < 1 || count > kMostCells)
    refuse(fmt::format(
        "--cells {}: \"{}\" is not a number of cells; write whole numbers from 1 to {}, such as 8,16,32", all,
        word, kMostCells));
  return count;
}

const scenes::PartGeometry& part_named(const scenes::LoadedScene& loaded, const std::string& name) {
  for (const auto& part : loaded.parts)
    if (part.name == name && !part.cells.empty()) return part;
  std::string divided;
  for (const auto& part : loaded.parts)
    if (!part.cells.empty()) divided += (divided.empty() ? "" : ", ") + part.name;
  refuse("--cells: there is no part \"" + name + "\" that is divided into cells; divided are " + divided);
}

formats::Change divide(const scenes::PartGeometry& part, Factor factor) {
  formats::Array all;
  for (const int cells : part.cells) all.items.push_back({{}, factor.of(cells)});
  return formats::make_change({"parts", part.name, "cells"},
                              part.cells.size() > 1 ? formats::Value{{}, all} : all.items.at(0));
}

bool divides(const scenes::PartGeometry& part, Factor factor) {
  return std::all_of(part.cells.begin(), part.cells.end(), [&](int cells) { return factor.divides(cells); });
}

/// The parts that are divided into cells: all parts, or the part named `only`.
std::vector<const scenes::PartGeometry*> divided_parts(const scenes::LoadedScene& loaded,
                                                       const std::string& only) {
  std::vector<const scenes::PartGeometry*> parts;
  for (const auto& part : loaded.parts)
    if (!part.cells.empty() && (only.empty() || part.name == only)) parts.push_back(&part);
  return parts;
}

bool all_divide(const std::vector<const scenes::PartGeometry*>& parts, Factor factor) {
  return std::all_of(parts.begin(), parts.end(), [&](auto* part) { return divides(*part, factor); });
}

MeshLevel level(const std::vector<const scenes::PartGeometry*>& parts, std::int64_t cells, Factor factor) {
  MeshLevel made{cells, {}};
  for (const auto* part : parts) {
    if (!divides(*part, factor))
      refuse(fmt::format(
          "--cells {}: \"{}\" has {} cells and would have {} of that, which is not a whole number of cells",
          cells, part->name, fmt::join(part->cells, " x "), fmt::format("{}/{}", factor.up, factor.down)));
    made.changes.push_back(divide(*part, factor));
  }
  return made;
}

using Names = std::set<std::string>;

Names names_of(const std::vector<const scenes::PartGeometry*>& parts) {
  Names names;
  for (const auto* part : parts) names.insert(part->name);
  return names;
}

/// The indices of a gear's panels and ropes.
std::vector<std::uint32_t> parts_of(const scenes::GearInScene& gear) {
  std::vector<std::uint32_t> parts = gear.panels;
  parts.insert(parts.end(), gear.ropes.begin(), gear.ropes.end());
  return parts;
}

/// Whether `text` names a node of one of `parts` by its number ("net.node-17"). On another mesh, another node
/// has this number.
bool names_a_divided_node(const std::string& text, const Names& parts) {
  const auto dot = text.find(".node-");
  return dot != std::string::npos && parts.contains(text.substr(0, dot));
}

/// Calls visit(text, place) for every text in a TOML value, including texts in its arrays and tables.
template <class Visit>
void for_texts(const formats::Value& value, const Visit& visit) {
  if (const auto* text = value.as<std::string>()) visit(*text, value.place);
  if (const auto* array = value.as<formats::Array>())
    for (const auto& item : array->items) for_texts(item, visit);
  if (const auto* table = value.as<formats::Table>())
    for (const auto& member : table->members) for_texts(member.value, visit);
}

void refuse_numbered_nodes(const scenes::LoadedScene& loaded, const Names& parts) {
  formats::Diagnostics diagnostics;
  const formats::Document document = formats::Document::load(loaded.files.at(0).path, {}, diagnostics);
  for_texts(document.root(), [&](const std::string& text, const formats::Place& place) {
    if (names_a_divided_node(text, parts))
      refuse(diagnostics.where(place) + ": \"" + text +
             "\" is a different node on another mesh; name an edge, a corner or a middle to compare meshes");
  });
}

}  // namespace

CellList read_cell_list(const std::string& text) {
  CellList list;
  const auto equals = text.find('=');
  if (equals != std::string::npos) list.part = text.substr(0, equals);
  if (list.part.starts_with("parts.")) list.part.erase(0, 6);
  std::istringstream counts((equals == std::string::npos ? text : text.substr(equals + 1)) + ",");
  for (std::string count; std::getline(counts, count, ',');) list.cells.push_back(read_count(count, text));
  std::sort(list.cells.begin(), list.cells.end());
  if (list.cells.size() < 2 || std::adjacent_find(list.cells.begin(), list.cells.end()) != list.cells.end())
    refuse("--cells " + text +
           ": give two or more different numbers of cells, preferably four, such as 8,16,32,64");
  return list;
}

const scenes::PartGeometry& leading_part(const scenes::LoadedScene& loaded) {
  for (const std::size_t directions : {2u, 1u})
    for (const auto& part : loaded.parts)
      if (part.cells.size() == directions) return part;
  refuse("nothing in this scene is divided into cells, so there is no mesh to refine");
}

std::vector<MeshLevel> mesh_levels(const scenes::LoadedScene& loaded, const CellList& list) {
  const scenes::PartGeometry& leading =
      list.part.empty() ? leading_part(loaded) : part_named(loaded, list.part);
  const auto parts = divided_parts(loaded, list.part);
  refuse_numbered_nodes(loaded, names_of(parts));
  std::vector<MeshLevel> levels;
  for (const auto cells : list.cells) levels.push_back(level(parts, cells, {cells, leading.cells[0]}));
  return levels;
}

MeshSize count_mesh(const scenes::LoadedScene& loaded) {
  if (!loaded.gear) {
    const scenes::PartGeometry& part = leading_part(loaded);
    return {part.cells[0], 1.0 / part.cells[0], "cells of " + part.name, true};
  }
  std::set<std::uint32_t> nodes;
  for (const auto part : parts_of(*loaded.gear))
    nodes.insert(loaded.parts[part].nodes.begin(), loaded.parts[part].nodes.end());
  const auto count = static_cast<std::int64_t>(nodes.size());
  return {count, 1 / std::sqrt(static_cast<double>(count)), "nodes of the gear", false};
}

std::vector<MeshLevel> gear_levels(const scenes::LoadedScene& loaded,
                                   const std::vector<std::int64_t>& nodes) {
  if (!loaded.gear)
    refuse("this scene has no net plan, so it has no gear nodes to count; use --cells instead");
  Names parts;
  for (const auto part : parts_of(*loaded.gear)) parts.insert(loaded.parts[part].name);
  refuse_numbered_nodes(loaded, parts);
  std::vector<MeshLevel> levels;
  for (const auto count : nodes)
    levels.push_back({count,
                      {formats::make_change({"gear", "nodes"}, {{}, count}),
                       formats::make_change({"gear", "size"}, {{}, std::int64_t{0}})}});
  return levels;
}

namespace {

std::vector<MeshLevel> gear_levels_around(const scenes::LoadedScene& loaded) {
  const std::int64_t own = count_mesh(loaded).count;
  if (own / 2 >= kFewestNodes) return gear_levels(loaded, {own / 2, own * 2});
  return gear_levels(loaded, {own * 2, own * 4});
}

}  // namespace

std::vector<MeshLevel> levels_around(const scenes::LoadedScene& loaded) {
  if (loaded.gear) return gear_levels_around(loaded);
  const std::int64_t own = leading_part(loaded).cells[0];
  const auto parts = divided_parts(loaded, "");
  refuse_numbered_nodes(loaded, names_of(parts));
  std::vector<Factor> factors{{2, 1}};
  if (all_divide(parts, {1, 4}) && own / 4 >= kFewestWorthwhile)
    factors = {{1, 4}, {1, 2}};
  else if (all_divide(parts, {1, 2}))
    factors = {{1, 2}, {2, 1}};
  std::vector<MeshLevel> levels;
  for (const auto& factor : factors) levels.push_back(level(parts, factor.of(own), factor));
  return levels;
}

}  // namespace netloft::studies
