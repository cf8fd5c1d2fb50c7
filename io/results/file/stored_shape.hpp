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

/// A part as the file describes it; NaN marks numbers that it does not have, or that the file is too old to
/// have.
struct StoredPart {
  std::string name, type;
  double diameter = 0, bar = 0;        // of twine, rope or float; of a bar of the meshes [m]
  std::array<double, 4> twine_axes{};  // a, b, c, d: u = a U + b V, v = c U + d V
  scenes::SheetPlace sheet;            // on the plan
  // its single nodes are where it touches something, such as a bed, not things to look at
  bool is_contact = false;
};

/// Triangles, bars and single nodes of a result, each with its part and its cell in the file.
struct StoredMesh {
  std::size_t n_points = 0, n_cells = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> bars;
  std::vector<std::uint32_t> dots;
  std::vector<std::uint32_t> triangle_cells, bar_cells, dot_cells;
  std::vector<std::uint32_t> cell_part;        // by cell
  std::vector<std::array<double, 6>> corners;  // U, V of the corners, by triangle; NaN where unknown
  std::vector<std::uint32_t> node_part,
      node_number;  // by node: the part it was made for, and its number there
};

/// The kind of a cell: netting, a bar of a rope, or an element on a single node.
enum class CellKind : std::uint8_t { netting, rope, point };
inline constexpr std::size_t kCellKinds = 3;

/// A field that can be drawn: one number per cell.
struct StoredField {
  std::string name;
  std::array<std::string, kCellKinds> units;  // by kind of cell
  std::string doc;
  // A total over a cell, which is the larger the larger the cell: nothing to colour by.
  bool is_total = false;

  const std::string& unit(CellKind kind) const { return units[static_cast<std::size_t>(kind)]; }
};

/// The bed: a plane z = -depth + slope_x x + slope_y y, and a relief over it where there is one.
struct StoredBed {
  double depth = 0, slope_x = 0, slope_y = 0;
  std::vector<double> relief_x = {}, relief_y = {}, relief = {};  // places, heights [x][y] [m]

  /// z at a place, straight between the heights of the relief and as at its edges beyond them.
  double height(double x, double y) const;
  bool is_plane() const { return relief.empty(); }
};

/// A rigid body, such as an otter board. How it is turned is the field `rotation` at its origin.
struct StoredBody {
  std::string name;
  std::uint32_t origin = 0;  // node
  bool is_to_port = false;
  std::vector<std::array<double, 3>> outline;  // corners of its shape in its own axes [m]
};

/// A quantity over the outputs of a motion.
struct StoredSeries {
  std::string name, unit;
  std::vector<double> values;
};

/// The shapes of a result in its file (io/formats/hdf5/LAYOUT.md): parts and mesh, and positions and fields
/// of every state, which are read when they are called for.
class StoredShape {
 public:
  /// Throws FileError with a sentence like read_result(), and if the file holds no shape.
  explicit StoredShape(const std::filesystem::path& path);

  Result result;
  std::vector<StoredPart> parts;
  StoredMesh mesh;
  std::vector<StoredBody> bodies;
  std::vector<double> times;
  std::vector<std::string> stages;  // what each state of a solve is; empty: not kept
  std::vector<StoredField> fields;
  std::optional<StoredBed> bed;
  std::vector<StoredSeries> series;

  std::vector<double> points(std::size_t state) const;
  /// A field by its name in `fields`, by cell; NaN where a cell has none.
  std::vector<double> field(const std::string& name, std::size_t state) const;
  /// A field on the nodes, three numbers each; empty if the file has none of that name.
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
  std::vector<std::string> strings_or_nothing(const std::string& path) const;
  std::vector<double> reals_or_nothing(const std::string& path) const;

  std::filesystem::path path_;
  formats::Reader reader_;
};

/// The number of the part of this name, if there is one.
std::optional<std::uint32_t> find_part(const StoredShape& shape, const std::string& name);

}  // namespace netloft::results
