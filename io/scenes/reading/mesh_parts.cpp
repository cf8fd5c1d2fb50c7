// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/mesh_parts.hpp"

#include "io/gears/plan/twine_coordinates.hpp"
#include "io/scenes/reading/geometry_keys.hpp"
#include "io/scenes/reading/part_names.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace netloft::scenes {

namespace {

const GeometryKey kMesh{"mesh", "1", "file with the mesh of the gear", GeometryKey::Shape::word, {}, {}};
const GeometryKey kRegion{"region",
                          "1",
                          "region of the mesh; default: the one with the name of the part",
                          GeometryKey::Shape::word,
                          {},
                          {},
                          false};

formats::RegionKind kind_for(Layout layout) {
  switch (layout) {
    case Layout::panel_in_triangles:
      return formats::RegionKind::triangles;
    case Layout::panel_in_bars:
      return formats::RegionKind::twines;
    default:
      return formats::RegionKind::bars;
  }
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(path, fault)) return {};
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in ? std::optional(std::move(text).str()) : std::nullopt;
}

std::string names_of_regions(const formats::InputMesh& mesh, formats::RegionKind kind) {
  std::string names;
  for (const auto& region : mesh.regions)
    if (region.kind == kind) names += (names.empty() ? "" : ", ") + region.name;
  return names.empty() ? "it has no " + std::string(formats::name_of(kind)) : "there is: " + names;
}

/// The nodes of a region, which become the nodes of a part. Their numbers within the part ("own" numbers) are
/// in the order of the mesh.
struct OwnNodes {
  OwnNodes(const formats::InputMesh& mesh, const formats::MeshRegion& region)
      : nodes(region.nodes), own(mesh.node_count(), kNone) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) own[nodes[i]] = i;
  }
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> nodes;  // indexed by own number: number in the mesh
  std::vector<std::uint32_t> own;    // indexed by number in the mesh: own number; kNone outside the region
};

void add_nodes(const formats::InputMesh& mesh, const formats::MeshRegion& region, const OwnNodes& numbers,
               Geometry& out) {
  for (const auto node : numbers.nodes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      out.positions.push_back(mesh.positions[3 * std::size_t{node} + axis]);
  for (const auto node : region.nodes) out.elements.push_back(numbers.own[node]);
  for (const auto& set : mesh.sets)
    for (const auto node : set.nodes)
      if (numbers.own[node] != OwnNodes::kNone) out.names.sets[set.name].push_back(numbers.own[node]);
}

void read_triangles(const formats::MeshRegion& region, formats::TableReader& part, Geometry& out) {
  formats::TableReader panel = part.table("panel", formats::Presence::required, "the netting of the panel");
  const double bar = read_real(panel, kBar);
  const std::string netting = read_word(panel, kNetting);
  double aft = region.numbers[1];
  for (std::size_t i = 1; i < region.numbers.size(); i += 2) aft = std::max(aft, region.numbers[i]);
  out.names.panel.resize(out.node_count());
  for (std::size_t corner = 0; corner < region.nodes.size(); ++corner) {
    const double U = region.numbers[2 * corner], V = region.numbers[2 * corner + 1];
    const auto [u, v] = gears::twine_coordinates(netting, 0, U, V);
    out.data[datum::kU.name].push_back(u);
    out.data[datum::kV.name].push_back(v);
    out.data[datum::kToAft.name].push_back(aft - V);
    out.names.panel[out.elements[corner]] = {U, V};
  }
  out.data[datum::kBarLength.name].assign(region.size(), bar);
  out.data[datum::kOutward.name].assign(region.size(), 1);
}

/// Names the start, the end and the middle of a rope whose bars follow one another.
void name_ends(Geometry& out) {
  const auto& bars = out.elements;
  for (std::size_t i = 2; i < bars.size(); i += 2)
    if (bars[i] != bars[i - 1]) return;
  out.names.sets.try_emplace("start", std::vector{bars.front()});
  out.names.sets.try_emplace("end", std::vector{bars.back()});
  if (const std::size_t count = bars.size() / 2; count % 2 == 0)
    out.names.sets.try_emplace("middle", std::vector{bars[count]});
}

void read_bars(const formats::MeshRegion& region, formats::TableReader& part, Geometry& out) {
  const double length = read_real(part, kLength);
  for (std::size_t e = 0; e < region.size(); ++e)
    out.data[datum::kRestLength.name].push_back(length * (region.numbers[2 * e + 1] - region.numbers[2 * e]));
  name_ends(out);
}

void read_twines(const formats::MeshRegion& region, formats::TableReader& part, Geometry& out) {
  formats::TableReader panel = part.table("panel", formats::Presence::required, "the netting of the panel");
  const double bar = read_real(panel, kBar);
  for (std::size_t e = 0; e < region.size(); ++e) {
    out.data[datum::kRestLength.name].push_back(bar * region.numbers[2 * e]);
    out.data[datum::kParallel.name].push_back(region.numbers[2 * e + 1]);
  }
}

}  // namespace

const std::vector<GeometryKey>& mesh_keys(Layout layout) {
  static const ByLayout<std::vector<GeometryKey>> keys{
      {}, {kMesh, kRegion, kLength}, {kMesh, kRegion, kBar, kNetting}, {kMesh, kRegion, kBar}, {}};
  return keys.of(layout);
}

MeshParts::MeshParts(std::filesystem::path folder, formats::Diagnostics& diagnostics)
    : folder_(std::move(folder)), diagnostics_(diagnostics) {}

Geometry MeshParts::read(const ElementType& type, const std::string& name, std::size_t part,
                         formats::TableReader& table) {
  Geometry out;
  const Layout layout = layout_of(type);
  if (layout == Layout::point) {
    table.error("mesh", "has no nodes for elements that stand on points", "write on = \"part.set\" instead");
    return out;
  }
  const formats::InputMesh* mesh = find_mesh(table);
  table.has("region");  // makes the key known even if the mesh is missing
  const formats::MeshRegion* region = mesh ? find_region(*mesh, kind_for(layout), name, table) : nullptr;
  const formats::MeshRegion none{kind_for(layout), name, {}, std::vector<double>(2)};
  if (region) {
    standing_.push_back({part, mesh, OwnNodes(*mesh, *region).nodes});
    add_nodes(*mesh, *region, OwnNodes(*mesh, *region), out);
  }
  // If the region is missing, the other keys are still checked.
  const formats::MeshRegion& stands_on = region ? *region : none;
  if (layout == Layout::panel_in_triangles) read_triangles(stands_on, table, out);
  if (layout == Layout::panel_in_bars) read_twines(stands_on, table, out);
  if (layout == Layout::line) region ? read_bars(*region, table, out) : void(read_real(table, kLength));
  return out;
}

const formats::InputMesh* MeshParts::find_mesh(formats::TableReader& table) {
  const std::string name = table.text("mesh", {.doc = kMesh.doc});
  if (name.empty()) {
    if (table.kind("mesh") == formats::Kind::text) table.error("mesh", "is empty (" + kMesh.doc + ")");
    return nullptr;
  }
  const auto [at, is_new] = meshes_.try_emplace(name);
  if (!is_new) return at->second.get();
  const auto text = read_file(folder_ / name);
  if (!text) {
    table.error("mesh", formats::in_quotes(name) + " cannot be read",
                "files are named relative to the scene");
    return nullptr;
  }
  const int file = diagnostics_.add_source(name, *text);
  const int errors_before = diagnostics_.errors();
  const bool is_binary = text->find('\0') != std::string::npos;  // results cannot store binary files
  files_.push_back({name, is_binary ? "" : *text, formats::fnv1a64(*text)});
  auto mesh = std::make_unique<formats::InputMesh>(
      formats::is_hdf5(*text) ? formats::read_vtkhdf(folder_ / name, file, diagnostics_)
                              : formats::read_any_mesh(*text, file, diagnostics_));
  if (diagnostics_.errors() == errors_before) at->second = std::move(mesh);
  return at->second.get();
}

const formats::MeshRegion* MeshParts::find_region(const formats::InputMesh& mesh, formats::RegionKind kind,
                                                  const std::string& name, formats::TableReader& table) {
  const bool is_said = table.has("region");
  const std::string wanted = is_said ? table.text("region", {.doc = kRegion.doc}) : name;
  const formats::MeshRegion* region = mesh.find(wanted);
  if (region && region->kind == kind && region->size() > 0) return region;
  const char* key = is_said ? "region" : "mesh";
  if (region && region->kind == kind)
    table.error(key, "the region " + formats::in_quotes(wanted) + " is empty");
  else
    table.error(key, "has no region " + formats::in_quotes(wanted) + " of " + formats::name_of(kind),
                names_of_regions(mesh, kind) + (is_said ? "" : "; name it with region = \"…\""));
  return nullptr;
}

bool MeshParts::has_failed() const {
  return std::any_of(meshes_.begin(), meshes_.end(), [](const auto& mesh) { return !mesh.second; });
}

void MeshParts::connect(Joiner& joiner) const {
  using Ends = Joiner::Ends;
  std::map<std::pair<const formats::InputMesh*, std::uint32_t>, std::pair<std::size_t, std::uint32_t>> first;
  // The common nodes of each pair of parts.
  std::map<std::pair<std::size_t, std::size_t>, std::pair<Ends, Ends>> common;
  for (const auto& s : standing_)
    for (std::uint32_t own = 0; own < s.nodes.size(); ++own) {
      const auto [at, is_new] = first.try_emplace({s.mesh, s.nodes[own]}, s.part, own);
      if (is_new) continue;
      const auto [part, other] = at->second;
      auto& ends = common.try_emplace({part, s.part}, Ends{part, {}}, Ends{s.part, {}}).first->second;
      ends.first.own.push_back(other);
      ends.second.own.push_back(own);
    }
  for (const auto& [parts, ends] : common) joiner.join({ends.first, ends.second});
}

}  // namespace netloft::scenes
