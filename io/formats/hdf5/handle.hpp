// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace netloft::formats {

/// A result file that cannot be written or read; what() is a sentence for the user.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Stops HDF5 from printing its errors on stderr, in this thread only; every entry point calls this first.
void silence_hdf5();

/// The newest HDF5 error in one line: the call that failed, and the cause at the bottom of the stack.
std::string hdf5_message();

/// Returns a status or an id unchanged; if it is negative, throws a FileError with the HDF5 message.
template <class Status>
Status check(Status status) {
  if (status < 0) throw FileError(hdf5_message());
  return status;
}

/// Runs `action`, and puts `context` (file, path) in front of the message of a FileError that it throws.
template <class Action>
decltype(auto) with_context(const std::string& context, Action&& action) {
  try {
    return action();
  } catch (const FileError& error) {
    throw FileError(context + ": " + error.what());
  }
}

/// Owns one HDF5 id: `Handle space(H5Screate(H5S_SCALAR), H5Sclose);`
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close function) : id_(check(id)), close_(function) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  /// Closes the id now, while a failure can still be reported.
  void close() {
    if (id_ >= 0) check(close_(std::exchange(id_, H5I_INVALID_HID)));
  }

  operator hid_t() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

}  // namespace netloft::formats
