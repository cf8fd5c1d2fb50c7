// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace netloft::formats {

/// Puts a text from the user in quotes, for messages. Very long texts are shortened.
std::string in_quotes(std::string_view text);

}  // namespace netloft::formats
