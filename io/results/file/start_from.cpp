// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/start_from.hpp"

#include "io/runs/carried_gear.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::results {

namespace {

/// The nodes of one part: from numbers within the part to nodes of the result or of the scene.
using PartNumbers = std::map<std::uint32_t, std::uint32_t>;

std::vector<PartNumbers> numbers_of(const StoredShape& stored) {
  std::vector<PartNumbers> all(stored.parts.size());
  for (std::uint32_t n = 0; n < stored.mesh.n_points; ++n)
    all[stored.mesh.node_part[n]].emplace(stored.mesh.node_number[n], n);
  return all;
}

std::vector<PartNumbers> numbers_of(const scenes::LoadedScene& loaded) {
  std::vector<PartNumbers> all(loaded.scene.parts.size());
  for (std::uint32_t n = 0; n < loaded.scene.node_count(); ++n) {
    const NodeLabel label = loaded.scene.labels[n];
    all[label.part].emplace(label.id, n);
  }
  return all;
}

bool are_alike(const PartNumbers& a, const PartNumbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& p, const auto& q) { return p.first == q.first; });
}

/// Takes the positions of one part after another from the result. Each carry_… function is one way to do so.
class Carrier {
 public:
  Carrier(const StoredShape& stored, const scenes::LoadedScene& loaded)
      : stored_(stored),
        loaded_(loaded),
        x_(stored.points(stored.times.empty() ? 0 : stored.times.size() - 1)),
        images_(x_),
        positions_(loaded.scene.positions) {
    for (std::size_t y = 1; y < images_.size(); y += 3) images_[y] *= -1;
  }

  std::vector<double> carry() {
    const auto there = numbers_of(stored_), here = numbers_of(loaded_);
    bool has_any = false;
    for (std::size_t p = 0; p < loaded_.scene.parts.size(); ++p) {
      const Source from = source_of(loaded_.scene.parts[p].name);
      if (!from.part || loaded_.scene.parts[p].companion) continue;
      has_any = true;
      const std::vector<double>& x = from.side == Side::port ? images_ : x_;
      if (from.side == Side::both && is_divided(p))
        carry_halves(*from.part, p);
      else if (are_alike(there[*from.part], here[p]) && (from.side == Side::all || !is_divided(p)))
        copy(there[*from.part], here[p], x);
      else
        carry_division(*from.part, p, x);
    }
    if (!has_any)
      throw formats::FileError(stored_.result.path + " has none of the parts of " + loaded_.scene.name);
    return std::move(positions_);
  }

 private:
  /// How a part of the scene gets its positions from a part of the result. `all`: all nodes, because both
  /// gears have the same extent. The other values are for a scene of the whole gear and a result of half a
  /// gear, which has the starboard side only. `both`: the part is in the middle, and the result has its
  /// starboard half. `starboard`, `port`: the part is one of a pair, and the result has the starboard one.
  /// Positions on the port side are mirror images.
  enum class Side { all, both, starboard, port };
  struct Source {
    std::optional<std::uint32_t> part;
    Side side = Side::all;
  };
  Source source_of(const std::string& name) const {
    const bool from_half = stored_.result.is_half() && loaded_.gear && loaded_.gear->times == 1;
    if (from_half)
      for (const std::string side : {"starboard-", "port-"})
        if (name.starts_with(side))
          if (const auto part = find_part(stored_, name.substr(side.size())))
            return {part, side == "port-" ? Side::port : Side::starboard};
    return {find_part(stored_, name), from_half ? Side::both : Side::all};
  }
  bool is_rope(std::size_t part) const {
    const Part& p = loaded_.scene.parts[part];
    return p.data.contains(datum::kRestLength.name) && p.nodes.size() >= 2;
  }
  bool is_divided(std::size_t part) const { return is_rope(part) || !loaded_.parts[part].panel.empty(); }

  void copy(const PartNumbers& there, const PartNumbers& here, const std::vector<double>& x) {
    for (auto from = there.begin(), to = here.begin(); to != here.end(); ++from, ++to)
      std::copy_n(x.begin() + 3 * std::ptrdiff_t{from->second}, 3,
                  positions_.begin() + 3 * std::ptrdiff_t{to->second});
  }

  void carry_division(std::uint32_t there, std::size_t here, const std::vector<double>& x) {
    if (is_rope(here)) {
      if (const Part rope = rope_of(there); !rope.nodes.empty())
        runs::carry_rope(rope, x, loaded_.scene.parts[here], positions_);
    } else if (!loaded_.parts[here].panel.empty()) {
      if (const Part panel = panel_of(there); !panel.nodes.empty())
        runs::carry_panel(panel, x, places_of(loaded_.parts[here]), positions_);
    }
  }

  /// Takes both halves of a part from a result that has the starboard half only.
  void carry_halves(std::uint32_t there, std::size_t here) {
    if (is_rope(here)) {
      if (const Part rope = rope_of(there); !rope.nodes.empty())
        runs::carry_rope(whole_rope(rope), both_halves(), loaded_.scene.parts[here], positions_);
    } else if (const Part panel = panel_of(there); !panel.nodes.empty()) {
      runs::carry_panel(whole_panel(panel), both_halves(), places_of(loaded_.parts[here]), positions_);
    }
  }

  /// All nodes of the result, and then their mirror images.
  std::vector<double> both_halves() const {
    std::vector<double> x = x_;
    x.insert(x.end(), images_.begin(), images_.end());
    return x;
  }
  std::uint32_t image_of(std::uint32_t node) const {
    return node + static_cast<std::uint32_t>(x_.size() / 3);
  }

  /// The whole rope from port to starboard, made from its starboard half, which starts on the plane of
  /// symmetry.
  Part whole_rope(const Part& half) const {
    Part whole;
    for (auto node = half.nodes.rbegin(); node != half.nodes.rend(); ++node)
      whole.nodes.push_back(image_of(*node));
    whole.nodes.insert(whole.nodes.end(), half.nodes.begin(), half.nodes.end());
    const std::vector<double>& lengths = half.data.at(datum::kRestLength.name);
    std::vector<double>& all = whole.data[datum::kRestLength.name];
    all.assign(lengths.rbegin(), lengths.rend());
    all.insert(all.end(), lengths.begin(), lengths.end());
    return whole;
  }

  /// The whole panel, made from its starboard half. The mirror image has negative U.
  Part whole_panel(const Part& half) const {
    Part whole = half;
    for (const auto node : half.nodes) whole.nodes.push_back(image_of(node));
    for (const double u : half.data.at(datum::kU.name)) whole.data[datum::kU.name].push_back(-u);
    const std::vector<double>& v = half.data.at(datum::kV.name);
    whole.data[datum::kV.name].insert(whole.data[datum::kV.name].end(), v.begin(), v.end());
    return whole;
  }

  /// The bars of a rope in the result, with their present lengths instead of unstretched ones.
  Part rope_of(std::uint32_t part) const {
    Part rope;
    std::vector<double>& lengths = rope.data[datum::kRestLength.name];
    for (std::size_t b = 0; b < stored_.mesh.bars.size(); ++b) {
      if (stored_.mesh.cell_part[stored_.mesh.bar_cells[b]] != part) continue;
      const auto [from, to] = stored_.mesh.bars[b];
      rope.nodes.insert(rope.nodes.end(), {from, to});
      const double *p = &x_[3 * std::size_t{from}], *q = &x_[3 * std::size_t{to}];
      lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
    }
    return rope;
  }

  /// The triangles of a panel in the result, with the coordinates of their corners in meshes.
  Part panel_of(std::uint32_t part) const {
    Part panel;
    std::vector<double>&u = panel.data[datum::kU.name], &v = panel.data[datum::kV.name];
    for (std::size_t t = 0; t < stored_.mesh.triangles.size(); ++t) {
      const auto& corners = stored_.mesh.corners[t];
      const bool has_places =
          std::all_of(corners.begin(), corners.end(), [](double c) { return std::isfinite(c); });
      if (stored_.mesh.cell_part[stored_.mesh.triangle_cells[t]] != part || !has_places) continue;
      panel.nodes.insert(panel.nodes.end(), stored_.mesh.triangles[t].begin(),
                         stored_.mesh.triangles[t].end());
      for (std::size_t c = 0; c < 3; ++c) {
        u.push_back(corners[2 * c]);
        v.push_back(corners[2 * c + 1]);
      }
    }
    return panel;
  }

  /// All nodes of a panel of the scene with their panel coordinates, as corners of triangles, because
  /// carry_panel() expects triangles. The last node is repeated to complete a triangle.
  static Part places_of(const scenes::PartGeometry& geometry) {
    Part panel;
    std::vector<double>&u = panel.data[datum::kU.name], &v = panel.data[datum::kV.name];
    for (std::size_t own = 0; own < (geometry.nodes.size() + 2) / 3 * 3; ++own) {
      const std::size_t n = std::min(own, geometry.nodes.size() - 1);
      panel.nodes.push_back(geometry.nodes[n]);
      u.push_back(geometry.panel[n][0]);
      v.push_back(geometry.panel[n][1]);
    }
    return panel;
  }

  const StoredShape& stored_;
  const scenes::LoadedScene& loaded_;
  std::vector<double> x_, images_, positions_;  // images_: x_ mirrored at the plane of symmetry, y = 0
};

}  // namespace

std::vector<double> positions_from(const StoredShape& stored, const scenes::LoadedScene& loaded) {
  return Carrier(stored, loaded).carry();
}

}  // namespace netloft::results
