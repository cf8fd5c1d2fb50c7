// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::formats {

/// Checks the collections of objects in which HDF5 stores texts (its format specification 3.0, III.E "Global
/// Heap"). HDF5 steps through a collection by the lengths that the objects state, and would never leave an
/// object of zero length. Throws FileError if the objects of a collection do not fill it exactly.
void check_text_heaps(int fd);

}  // namespace netloft::formats
