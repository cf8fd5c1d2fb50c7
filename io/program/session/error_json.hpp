// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <string>

namespace netloft::program {

/// Errors of an input as one JSON object with `status` and `errors`, for programs.
std::string errors_json(const formats::Diagnostics& diagnostics, int exit_code);
/// A single error that has no place in a file, as a JSON object like that of errors_json().
std::string error_json(const std::string& message, int exit_code);
/// A text as JSON writes it, in quotes.
std::string json_text(const std::string& text);
/// A JSON object that reports success and names the file that was written.
std::string done_json(const std::string& output);

}  // namespace netloft::program
