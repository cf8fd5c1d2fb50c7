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

/// A finished result ends with a table in plain text after the HDF5 content (LAYOUT.md): the CRC-32 of the
/// numbers of every dataset, and of all bytes outside the datasets. The table reveals a changed bit, and the
/// dataset that contains it, before HDF5 reads the file. HDF5 ignores the table, and removes it when another
/// program writes to the file.
///
/// find_ranges() returns the ranges of all contiguous datasets in the order of the file.
std::vector<SealedRange> find_ranges(hid_t file);

/// Appends the table to a file that HDF5 has closed. Throws FileError.
void append_seal(int fd, const std::vector<SealedRange>& ranges);

/// Throws FileError if the file does not match its table. If the file has no table, checks only the texts,
/// because HDF5 may never return from damaged texts.
void check_seal(const std::filesystem::path& path);

}  // namespace netloft::formats
