// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
  throw WriteError(path.string() + " cannot be written: " + std::generic_category().message(error));
}

/// Opens the empty file PATH.new for one writer at a time: another writer waits until the first one has
/// renamed its file. A writer that is killed leaves its file, but not its lock.
int open_beside(const fs::path& path, const fs::path& beside) {
  for (;;) {
    struct stat named {
    }, opened{};
    if (lstat(beside.c_str(), &named) == 0 && (!S_ISREG(named.st_mode) || named.st_nlink > 1))
      unlink(beside.c_str());  // replaces a link or a pipe instead of writing to it
    const int fd = open(beside.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) fail(path, errno);
    while (flock(fd, LOCK_EX) != 0 && errno == EINTR)
      continue;  // some file systems, such as network ones, have no locks, and flock() fails at once
    const bool is_still_there = stat(beside.c_str(), &named) == 0 && fstat(fd, &opened) == 0 &&
                                named.st_ino == opened.st_ino && named.st_dev == opened.st_dev;
    if (is_still_there && ftruncate(fd, 0) == 0) return fd;
    const int error = errno;
    close(fd);
    if (is_still_there) fail(path, error);
  }
}

/// The file PATH.new, which is removed unless it has been renamed.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& path)
      : path_(path), beside_(path.string() + ".new"), fd_(open_beside(path_, beside_)) {}
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    if (!is_named_) unlink(beside_.c_str());
    if (fd_ >= 0) close(fd_);
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(fd_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, errno);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void sync() {
    if (fsync(fd_) != 0 && errno != EINVAL) fail(path_, errno);
  }
  void rename_to_path() {
    if (rename(beside_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    is_named_ = true;
    if (close(std::exchange(fd_, -1)) != 0) fail(path_, errno);
  }

 private:
  fs::path path_, beside_;
  int fd_ = -1;
  bool is_named_ = false;
};

/// Writes the file PATH.new, calls `before_renaming`, and renames the file.
template <class Action>
void write_beside(const fs::path& path, std::string_view content, const Action& before_renaming) {
  std::error_code none;
  if (fs::exists(path, none) && !fs::is_regular_file(path, none))
    throw WriteError(path.string() + " is a folder, a device or similar, not a file that may be replaced");
  FileBeside file(path);
  file.write(content);
  file.sync();
  before_renaming();
  file.rename_to_path();
}

[[noreturn]] void fail_to_keep(const fs::path& path, const fs::path& backup, int error) {
  throw WriteError("cannot keep " + path.string() + " as " + backup.string() + ": " +
                   std::generic_category().message(error));
}

bool has_content(const fs::path& path, std::string_view content) {
  try {
    return read_whole(path) == content;
  } catch (const ReadError&) {
    return false;
  }
}

}  // namespace

void write_whole(const fs::path& path, std::string_view content) {
  write_beside(path, content, [] {});
}

void write_keeping(const fs::path& path, std::string_view content) {
  write_beside(path, content, [&] {
    if (!has_content(path, content)) keep_as_backup(path);
  });
}

void keep_as_backup(const fs::path& path) {
  const fs::path backup = path.string() + "~", link_path = path.string() + "~.new";
  unlink(link_path.c_str());
  if (link(path.c_str(), link_path.c_str()) == 0) {
    const int error = rename(link_path.c_str(), backup.c_str()) == 0 ? 0 : errno;
    unlink(link_path.c_str());  // rename() keeps this name if both names already meant the same file
    if (error != 0) fail_to_keep(path, backup, error);
    return;
  }
  if (errno == ENOENT) return;
  // On file systems without hard links, the file is renamed; for a moment, it then has only the name PATH~.
  if (rename(path.c_str(), backup.c_str()) != 0) fail_to_keep(path, backup, errno);
}

std::optional<std::string> read_whole(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (fs::exists(status) && status.type() != fs::file_type::regular)
    throw ReadError(path.string() + " is a folder, a pipe or a device, not a file");
  std::FILE* file = std::fopen(path.c_str(), "rb");
  std::string content;
  std::array<char, 1 << 16> block;
  for (std::size_t n; file && (n = std::fread(block.data(), 1, block.size(), file)) > 0;)
    content.append(block.data(), n);
  const bool is_whole = file && !std::ferror(file);
  const int reason = errno;
  if (file) std::fclose(file);
  if (!is_whole)
    throw ReadError(path.string() + " cannot be read: " + std::generic_category().message(reason));
  return content;
}

}  // namespace netloft::formats
