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

  SeriesFile(std::filesystem::path final_path, Layout layout);

  /// A .part to continue: its first `states` states are copied first, and `extra` belongs to the last of
  /// them.
  struct Killed {
    const Reader& reader;
    std::size_t states;
    std::function<void(Tree&)> extra;
  };
  /// The killed file and its twin are not touched before a third copy is whole and on the disk. When that
  /// fails, they are as they were.
  SeriesFile(std::filesystem::path final_path, Layout layout, const Killed& killed);

  /// `extra` writes the data that belong to the state (the point from which to continue) into each copy.
  void write(const SeriesState& state, const std::function<void(Tree&)>& extra);

  /// Writes the rest into the twin, gives that its final name, and removes the other copy: until then
  /// NAME.hdf.part is whole. `as` is another final name than that of the constructor; empty for that one.
  void finish(const std::function<void(Tree&)>& rest, const std::filesystem::path& as = {});
  const std::filesystem::path& final_path() const { return final_; }

 private:
  std::unique_ptr<ResultFile> make(const std::filesystem::path& part) const;
  void write_into(ResultFile& file, const SeriesState& state, const std::function<void(Tree&)>& extra) const;
  void copy(const Killed& killed, ResultFile& to) const;
  void write_views(ResultFile& file) const;

  std::filesystem::path final_, part_, twin_part_;
  Layout layout_;
  // front_ has the name; twin_ is empty if names cannot be exchanged
  std::unique_ptr<ResultFile> front_, twin_;
};

/// Reads a state of a series from the disk.
SeriesState read_state(const Reader& reader, const SeriesFile::Layout& layout, std::size_t i);

}  // namespace netloft::io
