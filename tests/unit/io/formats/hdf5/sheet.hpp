// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "io/formats/hdf5/result_file.hpp"

namespace netloft::formats::test {

/// A square sheet of triangles, a rope of lines from its last corner, and a float at the end of the rope.
struct Sheet {
  std::int64_t cells = 12;  // along each side
  std::int64_t bars = 10;   // in the rope

  std::int64_t n_sheet() const { return (cells + 1) * (cells + 1); }
  Mesh mesh() const;
  /// The sheet hangs deeper and the rope sags more as `time` goes from 0 to 1.
  std::vector<double> points(double time) const;
  std::vector<double> heights(double time) const;
  std::vector<double> strains(double time) const;  // per cell
  std::vector<double> parts() const;               // 0 sheet, 1 rope
};

inline void add_cell(Mesh& mesh, CellType type, std::initializer_list<std::int64_t> nodes) {
  mesh.connectivity.insert(mesh.connectivity.end(), nodes);
  mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  mesh.types.push_back(type);
}

inline Mesh Sheet::mesh() const {
  Mesh mesh;
  mesh.n_points = static_cast<std::size_t>(n_sheet() + bars);
  const auto id = [&](std::int64_t i, std::int64_t j) { return j * (cells + 1) + i; };
  for (std::int64_t j = 0; j < cells; ++j) {
    for (std::int64_t i = 0; i < cells; ++i) {
      add_cell(mesh, kTriangle, {id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      add_cell(mesh, kTriangle, {id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  for (std::int64_t k = 0; k < bars; ++k) add_cell(mesh, kLine, {n_sheet() + k - 1, n_sheet() + k});
  add_cell(mesh, kVertex, {n_sheet() + bars - 1});
  return mesh;
}

inline std::vector<double> Sheet::points(double time) const {
  std::vector<double> x;
  const double n = static_cast<double>(cells);
  for (std::int64_t j = 0; j <= cells; ++j) {
    for (std::int64_t i = 0; i <= cells; ++i) {
      const double u = static_cast<double>(i) / n;
      const double v = static_cast<double>(j) / n;
      x.insert(x.end(), {10 * u, 10 * v, -4 * time * (std::sin(M_PI * u) + 0.5 * std::sin(2 * M_PI * v))});
    }
  }
  for (std::int64_t k = 1; k <= bars; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(bars);
    x.insert(x.end(), {10 + 8 * s, 10.0, 3 * s - 4 * time * s * (1 - s)});
  }
  return x;
}

inline std::vector<double> Sheet::heights(double time) const {
  const std::vector<double> x = points(time);
  std::vector<double> z;
  for (std::size_t i = 2; i < x.size(); i += 3) z.push_back(x[i]);
  return z;
}

inline std::vector<double> Sheet::strains(double time) const {
  std::vector<double> strain(mesh().n_cells());
  for (std::size_t c = 0; c < strain.size(); ++c) strain[c] = time * static_cast<double>(c);
  return strain;
}

inline std::vector<double> Sheet::parts() const {
  std::vector<double> part(static_cast<std::size_t>(n_sheet()), 0.0);
  part.insert(part.end(), static_cast<std::size_t>(bars), 1.0);
  return part;
}

inline FieldSpec height_spec() { return {"height", "m", "Height of the node", Location::kPoint, 1}; }
inline FieldSpec strain_spec() { return {"strain", "1", "Grows along the cells", Location::kCell, 1}; }
inline FieldSpec velocity_spec() { return {"velocity", "m/s", "Speed of the node", Location::kPoint, 3}; }
inline StaticField part_field(const Sheet& sheet) {
  return {{"part", "1", "Part the node belongs to", Location::kPoint, 1, true}, sheet.parts()};
}

inline void begin(ResultFile& file, const Sheet& sheet, std::size_t states = 1) {
  file.begin(sheet.mesh(), {height_spec(), velocity_spec(), strain_spec()}, {part_field(sheet)}, states);
}

/// The velocity is the position, so that readers can distinguish the components.
inline void write_state(ResultFile& file, const Sheet& sheet, double time) {
  const std::vector<double> x = sheet.points(time);
  file.write_state(time, x, {sheet.heights(time), x, sheet.strains(time)});
}

}  // namespace netloft::formats::test
