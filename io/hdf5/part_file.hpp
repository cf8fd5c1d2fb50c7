// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "io/hdf5/handle.hpp"

namespace netloft::io {

/// Owns a file descriptor; closing it also drops its lock.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() { close(); }

  void close();
  int get() const { return fd_; }

 private:
  int fd_;
};

/// An HDF5 file that grows as NAME.hdf.part and takes its name only when it is complete.
///
///   construct   NAME.hdf.part is created, or a dead writer's one replaced; a live writer's one is an error
///   finish()    NAME.hdf -> NAME.hdf~, NAME.hdf.part -> NAME.hdf; NAME.hdf exists throughout if it did
///   before destroy     without finish(): the .part stays as it was flushed last
///
/// A live writer is known by an exclusive flock() on the .part, which the system drops when the process dies.
/// HDF5 keeps readers out by the same lock, unless they set HDF5_USE_FILE_LOCKING=FALSE.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path final_path);
  /// The same, with another name while it grows.
  PartFile(std::filesystem::path final_path, std::filesystem::path part_path);

  /// Two growing files exchange names, on the disk and in these objects, in one atomic operation. Returns
  /// false if the file system does not support it.
  bool exchange_names(PartFile& other);
  /// Takes the name of a file that has no writer, in one instant.
  void take_name_of(const std::filesystem::path& part);

  hid_t id() const { return file_; }
  const std::filesystem::path& part_path() const { return part_; }
  const std::filesystem::path& final_path() const { return final_; }

  void flush();
  /// Flushes, and waits until all of it is on the disk.
  void sync();
  void finish();
  /// The same under another name than the one it was made for.
  void finish_as(std::filesystem::path final_path);
  /// Removes the .part, which is not worth keeping; nothing can be written afterwards.
  void discard();
  bool is_finished() const { return finished_; }

 private:
  void sync_descriptor() const;

  std::filesystem::path final_;
  std::filesystem::path part_;
  // destroyed after file_, so that no other process takes the .part while HDF5 is still closing it
  Descriptor lock_;
  Handle file_;
  bool finished_ = false;
};

/// Throws FileError if a process is writing the .part now.
void require_no_writer(const std::filesystem::path& part);

}  // namespace netloft::io
