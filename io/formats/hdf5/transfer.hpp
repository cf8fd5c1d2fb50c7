// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/handle.hpp"

#include <algorithm>

namespace netloft::formats {

/// Sets a smaller conversion buffer (H5Pset_buffer). By default HDF5 allocates and clears a megabyte for each
/// dataset whose values it converts, such as strings.
inline void want_buffer(hid_t transfer, hssize_t values, std::size_t largest) {
  constexpr std::size_t kWhatHdf5Takes = 1 << 20;
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(values, 1));
  const std::size_t wanted = count < kWhatHdf5Takes / largest ? count * largest : kWhatHdf5Takes;
  check(H5Pset_buffer(transfer, wanted, nullptr, nullptr));
}

constexpr std::size_t kStringInFile = 16;  // length and position of a string in a file [bytes]

inline Handle make_transfer(hid_t dataset, hid_t memory_type) {
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  const Handle type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  want_buffer(transfer, check(H5Sget_simple_extent_npoints(space)),
              std::max({H5Tget_size(type), H5Tget_size(memory_type), kStringInFile}));
  return transfer;
}

}  // namespace netloft::formats
