// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace netloft::program {

class Terminal;

/// Replaces the file `output` by `content`, completely or not at all, and keeps the old file as a backup
/// (formats::write_keeping). Throws UsageError if `output` is a folder, a device or one of `sources`, or has
/// none of the `endings`, such as ".svg" (if `endings` is empty, all are allowed). Throws WriteError if the
/// system refuses.
void replace_file(const std::string& output, const std::string& content,
                  const std::vector<std::string>& sources, const std::vector<std::string>& endings = {});

/// Throws UsageError if `file`, the value of `option`, is not empty and has none of the endings.
void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string>& endings);

/// Throws UsageError if `file` cannot be written: if it is one of `sources`, a folder or a device, or is in a
/// folder that does not exist. An empty name passes.
void require_place(const std::string& file, const std::vector<std::string>& sources);

/// Calls `write`, which writes output files. Call it after the answer was printed, so that a full disk
/// affects only these files. Returns `code`; after a failure, reports it and returns kOther.
int write_last(Terminal& terminal, int code, const std::function<void()>& write);

}  // namespace netloft::program
