// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace netloft::design {

/// A request of HTTP/1.1.
struct HttpRequest {
  std::string method, target;                  // "POST", "/token/api/apply"
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;

  /// The value of a header; empty without it.
  const std::string& header(const std::string& name) const;
};

struct HttpReply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::map<std::string, std::string> headers = {};
  /// Writes the body piece by piece, for streams of events: called until it returns false. `send` returns
  /// false when the other side is gone.
  std::function<bool(const std::function<bool(std::string_view)>& send)> stream = {};
};

/// Limits of a connection.
struct HttpLimits {
  std::size_t header_bytes = std::size_t{16} << 10;
  std::size_t body_bytes = std::size_t{8} << 20;
  std::size_t connections = 128;
  int seconds = 15;  // for a whole request, and for the wait for the next one
};

/// A small server of HTTP/1.1 for this machine alone: it listens on 127.0.0.1. It knows bodies with a length,
/// connections that stay open and bodies that are streamed. What it does not know it refuses: requests in
/// chunks, upgrades, other versions. A general library for servers (cpp-httplib) brings OpenSSL, whose
/// loading takes as long as all else of a start of the program.
class HttpServer {
 public:
  using Handler = std::function<HttpReply(const HttpRequest&)>;

  /// Several threads call `handler` at once.
  explicit HttpServer(Handler handler, HttpLimits limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Binds to a port, any free one if it is 0, and returns it. Throws std::system_error if it is taken.
  int bind(int port);
  /// Serves until `stop` returns true, which is asked several times a second. Then ends all connections.
  void run(const std::function<bool()>& stop);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  int listener_ = -1;
};

}  // namespace netloft::design
