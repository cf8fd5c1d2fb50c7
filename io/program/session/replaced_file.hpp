// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace netloft::program {

class Terminal;

/// Puts `content` in the place of the file `output`, whole or not at all: it is written beside it and
/// renamed (io/formats/files). A folder, a device or one of `sources` is never replaced, and the name has to
/// end in one of `endings`, such as ".svg"; none: in any. Throws UsageError, or WriteError where the system
/// refuses, with a sentence.
void replace_file(const std::string& output, const std::string& content,
                  const std::vector<std::string>& sources, const std::vector<std::string>& endings = {});

/// Throws UsageError unless a file that `option` names is to be written with one of `endings`, or not at all.
void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string>& endings);

/// Throws UsageError where a file cannot be written, before anything is solved for it: over one of `sources`,
/// over what is no file, or in a folder that is not there. Nothing is said of no file.
void require_place(const std::string& file, const std::vector<std::string>& sources);

/// Writes files once the answer is on standard output, so that a full disk costs these files alone. Says what
/// cannot be written; returns `code`, or kOther after such a failure.
int write_last(Terminal& terminal, int code, const std::function<void()>& write);

}  // namespace netloft::program
