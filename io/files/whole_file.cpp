// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace netloft::io {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
  throw WriteError(path.string() + " cannot be written: " + std::generic_category().message(error));
}

/// The file beside; it is removed unless it got its name.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& path) : path_(path), beside_(path.string() + ".new") {
    unlink(beside_.c_str());  // left by a program that was killed
    fd_ = open(beside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ < 0) fail(path_, errno);
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    if (fd_ >= 0) close(fd_);
    if (!is_named_) unlink(beside_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(fd_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, errno);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void sync_and_rename() {
    if (fsync(fd_) != 0 && errno != EINVAL) fail(path_, errno);
    if (close(std::exchange(fd_, -1)) != 0) fail(path_, errno);
    if (rename(beside_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    is_named_ = true;
  }

 private:
  fs::path path_, beside_;
  int fd_ = -1;
  bool is_named_ = false;
};

}  // namespace

void write_whole(const fs::path& path, std::string_view content) {
  std::error_code none;
  if (fs::exists(path, none) && !fs::is_regular_file(path, none))
    throw WriteError(path.string() + " is a folder, a device or similar, not a file that may be replaced");
  FileBeside file(path);
  file.write(content);
  file.sync_and_rename();
}

}  // namespace netloft::io
