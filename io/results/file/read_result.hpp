// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/read.hpp"
#include "io/results/figures/result.hpp"

#include <filesystem>

namespace netloft::results {

/// Reads a result, without its shapes, from a result file or from the file of a motion that is running or was
/// killed. Members that an older version did not write keep their defaults, and `notes` lists them. Throws
/// FileError with a sentence if the file cannot be read, is not a result of this program, or has a newer
/// format.
Result read_result(const std::filesystem::path& path);

/// Reads a result from a file that is already open; `path` is its name for messages.
Result read_result(const formats::Reader& reader, const std::filesystem::path& path);

}  // namespace netloft::results
