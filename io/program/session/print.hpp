// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace netloft::program {

// Only these functions and Terminal write to standard output and standard error. They remove from all texts
// the control characters that a terminal would obey (io/formats/text).

/// Prints an answer, or a part of one, on standard output.
void print(std::string_view text);
/// Prints an answer with a line end on standard output.
void print_line(std::string_view text);
/// Hands over what was printed to whoever reads standard output, for answers of a program that goes on.
void flush_answers();
/// Prints a message with a line end on standard error. Terminal::say() also removes a progress line first.
void print_error(std::string_view text);

}  // namespace netloft::program
