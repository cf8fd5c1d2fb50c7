// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/read.hpp"
#include "io/results/figures/run_result.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace netloft::results {

/// A part as the file describes it; NaN marks what it has not, or what the file is too old to say.
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

/// What a cell is: netting, a bar of a rope, or what sits on a single node.
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

/// The accepted steps of a solve.
struct StoredConvergence {
  std::vector<std::int64_t> iteration, factorisations;
  std::vector<double> residual, load;
  std::vector<std::string> note;
};

/// All that a report says beside the numbers of the parts.
struct StoredOrigins {
  std::string version, machine, compiler, started, finished;
  std::vector<std::string> command;
  std::vector<std::pair<std::string, std::string>> files;  // path, text; the first is the scene
  std::string plan;
};

/// A result file, read (io/formats/hdf5/LAYOUT.md). States and fields are read when they are asked for.
class StoredResult {
 public:
  /// Throws FileError with a sentence if the file cannot be read, is not a result of this program, or was
  /// written in a newer format.
  explicit StoredResult(const std::filesystem::path& path);

  std::filesystem::path path;
  std::string outcome, sentence, stability;  // outcome is empty: the run has not ended
  bool is_half = false, is_motion = false;
  std::string headline, footrope;  // ropes of a gear; empty: not known
  std::vector<std::string> notes;  // what the file is too old to say
  std::vector<StoredPart> parts;
  StoredMesh mesh;
  std::vector<StoredBody> bodies;
  std::vector<double> times;
  std::vector<std::string> stages;  // what each state of a solve is; empty: not kept
  std::vector<StoredField> fields;
  std::vector<NamedScalar> figures, scalars;
  std::vector<PartForce> part_forces;
  std::vector<HoldForce> hold_forces;
  std::array<double, 3> balance{};
  std::string mesh_note;
  std::string swings_most;  // of what grows: the node that moves furthest
  double node_error = 0;    // largest nodal move of the next Newton step [m]; NaN: not known
  std::optional<StoredBed> bed;
  std::vector<scenes::BillItem> bill;
  std::vector<StoredSeries> series;
  StoredConvergence convergence;
  StoredOrigins origins;
  std::map<std::string, NamedScalar> cost;

  /// The name of the scene: that of the scene file without its ending, or of the result.
  std::string title() const;
  bool is_answer() const { return outcome == "converged" || outcome == "finished"; }
  std::vector<double> points(std::size_t state) const;
  /// A field by its name in `fields`, by cell; NaN where a cell has none.
  std::vector<double> field(const std::string& name, std::size_t state) const;
  /// A field on the nodes, three numbers each; empty if the file has none of that name.
  std::vector<double> node_field(const std::string& name, std::size_t state) const;

 private:
  void check_format() const;
  std::vector<double> opening(std::size_t state) const;
  std::vector<double> tension(std::size_t state) const;
  std::vector<double> water_force(std::size_t state) const;
  void read_status();
  void read_parts();
  void read_mesh();
  void read_cells();
  void read_bodies();
  void read_fields();
  void find_contacts();
  void read_scalars(const std::string& group, const std::string& errors, std::vector<NamedScalar>& into,
                    const std::string& below = "");
  void put_in_order(const std::string& group, std::vector<NamedScalar>& named) const;
  void read_forces();
  void read_surroundings();
  void read_relief();
  void read_series(const std::string& below = "");
  std::vector<double> whole(std::vector<double> values, std::size_t count, const std::string& what) const;
  void read_convergence();
  void read_origins();
  double known(const std::string& path) const;
  std::string text_or_nothing(const std::string& path) const;
  std::vector<std::string> strings_or_nothing(const std::string& path) const;
  std::vector<double> reals_or_nothing(const std::string& path) const;

  formats::Reader reader_;
};

/// The number of the part of this name, if there is one.
std::optional<std::uint32_t> find_part(const StoredResult& result, const std::string& name);

}  // namespace netloft::results
