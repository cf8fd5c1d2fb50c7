// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace netloft::formats {

/// The text with its control characters written as in JSON, "\u001b", so that a terminal shows them instead
/// of executing them. Control characters are U+0000 to U+001F, U+007F to U+009F, and single bytes from 7F to
/// 9F, which a terminal without UTF-8 would execute. Line feeds and tabs stay; a line end of two characters
/// becomes a line feed. A JSON text keeps its meaning.
std::string printable(std::string_view text);

/// Like printable(), for a text within a line: line feeds are escaped as well, and tabs become blanks.
std::string printable_in_line(std::string_view text);

/// Whether a text has a character that printable_in_line() replaces.
bool has_control_characters(std::string_view text);

}  // namespace netloft::formats
