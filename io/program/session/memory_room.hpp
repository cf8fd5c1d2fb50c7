// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/memory_forecast.hpp"

#include <string>

namespace netloft::program {

/// Throws std::runtime_error if there is no room for the buffer that dense linear algebra allocates at its
/// first call. If a limit (ulimit -v, ulimit -d) refused it, OpenBLAS would ask for it for ever.
void require_memory_to_solve();

/// The forecast in words, without an end of line: "memory: about 1.8 GiB, …".
std::string memory_text(const runs::MemoryForecast& forecast, double within_reach);

/// The forecast in words before anything is solved; empty if it is a small fraction of the memory within
/// reach. Throws std::runtime_error with a sentence if it is more than that memory.
std::string note_of_memory(const runs::MemoryForecast& forecast, double within_reach);

}  // namespace netloft::program
