// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace netloft::formats {

/// A file that cannot be written; what() is a sentence for the user.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes `content` to the file `path`, or throws WriteError and leaves the old file unchanged. The content
/// is first written to PATH.new; this file is synced and then renamed. Programs that write the same file at
/// once take turns. A link to a file is replaced, not followed. Folders, devices, and links to them are
/// refused.
void write_whole(const std::filesystem::path& path, std::string_view content);

/// Like write_whole(), for a path that a user names. The replaced file may be any file, so it is kept as
/// PATH~ unless it has the same content.
void write_keeping(const std::filesystem::path& path, std::string_view content);

/// Keeps the file `path`, if it exists, as its backup PATH~, which replaces an earlier backup. At any moment,
/// the file has at least one of these two names. Throws WriteError.
void keep_as_backup(const std::filesystem::path& path);

/// A file that cannot be read; what() is a sentence for the user.
class ReadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The contents of a file; nullopt if the file does not exist. Throws ReadError if the file cannot be read,
/// and for folders, pipes and devices, because reading a pipe or a device may never end.
std::optional<std::string> read_whole(const std::filesystem::path& path);

}  // namespace netloft::formats
