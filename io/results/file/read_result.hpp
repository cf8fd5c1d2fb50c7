// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/read.hpp"
#include "io/results/figures/result.hpp"

#include <filesystem>

namespace netloft::results {

/// Reads a result file, or the outputs so far of a motion that is running or was killed, without its shapes.
/// Members that an older version did not write keep their defaults, and `notes` lists them. Throws FileError
/// with a sentence if the file cannot be read, is not a result of this program, or has a newer format.
Result read_result(const std::filesystem::path& path);

/// Reads a result in the same way from a file that is already open.
Result read_result(const formats::Reader& reader, const std::filesystem::path& path);

}  // namespace netloft::results
