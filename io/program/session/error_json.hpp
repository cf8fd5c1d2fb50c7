// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <string>

namespace netloft::program {

/// What was wrong with an input, for a program: one JSON object with `status` and `errors`.
std::string errors_json(const formats::Diagnostics& diagnostics, int exit_code);
/// The same for one sentence without a place.
std::string error_json(const std::string& message, int exit_code);
/// What was written, where nothing was wrong.
std::string done_json(const std::string& output);

}  // namespace netloft::program
