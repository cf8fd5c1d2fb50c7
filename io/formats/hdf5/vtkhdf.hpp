// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

/// VTK's numbers for the cell shapes that gears use.
enum CellType : std::uint8_t { kVertex = 1, kLine = 3, kTriangle = 5 };

/// Cells over nodes 0 … n_points-1; cell c has the nodes connectivity[offsets[c]] …
/// connectivity[offsets[c+1]-1].
struct Mesh {
  std::size_t n_points = 0;
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets = {0};  // one more entry than cells
  std::vector<std::uint8_t> types;          // CellType of each cell

  std::size_t n_cells() const { return types.size(); }
};

enum class Location { kPoint, kCell };

/// The description of an array over points or cells. Several components are stored point by point (x₀ y₀ z₀
/// x₁ …).
struct FieldSpec {
  std::string name;  // name in ParaView; without '/'
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
/// Each changing array consists of slots of equal length. A state whose field equals that of the state before
/// has no slot: it uses the slot of the state before. The S other states, i = 0 … S-1 in order of time, have
/// the slots
///   slot(i) = i + 1 for i < S-1,   slot(S-1) = 0                          (1)
/// The newest of the S states is first, so that a reader without support for time (ParaView ≤ 5.11) shows
/// this state.
class VtkHdf {
 public:
  /// `stored`: for each changing field, which states have their own slot; empty: all states.
  VtkHdf(hid_t file, const Mesh& mesh, std::vector<FieldSpec> changing, std::span<const StaticField> fixed,
         std::size_t states, std::span<const std::vector<bool>> stored = {});

  std::size_t n_states() const { return times_.size(); }
  /// Adds a state. `points` has 3n numbers [m]; `fields` has the order of `changing`; a field for which the
  /// state has no slot is empty.
  void write_state(double time, std::span<const double> points,
                   std::span<const std::span<const double>> fields);
  /// Writes the states that are still in memory.
  void write_blocks();
  /// Calls write_blocks() and writes the times. Throws std::invalid_argument unless as many states were
  /// written as announced.
  void finish();

 private:
  /// A dataset of slots; its rows have `columns` numbers. One call writes a block of consecutive slots,
  /// because HDF5 first reads the surrounding bytes if less than 64 kB are written.
  struct SlotArray {
    std::string name;
    std::size_t rows;
    std::size_t columns;
    const std::vector<bool>* stored;  // whether each state has a slot of its own; nullptr: all states
    std::size_t slots;
    Handle dataset;
    std::vector<double> block = {};
    std::size_t first = 0;  // first slot of the block
    std::size_t added = 0;

    std::size_t size() const { return rows * columns; }
    bool has(std::size_t state) const { return !stored || state == 0 || (*stored)[state]; }
    std::size_t slot_of(std::size_t i) const { return i + 1 < slots ? i + 1 : 0; }  // (1)
    void add(std::span<const double> values);
    void write_block();
  };

  void write_topology(const Mesh& mesh);
  void add_slot_array(hid_t group, const FieldSpec& spec, std::size_t rows, const std::vector<bool>* stored);
  void add_static_array(hid_t group, const StaticField& field, std::size_t rows);
  void write_steps(std::span<const StaticField> fixed);
  void write_step_column(const std::string& path, std::span<const std::int64_t> values, bool by_topology);
  std::vector<std::int64_t> offsets_of(const SlotArray& array) const;
  void require_sizes(std::span<const double> points, std::span<const std::span<const double>> fields) const;

  Handle root_;
  Handle steps_;
  std::size_t n_points_;
  std::size_t n_cells_;
  std::size_t states_;
  std::vector<FieldSpec> changing_;
  std::vector<std::vector<bool>> stored_;
  std::vector<SlotArray> arrays_;  // points, then the changing fields
  std::vector<double> times_;      // times of the states so far
};

}  // namespace netloft::formats
