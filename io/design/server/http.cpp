// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/http.hpp"

#include "io/design/server/http_message.hpp"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

namespace netloft::design {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBetweenStops = 200;  // interval at which `stop` is called [ms]

[[noreturn]] void throw_errno(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// One connection: reads requests and writes replies, within time limits.
class Connection {
 public:
  Connection(int socket, const HttpLimits& limits) : socket_(socket), limits_(limits) {}

  void serve(const HttpServer::Handler& handler, const std::atomic<bool>& ends) {
    while (!ends) {
      HttpRequest request;
      const auto fault = receive(request);
      if (is_gone_) return;
      if (fault) {
        send_reply({.status = fault->status, .body = "{\"error\": \"" + fault->sentence + "\"}"}, false);
        return;
      }
      const HttpReply reply = handler(request);
      const bool stays_open = !reply.stream && request.header("connection") != "close";
      if (!send_reply(reply, stays_open) || !stays_open) return;
    }
  }

 private:
  std::optional<HttpFault> receive(HttpRequest& request) {
    deadline_ = Clock::now() + std::chrono::seconds(limits_.seconds);
    std::size_t end = std::string::npos;
    while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
      if (buffer_.size() > limits_.header_bytes) return HttpFault{431, "the head is too long"};
      if (!receive_more()) return std::nullopt;
    }
    if (end > limits_.header_bytes) return HttpFault{431, "the head is too long"};
    HttpHead head = read_head(std::string_view(buffer_).substr(0, end + 2), limits_);
    buffer_.erase(0, end + 4);
    if (head.fault) return head.fault;
    while (buffer_.size() < head.body_bytes)
      if (!receive_more()) return std::nullopt;
    request = std::move(head.request);
    request.body = buffer_.substr(0, head.body_bytes);
    buffer_.erase(0, head.body_bytes);
    return std::nullopt;
  }

  /// Waits until the socket is ready; false after the deadline.
  bool wait(short what) const {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    pollfd one{socket_, what, 0};
    return left > 0 && ::poll(&one, 1, static_cast<int>(left)) > 0;
  }

  bool receive_more() {
    char block[16384];
    const ssize_t n = wait(POLLIN) ? ::recv(socket_, block, sizeof block, 0) : 0;
    is_gone_ = n <= 0;
    if (!is_gone_) buffer_.append(block, static_cast<std::size_t>(n));
    return !is_gone_;
  }

  bool send_all(std::string_view bytes) {
    deadline_ = Clock::now() + std::chrono::seconds(limits_.seconds);
    while (!bytes.empty()) {
      const ssize_t n =
          wait(POLLOUT) ? ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) : -1;
      if (n < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }

  /// Whether the other side has closed the connection.
  bool is_closed() const {
    char one;
    return ::recv(socket_, &one, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  }

  bool send_reply(const HttpReply& reply, bool stays_open) {
    if (!send_all(head_of(reply, stays_open) + reply.body)) return false;
    if (!reply.stream) return true;
    const auto send = [this](std::string_view bytes) { return send_all(bytes); };
    while (!is_closed() && reply.stream(send)) {
    }
    return false;
  }

  int socket_;
  const HttpLimits& limits_;
  Clock::time_point deadline_;
  std::string buffer_;
  bool is_gone_ = false;
};

}  // namespace

/// State that the threads of connections share with the server.
struct HttpServer::Shared {
  Handler handler;
  HttpLimits limits;
  std::atomic<bool> ends{false};
  std::mutex mutex;
  std::condition_variable none_left;
  std::set<int> sockets;

  void serve(int socket) {
    try {
      Connection(socket, limits).serve(handler, ends);
    } catch (const std::exception&) {  // for instance too little memory: only this connection ends
    }
    const std::lock_guard lock(mutex);
    sockets.erase(socket);
    ::close(socket);
    none_left.notify_all();
  }
};

HttpServer::HttpServer(Handler handler, HttpLimits limits) : shared_(std::make_shared<Shared>()) {
  shared_->handler = std::move(handler);
  shared_->limits = limits;
}

HttpServer::~HttpServer() {
  if (listener_ >= 0) ::close(listener_);
}

int HttpServer::bind(int port) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (listener_ < 0) throw_errno("no socket can be opened");
  const int on = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof address;
  auto* any = reinterpret_cast<sockaddr*>(&address);
  if (::bind(listener_, any, size) != 0 || ::listen(listener_, SOMAXCONN) != 0 ||
      ::getsockname(listener_, any, &size) != 0)
    throw_errno("port " + std::to_string(port) + " of 127.0.0.1 cannot be listened to");
  return ntohs(address.sin_port);
}

void HttpServer::run(const std::function<bool()>& stop) {
  while (!stop()) {
    pollfd one{listener_, POLLIN, 0};
    if (::poll(&one, 1, kBetweenStops) <= 0) continue;
    const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket < 0) continue;
    const int on = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    const std::lock_guard lock(shared_->mutex);
    if (shared_->sockets.size() >= shared_->limits.connections) {
      ::close(socket);
      continue;
    }
    try {
      std::thread([shared = shared_, socket] { shared->serve(socket); }).detach();
      shared_->sockets.insert(socket);
    } catch (const std::system_error&) {  // the system provides no more threads
      ::close(socket);
    }
  }
  std::unique_lock lock(shared_->mutex);
  shared_->ends = true;
  for (const int socket : shared_->sockets) ::shutdown(socket, SHUT_RDWR);
  shared_->none_left.wait(lock, [&] { return shared_->sockets.empty(); });
}

}  // namespace netloft::design
