// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::io {

/// From now on a crash of the program, and an end that is none of its own (a plugin calls exit), are told on
/// standard error, with the plugin that was at work, what it was called for, and whether its stack was used
/// up. The exit code is then kOther.
void explain_crashes();

/// The same in conformance checks of `type`, with the check under way; until it is called for another one.
/// They may take `seconds` of the processor, and an interruption ends them, too. An empty one: they are over.
void explain_crashes_of(const std::string& type, double seconds = 0);

}  // namespace netloft::io
