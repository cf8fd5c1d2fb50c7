// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/memory_forecast.hpp"

#include <string>

namespace netloft::program {

/// Throws std::runtime_error if there is no room for the buffer that dense linear algebra allocates in its
/// first call. Without this check, OpenBLAS would retry for ever if a limit (ulimit -v, ulimit -d) prevents
/// the allocation.
void require_memory_to_solve();

/// The forecast as text, without a line end: "memory: about 1.8 GiB, …".
std::string memory_text(const runs::MemoryForecast& forecast, double within_reach);

/// The forecast of the memory of a solve as text; empty if it is a small fraction of the available memory.
/// Throws std::runtime_error with a sentence if the forecast exceeds the available memory.
std::string note_of_memory(const runs::MemoryForecast& forecast, double within_reach);

}  // namespace netloft::program
