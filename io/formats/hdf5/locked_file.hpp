// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

/// Owns a file descriptor; closing the descriptor also releases its lock.
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

/// Opens a file for its only writer, which holds an exclusive flock(); the system releases the lock when the
/// process ends. Creates the file, or takes over the file that a dead writer left; throws FileError if a
/// writer is alive. Symbolic links are not followed, and devices are not opened.
Descriptor take_file(const std::filesystem::path& path);
/// Like take_file(), but for a file that must exist and will be continued.
Descriptor take_existing_file(const std::filesystem::path& path);
/// Throws FileError if a process is writing the file now.
void require_no_writer(const std::filesystem::path& path);
/// Throws FileError unless a result may be written at `path`: its folder must exist, and `path` must not be a
/// device.
void require_usable(const std::filesystem::path& path);

/// Size of a file [bytes]; 0 if the system cannot determine it.
std::uint64_t size_of(int fd);
/// Reads `size` bytes of a file from position `place`. Throws FileError if that fails or the file is too
/// short.
void read_at(int fd, std::uint64_t place, char* to, std::size_t size);

/// The newest error of the system in words.
std::string system_reason();

}  // namespace netloft::formats
