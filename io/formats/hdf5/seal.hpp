// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

/// Where the numbers of a dataset lie in the file.
struct SealedRange {
  std::string path;
  std::uint64_t place = 0, length = 0;  // [bytes]
};

/// A finished result ends with a table in plain text behind what HDF5 knows of (LAYOUT.md): the CRC-32 of the
/// numbers of every dataset, and of everything between them. A flipped bit is found before HDF5 reads it, and
/// the dataset is named. HDF5 itself takes no notice of the table, and cuts it off when another program
/// writes into the file.
///
/// The ranges of all datasets that lie in one piece, in the order of the file.
std::vector<SealedRange> find_ranges(hid_t file);

/// Appends the table to a file that HDF5 has closed. Throws FileError.
void append_seal(int fd, const std::vector<SealedRange>& ranges);

/// Throws FileError if the file does not match its table; of a file without one only the texts are checked,
/// where HDF5 itself may come to no end.
void check_seal(const std::filesystem::path& path);

}  // namespace netloft::formats
