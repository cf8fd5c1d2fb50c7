// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/line_pipe.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace netloft::design {

LinePipe::LinePipe(LinePipe&& other) noexcept { *this = std::move(other); }

LinePipe& LinePipe::operator=(LinePipe&& other) noexcept {
  std::swap(in_, other.in_);
  std::swap(out_, other.out_);
  std::swap(is_closed_, other.is_closed_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

void LinePipe::close() {
  if (in_ >= 0) ::close(in_);
  if (out_ >= 0 && out_ != in_) ::close(out_);
  in_ = out_ = -1;
}

bool LinePipe::send(std::string line) const {
  line += '\n';
  std::string_view left = line;
  while (!left.empty()) {
    const ssize_t n = ::send(out_, left.data(), left.size(), MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    left.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::optional<std::string> LinePipe::receive(std::chrono::milliseconds most) {
  constexpr std::size_t kBlock = 65536;
  for (;;) {
    if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
      std::string line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return line;
    }
    pollfd one{in_, POLLIN, 0};
    if (const int ready = ::poll(&one, 1, static_cast<int>(most.count())); ready < 0 && errno == EINTR)
      continue;
    else if (ready == 0)
      return std::nullopt;
    const std::size_t before = buffer_.size();
    buffer_.resize(before + kBlock);
    const ssize_t n = ::recv(in_, buffer_.data() + before, kBlock, 0);
    buffer_.resize(before + static_cast<std::size_t>(n > 0 ? n : 0));
    if (n < 0 && errno == EINTR) continue;
    is_closed_ = n <= 0;
    if (is_closed_) return std::nullopt;
  }
}

}  // namespace netloft::design
