// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace netloft::program {

// Only these functions and Terminal write to standard output and standard error. They replace control
// characters in all texts, because a terminal would execute control characters (io/formats/text).

/// Prints an answer, or a part of one, on standard output.
void print(std::string_view text);
/// Prints an answer with a line end on standard output.
void print_line(std::string_view text);
/// Flushes standard output, so that answers are visible while the program continues.
void flush_answers();
/// Prints a message with a line end on standard error. Terminal::say() does the same and first removes a
/// progress line.
void print_error(std::string_view text);

}  // namespace netloft::program
