// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "io/formats/hdf5/part_file.hpp"
#include "io/formats/hdf5/tree.hpp"
#include "io/formats/hdf5/vtkhdf.hpp"

namespace netloft::formats {

inline constexpr int kResultFormat = 1;  // increases when readers of /netloft must change

/// The result of one run: the data for ParaView under /VTKHDF, everything else under /netloft (LAYOUT.md).
///
///   ResultFile file("codend.hdf");                 // creates codend.hdf.part
///   file.begin(mesh, {tension}, {part, node_id});
///   file.write_state(0.0, points, {tensions});
///   file.tree().write_text("/netloft/provenance/scene/text", scene);
///   file.finish();                                 // codend.hdf; an earlier result becomes codend.hdf~
///
/// Throws FileError for errors of the disk or the user, std::invalid_argument for errors of the caller.
class ResultFile {
 public:
  explicit ResultFile(std::filesystem::path final_path);
  /// Uses `part_path` for the growing file instead of NAME.hdf.part.
  ResultFile(std::filesystem::path final_path, std::filesystem::path part_path);

  /// Begins the grid; must be called once, before the first state. `states` is the number of states to come.
  void begin(const Mesh& mesh, std::vector<FieldSpec> changing, std::span<const StaticField> fixed = {},
             std::size_t states = 1);
  void begin(const Mesh& mesh, std::vector<FieldSpec> changing, std::initializer_list<StaticField> fixed,
             std::size_t states = 1) {
    begin(mesh, std::move(changing), std::span<const StaticField>(fixed.begin(), fixed.size()), states);
  }

  /// Writes the next state. `points` has 3n numbers [m]; `fields` has the order of `changing`.
  void write_state(double time, std::span<const double> points,
                   std::span<const std::span<const double>> fields);
  void write_state(double time, std::span<const double> points,
                   std::initializer_list<std::span<const double>> fields) {
    write_state(time, points, std::span<const std::span<const double>>(fields.begin(), fields.size()));
  }
  std::size_t n_states() const { return grid_ ? grid_->n_states() : 0; }

  /// Access to everything except the grid; written to the disk at the next flush().
  Tree& tree() { return tree_; }
  void flush();

  /// Flushes, closes, and gives the file its final name; nothing can be written afterwards.
  void finish();
  void finish_as(std::filesystem::path final_path);
  /// Removes the growing file if it has no useful content.
  void discard() { part_.discard(); }

  /// The file under its growing and its final name.
  PartFile& part() { return part_; }
  const std::filesystem::path& part_path() const { return part_.part_path(); }
  const std::filesystem::path& final_path() const { return part_.final_path(); }

 private:
  void finish_grid();

  PartFile part_;
  Tree tree_;
  std::optional<VtkHdf> grid_;
};

/// Writes the first data of every result: the format number, and the status of the run.
void begin_result(Tree& tree, std::string_view outcome, std::string_view sentence);

}  // namespace netloft::formats
