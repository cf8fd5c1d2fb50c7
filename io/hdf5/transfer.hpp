// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/hdf5/handle.hpp"

#include <algorithm>

namespace netloft::io {

/// For each dataset whose values it converts, as it does strings, HDF5 takes and clears a megabyte
/// (H5Pset_buffer) unless it is told that they need less.
inline Handle make_transfer(hid_t dataset, hid_t memory_type) {
  constexpr std::size_t kWhatHdf5Takes = 1 << 20, kStringInFile = 16;  // its length, and where it is
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  const Handle type(H5Dget_type(dataset), H5Tclose), space(H5Dget_space(dataset), H5Sclose);
  const std::size_t largest = std::max({H5Tget_size(type), H5Tget_size(memory_type), kStringInFile});
  const auto values = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space)));
  if (values < kWhatHdf5Takes / largest)
    check(H5Pset_buffer(transfer, std::max<std::size_t>(values, 1) * largest, nullptr, nullptr));
  return transfer;
}

}  // namespace netloft::io
