// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace netloft::design {

/// Lines of text that two processes send each other.
class LinePipe {
 public:
  LinePipe() = default;
  /// Takes over two file descriptors; they may be the same one.
  LinePipe(int in, int out) : in_(in), out_(out) {}
  ~LinePipe() { close(); }
  LinePipe(LinePipe&& other) noexcept;
  LinePipe& operator=(LinePipe&& other) noexcept;

  void close();
  /// Sends a line; false if the other process has ended.
  bool send(std::string line) const;
  /// The next line if it arrives within this time (negative: however long it takes).
  std::optional<std::string> receive(std::chrono::milliseconds most);
  /// Whether the other process has ended. Lines that it has sent before can no longer be received.
  bool is_closed() const { return is_closed_; }

 private:
  int in_ = -1, out_ = -1;
  bool is_closed_ = false;
  std::string buffer_;
};

}  // namespace netloft::design
