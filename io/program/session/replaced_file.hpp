// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace netloft::program {

class Terminal;

/// Replaces the file `output` by `content`, whole or not at all: the new file is written beside it and
/// renamed (io/formats/files). Throws UsageError for a folder, a device, one of `sources`, and for a name
/// without one of `endings`, such as ".svg" (none allows any); WriteError if the system refuses.
void replace_file(const std::string& output, const std::string& content,
                  const std::vector<std::string>& sources, const std::vector<std::string>& endings = {});

/// Throws UsageError if `file`, which `option` names, is not empty and has none of the endings.
void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string>& endings);

/// Throws UsageError if `file` cannot be written: over one of `sources`, over a folder or device, or in a
/// folder that does not exist. An empty name is no file.
void require_place(const std::string& file, const std::vector<std::string>& sources);

/// Calls `write` after the answer was printed, so that a full disk costs these files alone. Reports a
/// failure. Returns `code`, or kOther after a failure.
int write_last(Terminal& terminal, int code, const std::function<void()>& write);

}  // namespace netloft::program
