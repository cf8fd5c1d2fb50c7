// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/locked_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

enum class Lock { kTaken, kWriterAlive, kReadersOnly };

/// Tries to lock a file. If the file system has no locks, the file counts as free, because refusing to write
/// would not help the user.
Lock try_lock(int fd) {
  if (flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return Lock::kTaken;
  if (flock(fd, LOCK_SH | LOCK_NB) != 0) return Lock::kWriterAlive;
  return Lock::kReadersOnly;
}

[[noreturn]] void refuse_second_writer(const fs::path& path) {
  throw FileError("cannot write " + path.string() +
                  ": another process is writing it now; wait for it or choose another name");
}

/// Whether `path` is still the file that was opened: another process may have renamed or replaced it between
/// open() and the lock.
bool is_still_named(int fd, const fs::path& path) {
  struct stat by_fd {};
  struct stat by_name {};
  return fstat(fd, &by_fd) == 0 && lstat(path.c_str(), &by_name) == 0 && by_fd.st_ino == by_name.st_ino &&
         by_fd.st_dev == by_name.st_dev;
}

/// Opens a regular file. Refuses a symbolic link, whose target may belong to somebody else, and a device,
/// which may block.
Descriptor open_plain(const fs::path& path, int flags) {
  std::error_code none;
  const auto kind = fs::symlink_status(path, none).type();
  if (kind == fs::file_type::symlink)
    throw FileError("cannot write " + path.string() +
                    ": it is a symbolic link; remove it or choose another name with -o");
  if (fs::exists(path, none) && kind != fs::file_type::regular)
    throw FileError("cannot write " + path.string() + ": it is a folder, a device or similar");
  Descriptor fd(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0666));
  if (fd.get() < 0) throw FileError("cannot write " + path.string() + ": " + system_reason());
  return fd;
}

}  // namespace

std::string system_reason() { return std::generic_category().message(errno); }

void Descriptor::close() {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

Descriptor take_file(const fs::path& path) {
  while (true) {
    Descriptor fd = open_plain(path, O_CREAT);
    const Lock lock = try_lock(fd.get());
    if (lock == Lock::kWriterAlive) refuse_second_writer(path);
    if (!is_still_named(fd.get(), path)) continue;
    if (lock == Lock::kTaken) return fd;
    // A viewer may still read the file of a killed writer. The viewer then keeps the old file, without its
    // name, and this writer creates a new one.
    if (unlink(path.c_str()) != 0 && errno != ENOENT)
      throw FileError("cannot replace " + path.string() + ": " + system_reason());
  }
}

Descriptor take_existing_file(const fs::path& path) {
  Descriptor fd = open_plain(path, 0);
  const Lock lock = try_lock(fd.get());
  if (lock == Lock::kWriterAlive) refuse_second_writer(path);
  if (lock == Lock::kReadersOnly || !is_still_named(fd.get(), path))
    throw FileError("cannot write " + path.string() +
                    ": another process is using it now; wait for it and try again");
  return fd;
}

void require_no_writer(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(path, none)) return;
  const Descriptor fd(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (fd.get() >= 0 && try_lock(fd.get()) == Lock::kWriterAlive) refuse_second_writer(path);
}

void require_usable(const fs::path& path) {
  std::error_code ignored;
  if (!path.has_filename()) throw FileError("'" + path.string() + "' names no file to write");
  if (fs::is_directory(path, ignored)) throw FileError(path.string() + " is a folder, not a file to write");
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
    throw FileError(path.string() + " is a device or similar, not a file that a result may replace");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throw FileError("cannot write " + path.string() + ": the folder " + folder.string() + " does not exist");
}

std::uint64_t size_of(int fd) {
  struct stat status {};
  return fstat(fd, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

void read_at(int fd, std::uint64_t place, char* to, std::size_t size) {
  while (size > 0) {
    const ssize_t got = pread(fd, to, size, static_cast<off_t>(place));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileError(system_reason());
    if (got == 0) throw FileError("it became shorter while it was read");
    to += got;
    size -= static_cast<std::size_t>(got);
    place += static_cast<std::uint64_t>(got);
  }
}

}  // namespace netloft::formats
