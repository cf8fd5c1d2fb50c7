// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/result_mesh.hpp"

#include "framework/registry/element_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace netloft::results {

namespace {

/// Makes the mesh of a state. The member functions are the steps, in the order of execution.
class ResultMesh {
 public:
  ResultMesh(const StoredShape& stored, std::size_t state)
      : stored_(stored),
        strain_(field(output::kStrain.name, state)),
        twine_area_(field(output::kTwineArea.name, state)) {
    mesh_.positions = stored.points(state);
  }

  std::string text(MeshFormat format) {
    for (std::uint32_t part = 0; part < stored_.parts.size(); ++part) {
      add_triangles(part);
      add_bars(part);
    }
    if (mesh_.regions.empty())
      throw std::invalid_argument("there are neither ropes nor panels of triangles, so there is no mesh");
    if (format == MeshFormat::obj) return formats::obj_text(mesh_, comment_);
    return format == MeshFormat::vtk ? formats::vtk_text(mesh_, comment_)
                                     : formats::mesh_text(mesh_, comment_);
  }

 private:
  /// The field `name` by cell; NaN everywhere if the file does not have it.
  std::vector<double> field(const std::string& name, std::size_t state) const {
    const bool is_there = std::any_of(stored_.fields.begin(), stored_.fields.end(),
                                      [&](const auto& f) { return f.name == name; });
    if (is_there) return stored_.field(name, state);
    return std::vector<double>(stored_.mesh.n_cells, std::nan(""));
  }

  std::string name_of_part(std::uint32_t part) const {
    std::string name = stored_.parts[part].name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t' || c == '#' || c == ']'; }, '-');
    return name;
  }

  void add_triangles(std::uint32_t part) {
    formats::MeshRegion region{formats::RegionKind::triangles, name_of_part(part)};
    std::size_t left_out = 0;
    for (std::size_t t = 0; t < stored_.mesh.triangles.size(); ++t) {
      if (stored_.mesh.cell_part[stored_.mesh.triangle_cells[t]] != part) continue;
      const auto& nodes = stored_.mesh.triangles[t];
      const auto& UV = stored_.mesh.corners[t];
      if (std::any_of(UV.begin(), UV.end(), [](double x) { return !std::isfinite(x); }) || has_twins(nodes)) {
        ++left_out;
        continue;
      }
      region.nodes.insert(region.nodes.end(), nodes.begin(), nodes.end());
      region.numbers.insert(region.numbers.end(), UV.begin(), UV.end());
    }
    if (left_out)
      say(fmt::format("{}: {} triangles without a place on a panel are left out", region.name, left_out));
    if (region.size()) mesh_.regions.push_back(std::move(region));
  }

  static bool has_twins(const std::array<std::uint32_t, 3>& n) {
    return n[0] == n[1] || n[1] == n[2] || n[0] == n[2];
  }

  /// Adds the bars of a rope in their order, with the fraction of the unstretched rope at each end of a bar.
  void add_bars(std::uint32_t part) {
    formats::MeshRegion region{formats::RegionKind::bars, name_of_part(part)};
    std::vector<double> ends{0};
    for (std::size_t b = 0; b < stored_.mesh.bars.size(); ++b) {
      const auto cell = stored_.mesh.bar_cells[b];
      if (stored_.mesh.cell_part[cell] != part || !std::isfinite(strain_[cell])) continue;
      if (std::isfinite(twine_area_[cell])) return say(region.name + ": bars of several twines are left out");
      const auto& nodes = stored_.mesh.bars[b];
      region.nodes.insert(region.nodes.end(), nodes.begin(), nodes.end());
      ends.push_back(ends.back() + distance(nodes[0], nodes[1]) / (1 + strain_[cell]));
    }
    if (region.size() == 0) return;
    const double length = ends.back();
    for (std::size_t e = 0; e < region.size(); ++e) {
      region.numbers.push_back(ends[e] / length);
      region.numbers.push_back(ends[e + 1] / length);
    }
    say(fmt::format("{}: length = {:.12g}", region.name, length));
    mesh_.regions.push_back(std::move(region));
  }

  double distance(std::uint32_t a, std::uint32_t b) const {
    const double *x = &mesh_.positions[3 * std::size_t{a}], *y = &mesh_.positions[3 * std::size_t{b}];
    return std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
  }

  void say(const std::string& text) { comment_ += (comment_.empty() ? "" : "\n") + text; }

  const StoredShape& stored_;
  std::vector<double> strain_, twine_area_;  // strain and twine area of each cell
  formats::InputMesh mesh_;
  std::string comment_;
};

}  // namespace

std::string mesh_of(const StoredShape& stored, std::size_t state, MeshFormat format) {
  return ResultMesh(stored, state).text(format);
}

}  // namespace netloft::results
