// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "io/formats/hdf5/series_journal.hpp"
#include "io/formats/hdf5/tree.hpp"

namespace netloft::formats {

/// Writes the outputs of a journal into an open HDF5 file with the structure of LAYOUT.md. Outputs are
/// written one after another, so that a motion may be larger than memory; only times and numbers of the
/// series are in memory for all outputs.
void fold_series(const SeriesJournal& journal, hid_t file, const std::string& file_name);

/// Makes the result `final_path` from a journal, with the data that `rest` adds. The file is written as
/// NAME.hdf.new, and renamed once it is complete and on the disk; the journal may be removed afterwards. If
/// the user interrupts, throws Interrupted and leaves no file.
void make_result(const SeriesJournal& journal, const std::filesystem::path& final_path,
                 const std::function<void(Tree&)>& rest);

/// Converts a journal into an HDF5 file for a reader. The file is deleted when it is closed.
Handle unfold(const std::filesystem::path& part);

}  // namespace netloft::formats
