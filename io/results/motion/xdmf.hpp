// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft::results {

/// Writes NAME.xdmf beside a finished NAME.hdf with several states, for viewers that read only one state of a
/// VTKHDF group (ParaView before 5.12). The file contains no numbers; it refers to byte ranges of the HDF5
/// file, whose arrays are contiguous.
void write_xdmf(const std::filesystem::path& result);

}  // namespace netloft::results
