// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/handle.hpp"

#include <algorithm>

namespace netloft::formats {

/// For each dataset whose values it converts, as it does strings, HDF5 takes and clears a megabyte
/// (H5Pset_buffer) unless it is told that they need less.
inline void want_buffer(hid_t transfer, hssize_t values, std::size_t largest) {
  constexpr std::size_t kWhatHdf5Takes = 1 << 20;
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(values, 1));
  const std::size_t wanted = count < kWhatHdf5Takes / largest ? count * largest : kWhatHdf5Takes;
  check(H5Pset_buffer(transfer, wanted, nullptr, nullptr));
}

constexpr std::size_t kStringInFile = 16;  // its length, and where it is [bytes]

inline Handle make_transfer(hid_t dataset, hid_t memory_type) {
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  const Handle type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  want_buffer(transfer, check(H5Sget_simple_extent_npoints(space)),
              std::max({H5Tget_size(type), H5Tget_size(memory_type), kStringInFile}));
  return transfer;
}

}  // namespace netloft::formats
