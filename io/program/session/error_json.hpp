// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <string>

namespace netloft::program {

/// Errors of an input for programs: one JSON object with `status` and `errors`.
std::string errors_json(const formats::Diagnostics& diagnostics, int exit_code);
/// The same for one sentence without a place.
std::string error_json(const std::string& message, int exit_code);
/// The file that was written without errors.
std::string done_json(const std::string& output);

}  // namespace netloft::program
