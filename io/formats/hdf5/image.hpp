// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "io/formats/hdf5/tree.hpp"

namespace netloft::formats {

/// The bytes of an HDF5 file with the content of `write`, made in memory. Journals contain such an image of
/// the inputs of a run.
std::string hdf5_image(const std::function<void(Tree&)>& write);

/// How HDF5 opens a file in memory, which is never written to a disk.
Handle access_in_memory();

}  // namespace netloft::formats
