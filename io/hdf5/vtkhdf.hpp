// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/hdf5/handle.hpp"

namespace netloft::io {

/// VTK's numbers of the cell shapes used for gears.
enum CellType : std::uint8_t { kVertex = 1, kLine = 3, kTriangle = 5 };

/// Cells over nodes 0 … n_points-1; cell c has the nodes connectivity[offsets[c]] …
/// connectivity[offsets[c+1]-1].
struct Mesh {
  std::size_t n_points = 0;
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets = {0};  // one more than there are cells
  std::vector<std::uint8_t> types;          // CellType of each cell

  std::size_t n_cells() const { return types.size(); }
};

enum class Location { kPoint, kCell };

/// An array over the points or cells. Several components are stored point by point (x₀ y₀ z₀ x₁ …).
struct FieldSpec {
  std::string name;  // as ParaView shows it; without '/'
  std::string unit;  // "1" when dimensionless
  std::string doc;
  Location location = Location::kPoint;
  std::size_t components = 1;
  bool is_integer = false;  // stored as int64, although values are passed as double
};

/// A field that is the same at all times, stored once.
struct StaticField {
  FieldSpec spec;
  std::vector<double> values;
};

/// The /VTKHDF group: one unstructured grid whose points and fields change in time (VTKHDF 2.0).
///
/// Each changing array holds states in slots of equal length. With S states, i = 0 … S-1 in order of time,
///   slot(i) = i + 1 for i < S-1,   slot(S-1) = 0                          (1)
/// so that the newest is what a reader without time (ParaView ≤ 5.11) shows. HDF5 promises no order among the
/// writes between two flushes, so a new state takes four of them; a kill in between costs no earlier state:
///   copy slot 0 behind | point Steps at the copy | overwrite slot 0, which nothing refers to any more |
///   count it
class VtkHdf {
 public:
  VtkHdf(hid_t file, const Mesh& mesh, std::vector<FieldSpec> changing, std::span<const StaticField> fixed);

  std::size_t n_states() const { return n_states_; }
  /// `points` 3n [m]; `fields` in the order of `changing`. On disk, and safe from a kill, when this returns.
  void write_state(double time, std::span<const double> points,
                   std::span<const std::span<const double>> fields);

 private:
  /// A dataset of slots; rows of `columns` numbers.
  struct SlotArray {
    std::string name;
    std::size_t rows;
    std::size_t columns;
    Handle dataset;

    std::size_t size() const { return rows * columns; }
    void write(std::size_t slot, const double* values);
    void copy(std::size_t from, std::size_t to);
    Handle select(std::size_t slot) const;
  };
  /// One entry per time step in /VTKHDF/Steps; the entry that points at slot k is first + stride·k.
  struct StepColumn {
    std::int64_t first;
    std::int64_t stride;
    Handle dataset;

    void write(std::size_t step, std::size_t slot);
  };

  void write_topology(const Mesh& mesh);
  void add_slot_array(hid_t group, const FieldSpec& spec, std::size_t rows);
  void add_static_array(hid_t group, const StaticField& field, std::size_t rows);
  void add_step_column(const std::string& path, std::int64_t first, std::int64_t stride, bool by_topology);
  void make_steps(std::span<const StaticField> fixed);
  void require_sizes(std::span<const double> points, std::span<const std::span<const double>> fields) const;
  void write_newest(double time, std::span<const double> points,
                    std::span<const std::span<const double>> fields);
  void flush();
  void point_step_at(std::size_t step, std::size_t slot);

  Handle root_;
  Handle steps_;
  std::size_t n_points_;
  std::size_t n_cells_;
  std::size_t n_states_ = 0;
  std::vector<FieldSpec> changing_;
  std::vector<SlotArray> arrays_;  // points, then the changing fields
  std::vector<StepColumn> columns_;
  Handle times_;
};

}  // namespace netloft::io
