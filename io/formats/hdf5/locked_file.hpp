// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

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

/// A file has one writer at a time, known by an exclusive flock() that the system drops when the process
/// dies. Creates the file, or takes over the one that a dead writer left; throws FileError if its writer
/// lives. A symbolic link is not followed, and a device is not opened.
Descriptor take_file(const std::filesystem::path& path);
/// The same for a file that must be there, in order to go on with it.
Descriptor take_existing_file(const std::filesystem::path& path);
/// Throws FileError if a process is writing the file now.
void require_no_writer(const std::filesystem::path& path);
/// Throws FileError unless a result may be written there: the folder exists, and no device has the name.
void require_usable(const std::filesystem::path& path);

/// Size of a file [bytes]; 0 if the system cannot determine it.
std::uint64_t size_of(int fd);
/// Reads bytes of a file that begin at `place`. Throws FileError, also where it ends before them.
void read_at(int fd, std::uint64_t place, char* to, std::size_t size);

/// The newest error of the system in words.
std::string system_reason();

}  // namespace netloft::formats
