// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace netloft::program {

// Standard output and standard error belong to these functions and to Terminal: texts of files pass through
// them, and reach a terminal without the control characters that it would obey (io/formats/text).

/// Prints an answer, or a part of one, on standard output.
void print(std::string_view text);
/// Prints an answer with a line end on standard output.
void print_line(std::string_view text);
/// Prints a message with a line end on standard error. Terminal::say() also removes a progress line first.
void print_error(std::string_view text);

}  // namespace netloft::program
