// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/femnet_scene.hpp"

#include <algorithm>
#include <numeric>

namespace netloft::scenes::femnet {

namespace {

bool is_zero(const Triple& t) { return t == Triple{}; }

void add_bars_of_cable(std::size_t cable, const MeshFile& file, const std::vector<bool>& is_hauled,
                       formats::InputMesh& mesh) {
  std::vector<const MeshFile::Bar*> bars;
  for (std::size_t b = 0; b < file.bars.size(); ++b)
    if (file.bars[b].cable == static_cast<int>(cable) + 1 && !is_hauled[b]) bars.push_back(&file.bars[b]);
  if (bars.empty()) return;
  std::stable_sort(bars.begin(), bars.end(), [](auto* a, auto* b) { return a->shares[0] < b->shares[0]; });
  formats::MeshRegion region{formats::RegionKind::bars, cable_name(cable)};
  for (const auto* b : bars) {
    region.nodes.insert(region.nodes.end(), b->nodes.begin(), b->nodes.end());
    region.numbers.insert(region.numbers.end(), b->shares.begin(), b->shares.end());
  }
  mesh.regions.push_back(std::move(region));
}

void add_triangles(std::size_t panel, const MeshFile& file, formats::InputMesh& mesh) {
  formats::MeshRegion region{formats::RegionKind::triangles, panel_name(panel)};
  for (const auto& t : file.triangles) {
    if (t.panel != static_cast<int>(panel)) continue;
    for (const std::size_t k : {0u, 2u, 1u}) {
      region.nodes.push_back(t.nodes[k]);
      region.numbers.push_back(t.UV[2 * k]);
      region.numbers.push_back(t.UV[2 * k + 1]);
    }
  }
  if (region.size() > 0) mesh.regions.push_back(std::move(region));
}

void add_twines(std::size_t panel, const GearFile& gear, const MeshFile& file, formats::InputMesh& mesh) {
  formats::MeshRegion region{formats::RegionKind::twines, panel_name(panel)};
  for (const auto& b : file.bars) {
    if (b.cable != -static_cast<int>(panel) - 1) continue;
    region.nodes.insert(region.nodes.end(), b.nodes.begin(), b.nodes.end());
    region.numbers.push_back(TwineBar(gear.panels[panel]).sides);
    region.numbers.push_back(gear.panels[panel].twines);
  }
  if (region.size() == 0) return;
  if (mesh.find(region.name)) region.name += "-twines";
  mesh.regions.push_back(std::move(region));
}

/// Adds a set for each plane of symmetry: the nodes in this plane that belong to cables with bending
/// stiffness.
void add_planes(const GearFile& gear, const MeshFile& file, formats::InputMesh& mesh) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    formats::MeshSet plane{plane_name(axis)};
    for (const auto& b : file.bars) {
      if (b.cable <= 0 || !(gear.cables[static_cast<std::size_t>(b.cable) - 1].EI > 0)) continue;
      for (const auto n : b.nodes)
        if (gear.types[static_cast<std::size_t>(file.nodes[n].type)].symmetry[axis] != 0 &&
            std::find(plane.nodes.begin(), plane.nodes.end(), n) == plane.nodes.end())
          plane.nodes.push_back(n);
    }
    if (!plane.nodes.empty()) mesh.sets.push_back(std::move(plane));
  }
}

void add_sets(const GearFile& gear, const MeshFile& file, formats::InputMesh& mesh) {
  for (std::size_t type = 0; type < gear.types.size(); ++type) {
    const bool is_moved = std::any_of(gear.motions.begin(), gear.motions.end(),
                                      [&](const auto& m) { return m.type == static_cast<int>(type); });
    if (!is_special(gear.types[type]) && !is_moved) continue;
    formats::MeshSet set{type_name(type)};
    for (std::uint32_t n = 0; n < file.nodes.size(); ++n)
      if (file.nodes[n].type == static_cast<int>(type)) set.nodes.push_back(n);
    if (!set.nodes.empty()) mesh.sets.push_back(std::move(set));
  }
  add_planes(gear, file, mesh);
  const auto loose = find_loose(gear, file);
  for (std::size_t i = 0; i < loose.size(); ++i)
    mesh.sets.push_back({"loose-" + std::to_string(i + 1), {loose[i].node}});
}

/// Groups the nodes of a mesh into connected pieces: nodes that elements connect have the same leader.
class Pieces {
 public:
  explicit Pieces(const MeshFile& file) : leader_(file.nodes.size()), is_used_(file.nodes.size()) {
    std::iota(leader_.begin(), leader_.end(), 0u);
    for (const auto& b : file.bars) connect(b.nodes[0], b.nodes[1]);
    for (const auto& t : file.triangles) {
      connect(t.nodes[0], t.nodes[1]);
      connect(t.nodes[0], t.nodes[2]);
    }
  }
  std::uint32_t leader(std::uint32_t node) {
    while (leader_[node] != node) node = leader_[node] = leader_[leader_[node]];
    return node;
  }
  bool is_used(std::uint32_t node) const { return is_used_[node]; }

 private:
  void connect(std::uint32_t a, std::uint32_t b) {
    is_used_[a] = is_used_[b] = true;
    const auto x = leader(a), y = leader(b);
    leader_[std::max(x, y)] = std::min(x, y);
  }
  std::vector<std::uint32_t> leader_;
  std::vector<bool> is_used_;
};

}  // namespace

std::string panel_name(std::size_t panel) { return "panel-" + std::to_string(panel + 1); }
std::string cable_name(std::size_t cable) { return "cable-" + std::to_string(cable + 1); }
std::string bar_name(std::size_t cable, std::size_t number) {
  return cable_name(cable) + "-bar-" + std::to_string(number + 1);
}
std::string type_name(std::size_t type) { return "type-" + std::to_string(type + 1); }

std::string plane_name(std::size_t axis) { return std::string("plane-") + "xyz"[axis]; }

bool is_special(const NodeType& t) {
  return t.mass[2] != 0 || t.box[2] != 0 || !is_zero(t.force) || !is_zero(t.fixed) || !is_zero(t.sense) ||
         !is_zero(t.symmetry);
}

TwineBar::TwineBar(const Panel& p) {
  const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  length = single(single(p.twines * p.side) / p.bars);
  sides = p.twines / p.bars;
  EA = single(p.twines * p.EA);
  EA_compression = single(p.twines * p.EA_compression);
}

std::vector<Loose> find_loose(const GearFile& gear, const MeshFile& file) {
  Pieces pieces(file);
  std::map<std::uint32_t, Loose> found;  // loose nodes by the leader of their connected piece
  for (std::uint32_t n = 0; n < file.nodes.size(); ++n)
    if (pieces.is_used(n)) found.try_emplace(pieces.leader(n), Loose{n, {true, true, true}});
  for (std::uint32_t n = 0; n < file.nodes.size(); ++n) {
    if (!pieces.is_used(n)) continue;
    const NodeType& type = gear.types[static_cast<std::size_t>(file.nodes[n].type)];
    auto& axes = found.at(pieces.leader(n)).axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (type.fixed[axis] != 0 || type.symmetry[axis] != 0) axes[axis] = false;
    // Buoyancy or the bed keeps the piece in place along z.
    if (type.box[2] != 0 || type.sense[2] != 0) axes[2] = false;
  }
  std::vector<Loose> loose;
  for (const auto& [leader, piece] : found)
    if (piece.axes[0] || piece.axes[1] || piece.axes[2]) loose.push_back(piece);
  return loose;
}

formats::InputMesh make_mesh(const GearFile& gear, const MeshFile& file,
                             const std::vector<HauledBar>& hauled) {
  std::vector<bool> is_hauled(file.bars.size());
  for (const auto& h : hauled) is_hauled[h.bar] = true;
  formats::InputMesh mesh;
  for (const auto& n : file.nodes) mesh.positions.insert(mesh.positions.end(), n.at.begin(), n.at.end());
  for (std::size_t p = 0; p < gear.panels.size(); ++p) {
    add_triangles(p, file, mesh);
    add_twines(p, gear, file, mesh);
  }
  for (std::size_t c = 0; c < gear.cables.size(); ++c) add_bars_of_cable(c, file, is_hauled, mesh);
  for (const auto& h : hauled) {
    const MeshFile::Bar& b = file.bars[h.bar];
    mesh.regions.push_back({formats::RegionKind::bars,
                            bar_name(static_cast<std::size_t>(b.cable) - 1, h.number),
                            {b.nodes[0], b.nodes[1]},
                            {b.shares[0], b.shares[1]}});
  }
  add_sets(gear, file, mesh);
  return mesh;
}

}  // namespace netloft::scenes::femnet
