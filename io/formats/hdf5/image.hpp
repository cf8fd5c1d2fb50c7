// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "io/formats/hdf5/tree.hpp"

namespace netloft::formats {

/// Makes an HDF5 file in memory with the content that `write` adds, and returns its bytes. Journals contain
/// such an image of the inputs of a run.
std::string hdf5_image(const std::function<void(Tree&)>& write);

/// Access properties for a file in memory, which HDF5 never writes to a disk.
Handle access_in_memory();

}  // namespace netloft::formats
