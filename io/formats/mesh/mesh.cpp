// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/mesh.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace netloft::formats {

namespace {

bool has_netting(const double* UV) {
  const double d = (UV[2] - UV[0]) * (UV[5] - UV[1]) - (UV[4] - UV[0]) * (UV[3] - UV[1]);
  return std::abs(d) > 1e-9;
}

}  // namespace

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

std::optional<ElementFault> fault_of(const MeshRegion& region, std::size_t element) {
  const std::uint32_t* node = &region.nodes[element * nodes_in(region.kind)];
  const double* number = &region.numbers[element * numbers_in(region.kind)];
  const bool is_triangle = region.kind == RegionKind::triangles;
  if (node[0] == node[1] || (is_triangle && (node[0] == node[2] || node[1] == node[2])))
    return ElementFault{true, "a node appears twice: the element has no size"};
  const double* end = number + numbers_in(region.kind);
  if (const double* far = std::find_if_not(number, end, [](double x) { return std::abs(x) <= kFarthest; });
      far != end)
    return ElementFault{false, "a number of the element is not finite or is above a million"};
  if (is_triangle && !has_netting(number))
    return ElementFault{false, "the corners lie on one line in meshes: there is no netting between them"};
  if (region.kind == RegionKind::bars && !(number[0] >= 0 && number[0] < number[1] && number[1] <= 1))
    return ElementFault{false, "shares of a rope must grow from 0 at its beginning to 1 at its end"};
  if (region.kind == RegionKind::twines && !(number[0] > 0 && number[1] > 0))
    return ElementFault{false, "a bar of twines must have a length and a number of twines above zero"};
  return {};
}

std::string spell_number(double value) {
  char text[32];
  const auto [end, fault] = std::to_chars(text, text + sizeof text, value);
  return fault == std::errc{} ? std::string(text, end) : "nan";
}

namespace {

constexpr std::size_t kNodesALine = 12;

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

std::string comment_of(const std::string& source) {
  std::string text = "# ";
  for (const char c : source) text += c == '\n' ? std::string("\n# ") : std::string(1, c);
  return source.empty() ? "" : text + "\n";
}

std::string mesh_text(const InputMesh& mesh, const std::string& source) {
  std::string out = "netloft mesh 1\n" + comment_of(source);
  write_nodes(mesh, out);
  for (const auto& region : mesh.regions) write_region(region, out);
  for (const auto& set : mesh.sets) write_set(set, out);
  return out + "\n[end]\n";
}

}  // namespace netloft::formats
