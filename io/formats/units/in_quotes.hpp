// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace netloft::formats {

/// What somebody wrote, in quotes for a sentence, and shortened when it is very long.
std::string in_quotes(std::string_view text);

}  // namespace netloft::formats
