// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5/part_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace netloft::io {
namespace fs = std::filesystem;
namespace {

std::string system_reason() { return std::generic_category().message(errno); }

fs::path with_suffix(const fs::path& path, const char* suffix) { return path.string() + suffix; }

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

enum class Lock { kTaken, kWriterAlive, kReadersOnly };

/// On a file system without locks the file counts as free, because refusing to write would not help the user.
Lock try_lock(int fd) {
  if (flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return Lock::kTaken;
  if (flock(fd, LOCK_SH | LOCK_NB) != 0) return Lock::kWriterAlive;
  return Lock::kReadersOnly;
}

/// Returns false if another process renamed or replaced the file between our open() and our lock.
bool is_still_named(int fd, const fs::path& path) {
  struct stat by_fd {};
  struct stat by_name {};
  return fstat(fd, &by_fd) == 0 && lstat(path.c_str(), &by_name) == 0 && by_fd.st_ino == by_name.st_ino &&
         by_fd.st_dev == by_name.st_dev;
}

/// A symbolic link is not followed: what it points at may be anybody's. Nor is a device opened, which may
/// block.
Descriptor open_or_create(const fs::path& part) {
  std::error_code none;
  const auto kind = fs::symlink_status(part, none).type();
  if (kind == fs::file_type::symlink)
    throw FileError("cannot write " + part.string() +
                    ": it is a symbolic link; remove it or choose another name with -o");
  if (fs::exists(part, none) && kind != fs::file_type::regular)
    throw FileError("cannot write " + part.string() + ": it is a folder, a device or similar");
  Descriptor fd(open(part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (fd.get() < 0) throw FileError("cannot write " + part.string() + ": " + system_reason());
  return fd;
}

Descriptor take(const fs::path& part) {
  while (true) {
    Descriptor fd = open_or_create(part);
    const Lock lock = try_lock(fd.get());
    if (lock == Lock::kWriterAlive)
      throw FileError("cannot write " + part.string() +
                      ": another process is writing it now; wait for it or choose another name");
    if (!is_still_named(fd.get(), part)) continue;
    if (lock == Lock::kTaken) return fd;
    // A viewer may still read what a dead writer left: it keeps those bytes, and we start a new file.
    if (unlink(part.c_str()) != 0 && errno != ENOENT)
      throw FileError("cannot replace " + part.string() + ": " + system_reason());
  }
}

/// Format bounds stay at "earliest": newer ones are unreadable after a crash until repaired.
Handle create_hdf5(const fs::path& part, const Descriptor& lock) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  check(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG));
  check(H5Pset_file_locking(access, false, true));
  const auto create = [&] { return H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access); };
  hid_t id = create();
  if (id <
      0) {  // HDF5_USE_FILE_LOCKING=TRUE makes HDF5 insist on a lock of its own, which collides with ours
    flock(lock.get(), LOCK_UN);
    id = create();
  }
  return with_context("cannot create " + part.string(), [&] { return Handle(id, H5Fclose); });
}

/// Gives `path` the second name NAME.hdf~; it has at least one name at every moment.
void keep_as_backup(const fs::path& path) {
  const fs::path backup = with_suffix(path, "~");
  const fs::path link_path = with_suffix(path, "~.new");
  unlink(link_path.c_str());
  if (link(path.c_str(), link_path.c_str()) == 0) {
    if (rename(link_path.c_str(), backup.c_str()) != 0) {
      const std::string reason = system_reason();
      unlink(link_path.c_str());
      throw FileError("cannot keep " + path.string() + " as " + backup.string() + ": " + reason);
    }
    unlink(link_path.c_str());  // rename() leaves it when both names already meant the same file
    return;
  }
  if (errno == ENOENT) return;  // no earlier result
  // On file systems without hard links, only the name NAME.hdf~ exists for a moment.
  if (rename(path.c_str(), backup.c_str()) != 0)
    throw FileError("cannot keep " + path.string() + " as " + backup.string() + ": " + system_reason());
}

}  // namespace

void Descriptor::close() {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

PartFile::PartFile(fs::path final_path) : PartFile(final_path, with_suffix(final_path, ".part")) {}

PartFile::PartFile(fs::path final_path, fs::path part_path)
    : final_(std::move(final_path)), part_(std::move(part_path)) {
  silence_hdf5();
  require_usable(final_);
  lock_ = take(part_);
  file_ = create_hdf5(part_, lock_);
}

bool PartFile::exchange_names(PartFile& other) {
  if (renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, other.part_.c_str(), RENAME_EXCHANGE) != 0) return false;
  part_.swap(other.part_);
  return true;
}

void PartFile::take_name_of(const fs::path& part) {
  if (rename(part_.c_str(), part.c_str()) != 0)
    throw FileError("cannot rename " + part_.string() + " to " + part.string() + ": " + system_reason());
  part_ = part;
}

void PartFile::flush() {
  silence_hdf5();
  with_context("cannot write " + part_.string(), [&] { check(H5Fflush(file_, H5F_SCOPE_GLOBAL)); });
}

void PartFile::sync() {
  flush();
  sync_descriptor();
}

void PartFile::sync_descriptor() const {
  if (fsync(lock_.get()) != 0 && errno != EINVAL)
    throw FileError("cannot write " + part_.string() + ": " + system_reason());
}

void PartFile::finish_as(fs::path final_path) {
  require_usable(final_path);
  final_ = std::move(final_path);
  finish();
}

void PartFile::discard() {
  if (finished_) return;
  unlink(part_.c_str());
  finished_ = true;
}

void PartFile::finish() {
  if (finished_) return;
  flush();
  with_context("cannot write " + part_.string(), [&] { file_.close(); });
  sync_descriptor();
  keep_as_backup(final_);
  if (rename(part_.c_str(), final_.c_str()) != 0)
    throw FileError("cannot rename " + part_.string() + " to " + final_.string() + ": " + system_reason());
  lock_.close();
  finished_ = true;
}

void require_no_writer(const fs::path& part) {
  std::error_code none;
  if (!fs::exists(part, none)) return;
  const Descriptor fd(open(part.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (fd.get() >= 0 && try_lock(fd.get()) == Lock::kWriterAlive)
    throw FileError("cannot write " + part.string() +
                    ": another process is writing it now; wait for it or choose another name");
}

}  // namespace netloft::io
