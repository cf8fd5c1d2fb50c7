// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::formats {

/// HDF5 keeps texts in collections of objects (its format specification 3.0, III.E "Global Heap"), which it
/// walks by the lengths that they state: with an object of no length it comes to no end. Throws FileError
/// where the objects of a collection do not fill it in steps that lead on.
void check_text_heaps(int fd);

}  // namespace netloft::formats
