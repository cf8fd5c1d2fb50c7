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

  /// The value of a header; empty if the request does not have it.
  const std::string& header(const std::string& name) const;
};

struct HttpReply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::map<std::string, std::string> headers = {};
  /// Writes the body piece by piece, for streams of events. It is called until it returns false. `send`
  /// returns false when the other side has closed the connection.
  std::function<bool(const std::function<bool(std::string_view)>& send)> stream = {};
};

/// Limits of a connection.
struct HttpLimits {
  std::size_t header_bytes = std::size_t{16} << 10;
  std::size_t body_bytes = std::size_t{8} << 20;
  std::size_t connections = 128;
  int seconds = 15;  // limit for a whole request, and for the wait for the next one
};

/// A small HTTP/1.1 server for this machine only: it listens on 127.0.0.1. It supports bodies with a length,
/// persistent connections and streamed bodies; it refuses everything else, such as chunked requests, upgrades
/// and other versions. A general library (cpp-httplib) would need OpenSSL, and loading OpenSSL would double
/// the start-up time of the program.
class HttpServer {
 public:
  using Handler = std::function<HttpReply(const HttpRequest&)>;

  /// Several threads may call `handler` at the same time.
  explicit HttpServer(Handler handler, HttpLimits limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Binds to `port`, or to a free port if `port` is 0, and returns the port. Throws std::system_error if it
  /// is in use.
  int bind(int port);
  /// Serves until `stop`, which is called several times a second, returns true. Then ends all connections.
  void run(const std::function<bool()>& stop);

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  int listener_ = -1;
};

}  // namespace netloft::design
