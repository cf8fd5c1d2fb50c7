// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/fold.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "io/formats/hdf5/open.hpp"
#include "io/formats/hdf5/result_file.hpp"
#include "io/formats/work/long_work.hpp"

namespace netloft::formats {
namespace {

const std::string kRoot = "/netloft";
/// The numbers of the time series: one row per output, one column per series.
struct Rows {
  std::size_t columns;
  std::vector<double> values;

  std::vector<double> column(std::size_t k) const {
    std::vector<double> numbers;
    for (std::size_t i = k; i < values.size(); i += columns) numbers.push_back(values[i]);
    return numbers;
  }
};

void write_columns(Tree& tree, const std::vector<SeriesColumn>& columns, const Rows& rows) {
  for (std::size_t k = 0; k < columns.size(); ++k)
    tree.write_reals(kRoot + "/series/" + columns[k].name, rows.column(k), columns[k].unit, columns[k].doc);
}

/// The cells in the notation of XDMF for cells of several kinds. Each cell has its type, the number of its
/// nodes (unless the type implies it), and its nodes.
std::vector<std::int64_t> mixed_cells(const Mesh& mesh) {
  constexpr std::int64_t kPolyvertex = 1, kPolyline = 2, kXdmfTriangle = 4;
  std::vector<std::int64_t> mixed;
  for (std::size_t c = 0; c < mesh.n_cells(); ++c) {
    const auto first = mesh.connectivity.begin() + mesh.offsets[c],
               last = mesh.connectivity.begin() + mesh.offsets[c + 1];
    if (const auto nodes = last - first; nodes == 3)
      mixed.push_back(kXdmfTriangle);
    else
      mixed.insert(mixed.end(), {nodes == 1 ? kPolyvertex : kPolyline, nodes});
    mixed.insert(mixed.end(), first, last);
  }
  return mixed;
}

/// Writes the numbers of the last output to the paths at which a finished motion has its results.
void write_last_row(Tree& tree, const SeriesJournal& journal) {
  if (journal.size() == 0) return;
  const std::vector<double> row = journal.stored_state(journal.size() - 1).row;
  const auto& columns = journal.layout().columns;
  for (std::size_t k = 0; k < columns.size() && k < row.size(); ++k) {
    const std::string& name = columns[k].name;
    if (name.starts_with("gear/"))
      tree.write_real(kRoot + "/" + name, row[k], columns[k].unit, columns[k].doc);
    else if (name.find('/') == std::string::npos && name != "forces_time")
      tree.write_real(kRoot + "/scalars/" + name, row[k], columns[k].unit, columns[k].doc);
  }
}

void copy_origins(const std::string& image, hid_t file) {
  if (image.empty()) return;
  const Handle origins = open_image(image);
  const Handle group(H5Gopen2(origins, kRoot.c_str(), H5P_DEFAULT), H5Gclose);
  std::vector<std::string> names;
  const auto append_name = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &names));
  const Handle to(H5Gopen2(file, kRoot.c_str(), H5P_DEFAULT), H5Gclose);
  for (const auto& name : names)
    check(H5Ocopy(group, name.c_str(), to, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
}

/// Creates an HDF5 file that is deleted when it is closed.
Handle make_nameless() {
  std::string name = (std::filesystem::temp_directory_path() / "netloft-XXXXXX").string();
  const Descriptor made(mkstemp(name.data()));
  if (made.get() < 0) throw FileError(name + ": " + system_reason());
  const hid_t file = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  unlink(name.c_str());
  return Handle(file, H5Fclose);
}

/// Runs `action` on records of a journal. Records with valid checksums may still be inconsistent. If HDF5 or
/// VTK refuses their data, throws a FileError about the journal.
template <class Action>
decltype(auto) with_misfits_of(const std::string& context, Action&& action) {
  return with_context(context, [&]() -> decltype(auto) {
    try {
      return action();
    } catch (const std::invalid_argument& misfit) {
      throw FileError(std::string("the records of the motion contradict each other: ") + misfit.what());
    }
  });
}

}  // namespace

void fold_series(const SeriesJournal& journal, hid_t file, const std::string& file_name) {
  silence_hdf5();
  const SeriesLayout& layout = journal.layout();
  Rows rows{layout.columns.size(), {}};
  with_misfits_of("cannot write " + file_name, [&] {
    VtkHdf grid(file, layout.mesh, layout.changing, layout.fixed, journal.size(), journal.stored());
    for (std::size_t i = 0; i < journal.size(); ++i) {
      report({"writing", file_name, i, "outputs"});
      const SeriesState state = journal.stored_state(i);
      const std::vector<std::span<const double>> fields(state.fields.begin(), state.fields.end());
      if (state.row.size() != rows.columns)
        throw std::invalid_argument("an output lacks numbers of a series");
      grid.write_state(state.time, state.points, fields);
      rows.values.insert(rows.values.end(), state.row.begin(), state.row.end());
    }
    grid.finish();
  });
  Tree tree(file, file_name);
  write_columns(tree, layout.columns, rows);
  if (journal.size() > 1)
    tree.write_ints(kRoot + "/xdmf/cells", mixed_cells(layout.mesh), "1",
                    "cells, to which the index for viewers, NAME.xdmf, refers");
}

void make_result(const SeriesJournal& journal, const std::filesystem::path& final_path,
                 const std::function<void(Tree&)>& rest) {
  const LongWork writing({"writing", final_path.native()});
  ResultFile file(final_path, final_path.string() + ".new");
  try {
    fold_series(journal, file.part().id(), file.part_path().string());
    rest(file.tree());
    file.finish();
  } catch (...) {
    file.discard();
    throw;
  }
}

Handle unfold(const std::filesystem::path& part) {
  const SeriesJournal journal = SeriesJournal::read(part);
  return with_misfits_of("cannot read " + part.string() + " by way of a temporary file", [&] {
    Handle file = make_nameless();
    Tree tree(file, "a temporary file");
    begin_result(tree, journal.status().outcome, journal.status().sentence);
    copy_origins(journal.origins(), file);
    if (journal.size() > 0) fold_series(journal, file, "a temporary file");
    write_last_row(tree, journal);
    check(H5Fflush(file, H5F_SCOPE_GLOBAL));
    require_own_data(file);  // a long name in the journal could otherwise create deeply nested groups
    return file;
  });
}

}  // namespace netloft::formats
