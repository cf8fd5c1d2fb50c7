// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft::results {

/// Writes NAME.xdmf beside a finished NAME.hdf with several states: the same series for viewers that read one
/// state of a VTKHDF group only (ParaView before 5.12). It refers to bytes of the HDF5 file, where arrays
/// lie in one piece, and contains no numbers.
void write_xdmf(const std::filesystem::path& result);

}  // namespace netloft::results
