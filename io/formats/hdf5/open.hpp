// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

// The only functions that open HDF5 files for reading. HDF5 lets a file keep its data elsewhere: in external
// storage, in the sources of a virtual dataset, behind an external link. Reading such a file reads other
// files of the user, and waits for ever if one of them is a pipe. So they refuse everything that is not in
// the file itself, before any data are read, and load no filters from the plugins of HDF5.

/// Opens a file for reading. Throws FileError with its name if it cannot be read, or as require_own_data().
Handle open_for_reading(const std::filesystem::path& path);

/// The same for the bytes of a file in memory. HDF5 copies them.
Handle open_image(const std::string& image);

/// Throws FileError that names the object if an open file has data or links elsewhere, names with control
/// characters, one group in two places, or groups nested more deeply than any result has them. All files that
/// are read pass this check, so that readers may walk through groups without a limit.
void require_own_data(hid_t file);

/// Whether a file begins as HDF5 files do. False if it cannot be read.
bool is_hdf5_file(const std::filesystem::path& path);

}  // namespace netloft::formats
