// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::io {

/// From now on, a crash of the program is explained as one of `type` in the conformance check under way, with
/// exit 1.
void explain_crashes_of(const std::string& type);

}  // namespace netloft::io
