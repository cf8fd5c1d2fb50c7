// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/memory_forecast.hpp"

#include <string>

namespace netloft::program {

/// Why there is no room for the buffer that dense linear algebra wants at its first call; empty if there is.
/// OpenBLAS asks the system for it again and again, for ever, where a limit (ulimit -v, ulimit -d) refuses
/// it.
std::string lack_of_memory();

/// The forecast in words, without an end of line: "memory: about 1.8 GiB, …".
std::string memory_text(const runs::MemoryForecast& forecast, double within_reach);

/// What is to be said of a forecast before anything is solved: nothing of one that takes little of what is
/// within reach. Throws std::runtime_error with a sentence if more is wanted than is there.
std::string note_of_memory(const runs::MemoryForecast& forecast, double within_reach);

}  // namespace netloft::program
