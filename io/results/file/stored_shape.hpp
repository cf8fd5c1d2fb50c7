// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/read.hpp"
#include "io/results/figures/result.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace netloft::results {

/// A part of the scene, as a result file describes it. A number is NaN if the part has no such number, or if
/// an old file lacks it.
struct StoredPart {
  std::string name, type;
  double diameter = 0, bar = 0;  // diameter of twine, rope or float; length of a mesh bar [m]
  // a, b, c, d: the twine coordinates are u = a U + b V, v = c U + d V, from the panel coordinates U, V.
  std::array<double, 4> twine_axes{};
  scenes::SheetPlace sheet;  // place on the drawing of the net plan
  // Whether the part models contact, with a bed for example. Its elements on single nodes are then not drawn.
  bool is_contact = false;
};

/// Triangles, bars and elements on single nodes (dots) of a result. Each of them has its part and its cell in
/// the file.
struct StoredMesh {
  std::size_t n_points = 0, n_cells = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> bars;
  std::vector<std::uint32_t> dots;
  std::vector<std::uint32_t> triangle_cells, bar_cells, dot_cells;
  std::vector<std::uint32_t> cell_part;  // part of each cell
  // Panel coordinates U, V of the corners of each triangle; NaN where unknown.
  std::vector<std::array<double, 6>> corners;
  // The part of each node, and its number within that part.
  std::vector<std::uint32_t> node_part, node_number;
};

/// The kind of a cell: netting, a bar of a rope, or an element on a single node.
enum class CellKind : std::uint8_t { netting, rope, point };
inline constexpr std::size_t kCellKinds = 3;

/// A field that can be drawn: one number per cell.
struct StoredField {
  std::string name;
  std::array<std::string, kCellKinds> units;  // one unit for each kind of cell
  std::string doc;
  // Whether the value is a total over a cell, such as a mass. Colours of such a field would mainly show the
  // size of the cells.
  bool is_total = false;

  const std::string& unit(CellKind kind) const { return units[static_cast<std::size_t>(kind)]; }
};

/// The bed: a plane z = -depth + slope_x x + slope_y y, plus the height of a relief if there is one.
struct StoredBed {
  double depth = 0, slope_x = 0, slope_y = 0;
  std::vector<double> relief_x = {}, relief_y = {}, relief = {};  // grid coordinates, heights at [x][y] [m]

  /// Height z of the bed at a place. The relief is interpolated linearly, and constant beyond its edges.
  double height(double x, double y) const;
  bool is_plane() const { return relief.empty(); }
};

/// A rigid body, such as an otter board. The field `rotation` at its origin gives its orientation.
struct StoredBody {
  std::string name;
  std::uint32_t origin = 0;  // node at the origin
  bool is_to_port = false;
  std::vector<std::array<double, 3>> outline;  // corners of the body in its own axes [m]
};

/// A quantity over time: one value for each output of a motion.
struct StoredSeries {
  std::string name, unit;
  std::vector<double> values;
};

/// A result with its shapes. Parts and mesh are in memory; the positions and fields of a state are read from
/// the file on request (io/formats/hdf5/LAYOUT.md).
class StoredShape {
 public:
  /// Throws FileError, with a sentence, for the reasons of read_result(), and if the file does not contain a
  /// shape.
  explicit StoredShape(const std::filesystem::path& path);

  Result result;
  std::vector<StoredPart> parts;
  StoredMesh mesh;
  std::vector<StoredBody> bodies;
  std::vector<double> times;
  // The name of each state: the start, the end of a stage, the result. Empty if there is only the result.
  std::vector<std::string> stages;
  std::vector<StoredField> fields;
  std::optional<StoredBed> bed;
  std::vector<StoredSeries> series;

  std::vector<double> points(std::size_t state) const;
  /// A field by its name in `fields`, one number per cell; NaN for a cell without a value.
  std::vector<double> field(const std::string& name, std::size_t state) const;
  /// A field on the nodes, three numbers each; empty if the file has no field of that name.
  std::vector<double> node_field(const std::string& name, std::size_t state) const;

 private:
  std::vector<double> opening(std::size_t state) const;
  std::vector<double> tension(std::size_t state) const;
  std::vector<double> water_force(std::size_t state) const;
  void read_parts();
  void read_mesh();
  void read_cells();
  void read_bodies();
  void read_fields();
  void find_contacts();
  void read_bed();
  void read_relief();
  void read_series(const std::string& below = "");
  std::vector<double> whole(std::vector<double> values, std::size_t count, const std::string& what) const;
  double known(const std::string& path) const;
  std::vector<std::string> names_or_nothing(const std::string& path) const;
  std::vector<double> reals_or_nothing(const std::string& path) const;

  std::filesystem::path path_;
  formats::Reader reader_;
};

/// The index of the part with this name; nullopt if there is none.
std::optional<std::uint32_t> find_part(const StoredShape& shape, const std::string& name);

}  // namespace netloft::results
