// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

/// The bytes of a file that contain the numbers of a dataset.
struct SealedRange {
  std::string path;
  std::uint64_t place = 0, length = 0;  // [bytes]
};

/// A finished result ends with a table in plain text behind the HDF5 content (LAYOUT.md): the CRC-32 of the
/// numbers of every dataset, and of everything between them. It reveals a flipped bit, and its dataset,
/// before HDF5 reads it. HDF5 ignores the table, and cuts it off when another program writes into the file.
///
/// The ranges of all contiguous datasets, in the order of the file.
std::vector<SealedRange> find_ranges(hid_t file);

/// Appends the table to a file that HDF5 has closed. Throws FileError.
void append_seal(int fd, const std::vector<SealedRange>& ranges);

/// Throws FileError if the file does not match its table. Without a table it checks only the texts, because
/// HDF5 may never return from damaged ones.
void check_seal(const std::filesystem::path& path);

}  // namespace netloft::formats
