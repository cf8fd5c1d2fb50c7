// SPDX-License-Identifier: BSD-3-Clause
#include "io/result/start_from.hpp"

#include "io/case/carried_gear.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

/// Own number -> node, of every part.
using Numbers = std::map<std::uint32_t, std::uint32_t>;

std::vector<Numbers> numbers_of(const StoredResult& result) {
  std::vector<Numbers> all(result.parts.size());
  for (std::uint32_t n = 0; n < result.mesh.n_points; ++n)
    all[result.mesh.node_part[n]].emplace(result.mesh.node_number[n], n);
  return all;
}

std::vector<Numbers> numbers_of(const LoadedScene& loaded) {
  std::vector<Numbers> all(loaded.scene.parts.size());
  for (std::uint32_t n = 0; n < loaded.scene.node_count(); ++n) {
    const NodeLabel label = loaded.scene.labels[n];
    all[label.part].emplace(label.id, n);
  }
  return all;
}

bool are_alike(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& p, const auto& q) { return p.first == q.first; });
}

/// Carries one part after the other; members are the ways to do so.
class Carrier {
 public:
  Carrier(const StoredResult& result, const LoadedScene& loaded)
      : result_(result),
        loaded_(loaded),
        x_(result.points(result.times.empty() ? 0 : result.times.size() - 1)),
        positions_(loaded.scene.positions) {}

  std::vector<double> carry() {
    const auto there = numbers_of(result_), here = numbers_of(loaded_);
    bool has_any = false;
    for (std::size_t p = 0; p < loaded_.scene.parts.size(); ++p) {
      const auto part = find_part(result_, loaded_.scene.parts[p].name);
      if (!part || loaded_.scene.parts[p].companion) continue;
      has_any = true;
      if (are_alike(there[*part], here[p]))
        copy(there[*part], here[p]);
      else
        carry_division(*part, p);
    }
    if (!has_any) throw FileError(result_.path.string() + " has none of the parts of " + loaded_.scene.name);
    return std::move(positions_);
  }

 private:
  void copy(const Numbers& there, const Numbers& here) {
    for (auto from = there.begin(), to = here.begin(); to != here.end(); ++from, ++to)
      std::copy_n(x_.begin() + 3 * std::ptrdiff_t{from->second}, 3,
                  positions_.begin() + 3 * std::ptrdiff_t{to->second});
  }

  void carry_division(std::uint32_t there, std::size_t here) {
    const Part& part = loaded_.scene.parts[here];
    if (part.data.contains("rest_length") && part.nodes.size() >= 2) {
      if (const Part rope = rope_of(there); !rope.nodes.empty()) carry_rope(rope, x_, part, positions_);
    } else if (!loaded_.parts[here].panel.empty()) {
      if (const Part panel = panel_of(there); !panel.nodes.empty())
        carry_panel(panel, x_, places_of(loaded_.parts[here]), positions_);
    }
  }

  /// The bars of a rope in the result, with their lengths there.
  Part rope_of(std::uint32_t part) const {
    Part rope;
    std::vector<double>& lengths = rope.data["rest_length"];
    for (std::size_t b = 0; b < result_.mesh.bars.size(); ++b) {
      if (result_.mesh.cell_part[result_.mesh.bar_cells[b]] != part) continue;
      const auto [from, to] = result_.mesh.bars[b];
      rope.nodes.insert(rope.nodes.end(), {from, to});
      const double *p = &x_[3 * std::size_t{from}], *q = &x_[3 * std::size_t{to}];
      lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
    }
    return rope;
  }

  /// The triangles of a panel in the result, with the places of their corners in meshes.
  Part panel_of(std::uint32_t part) const {
    Part panel;
    std::vector<double>&u = panel.data["u"], &v = panel.data["v"];
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      const auto& corners = result_.mesh.corners[t];
      const bool has_places =
          std::all_of(corners.begin(), corners.end(), [](double c) { return std::isfinite(c); });
      if (result_.mesh.cell_part[result_.mesh.triangle_cells[t]] != part || !has_places) continue;
      panel.nodes.insert(panel.nodes.end(), result_.mesh.triangles[t].begin(),
                         result_.mesh.triangles[t].end());
      for (std::size_t c = 0; c < 3; ++c) u.push_back(corners[2 * c]), v.push_back(corners[2 * c + 1]);
    }
    return panel;
  }

  /// All nodes of a panel of the scene as corners of triangles, the last ones more than once to fill them up.
  static Part places_of(const PartGeometry& geometry) {
    Part panel;
    std::vector<double>&u = panel.data["u"], &v = panel.data["v"];
    for (std::size_t own = 0; own < (geometry.nodes.size() + 2) / 3 * 3; ++own) {
      const std::size_t n = std::min(own, geometry.nodes.size() - 1);
      panel.nodes.push_back(geometry.nodes[n]);
      u.push_back(geometry.panel[n][0]), v.push_back(geometry.panel[n][1]);
    }
    return panel;
  }

  const StoredResult& result_;
  const LoadedScene& loaded_;
  std::vector<double> x_, positions_;
};

}  // namespace

std::vector<double> positions_from(const StoredResult& result, const LoadedScene& loaded) {
  return Carrier(result, loaded).carry();
}

}  // namespace netloft::io
