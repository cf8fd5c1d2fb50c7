// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

// The only functions that open HDF5 files for reading. HDF5 lets a file keep its data elsewhere: in external
// storage, in the sources of a virtual dataset, behind an external link. Reading such a file would read other
// files of the user, and would wait for ever if one of them is a pipe. Therefore these functions refuse
// everything that is not in the file itself, before any data are read, and load no filters from the plugins
// of HDF5.

/// Opens a file for reading. Throws FileError if the file cannot be read or fails require_own_data().
Handle open_for_reading(const std::filesystem::path& path);

/// Opens the bytes of a file in memory in the same way. HDF5 copies the bytes.
Handle open_image(const std::string& image);

/// Throws FileError, which names the object, if an open file has one of these faults: data or links
/// elsewhere, a name with control characters, one group in two places, groups nested more deeply than in any
/// result. All files that are read pass this check, so that readers may walk through groups without a limit.
void require_own_data(hid_t file);

/// Whether a file begins as HDF5 files do. False if it cannot be read.
bool is_hdf5_file(const std::filesystem::path& path);

}  // namespace netloft::formats
