// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "io/hdf5/read.hpp"
#include "io/hdf5/result_file.hpp"

namespace netloft::io {

/// A column of the series: one number per state, under /netloft/series/<name>.
struct SeriesColumn {
  std::string name, unit, doc;
};

/// One output of a motion.
struct SeriesState {
  double time = 0;
  std::vector<double> points;               // 3n [m]
  std::vector<std::vector<double>> fields;  // in the order of `changing`
  std::vector<double> row;                  // in the order of the columns
};

/// A result with many states that no kill can harm. HDF5 promises nothing of a file while it writes, so there
/// are two copies, and the name NAME.hdf.part is always that of one that is whole:
///
///   write the state into the twin | the two exchange names, in one instant | write it into the other
///
/// After a kill at any moment, NAME.hdf.part opens and holds every state whose `write` has returned. Where
/// the file system cannot exchange names (Linux's can), there is one copy, with what VtkHdf promises of it.
class SeriesFile {
 public:
  /// The description of the file, with which every copy begins.
  struct Layout {
    Mesh mesh;
    std::vector<FieldSpec> changing;
    std::vector<StaticField> fixed;
    std::vector<SeriesColumn> columns;
  };

  /// `killed` is a .part to continue, whose first `states` states are copied first; it keeps its name until
  /// all of them are in the new file.
  SeriesFile(std::filesystem::path final_path, Layout layout, const Reader* killed = nullptr,
             std::size_t states = 0);

  /// `extra` writes the data that belong to the state (the point from which to continue) into each copy.
  void write(const SeriesState& state, const std::function<void(Tree&)>& extra);

  /// Writes the rest into the remaining copy and gives it its final name.
  void finish(const std::function<void(Tree&)>& rest);
  const std::filesystem::path& final_path() const { return final_; }

 private:
  std::unique_ptr<ResultFile> make(const std::filesystem::path& part) const;
  void write_into(ResultFile& file, const SeriesState& state, const std::function<void(Tree&)>& extra) const;
  void copy(const Reader& from, std::size_t states, ResultFile& to) const;

  std::filesystem::path final_, part_, twin_part_;
  Layout layout_;
  // front_ has the name; twin_ is empty if names cannot be exchanged
  std::unique_ptr<ResultFile> front_, twin_;
};

/// Reads a state of a series from the disk.
SeriesState read_state(const Reader& reader, const SeriesFile::Layout& layout, std::size_t i);

}  // namespace netloft::io
