// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::results {

/// Version of the program and the commit it was built from, if that is known.
std::string program_version();
/// Host, operating system and processor.
std::string machine_description();
/// Compiler the program was built with.
std::string compiler_description();
/// The current time in UTC, ISO 8601.
std::string utc_now();

}  // namespace netloft::results
