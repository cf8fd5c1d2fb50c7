// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh/mesh.hpp"

#include <algorithm>
#include <charconv>

namespace netloft::io {

const char* name_of(RegionKind kind) {
  switch (kind) {
    case RegionKind::triangles:
      return "triangles";
    case RegionKind::bars:
      return "bars";
    default:
      return "twines";
  }
}

const MeshRegion* InputMesh::find(const std::string& region) const {
  const auto at =
      std::find_if(regions.begin(), regions.end(), [&](const auto& r) { return r.name == region; });
  return at == regions.end() ? nullptr : &*at;
}

std::string spell_number(double value) {
  char text[32];
  const auto [end, fault] = std::to_chars(text, text + sizeof text, value);
  return fault == std::errc{} ? std::string(text, end) : "nan";
}

namespace {

constexpr std::size_t kNodesALine = 12;

std::string comment_of(const std::string& source) {
  std::string text = "# ";
  for (const char c : source) text += c == '\n' ? std::string("\n# ") : std::string(1, c);
  return source.empty() ? "" : text + "\n";
}

void write_nodes(const InputMesh& mesh, std::string& out) {
  out += "\n[nodes]  # x y z [m], counted from 0\n";
  for (std::size_t n = 0; n < mesh.node_count(); ++n)
    for (std::size_t axis = 0; axis < 3; ++axis)
      out += spell_number(mesh.positions[3 * n + axis]) + (axis < 2 ? " " : "\n");
}

void write_region(const MeshRegion& region, std::string& out) {
  static constexpr const char* columns[] = {"three nodes, U1 V1 U2 V2 U3 V3 [meshes]",
                                            "two nodes, from and to [share of the rope]",
                                            "two nodes, length [mesh sides], twines"};
  out += "\n[" + std::string(name_of(region.kind)) + " " + region.name + "]  # " +
         columns[static_cast<std::size_t>(region.kind)] + "\n";
  const std::size_t nodes = nodes_in(region.kind), numbers = numbers_in(region.kind);
  for (std::size_t e = 0; e < region.size(); ++e) {
    for (std::size_t k = 0; k < nodes; ++k) out += std::to_string(region.nodes[e * nodes + k]) + " ";
    for (std::size_t k = 0; k < numbers; ++k)
      out += spell_number(region.numbers[e * numbers + k]) + (k + 1 < numbers ? " " : "\n");
  }
}

void write_set(const MeshSet& set, std::string& out) {
  out += "\n[set " + set.name + "]\n";
  for (std::size_t i = 0; i < set.nodes.size(); ++i)
    out += std::to_string(set.nodes[i]) +
           (i % kNodesALine == kNodesALine - 1 || i + 1 == set.nodes.size() ? "\n" : " ");
}

}  // namespace

std::string mesh_text(const InputMesh& mesh, const std::string& source) {
  std::string out = "netloft mesh 1\n" + comment_of(source);
  write_nodes(mesh, out);
  for (const auto& region : mesh.regions) write_region(region, out);
  for (const auto& set : mesh.sets) write_set(set, out);
  return out + "\n[end]\n";
}

}  // namespace netloft::io
