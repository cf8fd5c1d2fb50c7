// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::results {

/// Names of groups of a result file (io/formats/hdf5/LAYOUT.md).
inline const std::string kRoot = "/netloft/", kErrors = "/netloft/errors/", kSpread = "/netloft/spread/";

}  // namespace netloft::results
