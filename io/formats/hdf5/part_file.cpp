// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/part_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "io/formats/files/whole_file.hpp"
#include "io/formats/hdf5/seal.hpp"

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

fs::path with_suffix(const fs::path& path, const char* suffix) { return path.string() + suffix; }

/// Creates the HDF5 file in the format "earliest", because readers in browsers do not support newer formats.
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

/// Keeps an earlier result as NAME.hdf~.
void keep_earlier(const fs::path& path) {
  try {
    keep_as_backup(path);
  } catch (const WriteError& e) {
    throw FileError(e.what());
  }
}

}  // namespace

PartFile::PartFile(fs::path final_path) : PartFile(final_path, with_suffix(final_path, ".part")) {}

PartFile::PartFile(fs::path final_path, fs::path part_path)
    : final_(std::move(final_path)), part_(std::move(part_path)) {
  silence_hdf5();
  require_usable(final_);
  lock_ = take_file(part_);
  file_ = create_hdf5(part_, lock_);
}

void PartFile::flush() {
  silence_hdf5();
  with_context("cannot write " + part_.string(), [&] { check(H5Fflush(file_, H5F_SCOPE_GLOBAL)); });
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
  with_context("cannot write " + part_.string(), [&] {
    const auto ranges = find_ranges(file_);
    file_.close();
    append_seal(lock_.get(), ranges);
  });
  if (fsync(lock_.get()) != 0 && errno != EINVAL)
    throw FileError("cannot write " + part_.string() + ": " + system_reason());
  keep_earlier(final_);
  if (rename(part_.c_str(), final_.c_str()) != 0)
    throw FileError("cannot rename " + part_.string() + " to " + final_.string() + ": " + system_reason());
  sync_folder_of(final_);
  lock_.close();
  finished_ = true;
}

void sync_folder_of(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Descriptor fd(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) fsync(fd.get());  // on file systems that cannot sync a folder, this fails without harm
}

}  // namespace netloft::formats
