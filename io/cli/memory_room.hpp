// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::io {

/// Why there is no room for the buffer that dense linear algebra wants at its first call; empty if there is.
/// OpenBLAS asks the system for it again and again, for ever, where a limit (ulimit -v, ulimit -d) refuses
/// it.
std::string lack_of_memory();

}  // namespace netloft::io
