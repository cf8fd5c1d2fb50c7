// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/server/guard.hpp"
#include "io/design/session/session.hpp"

#include <atomic>
#include <functional>
#include <string>

namespace netloft::design {

/// Serves a session to a page in a browser and to other programs (DESIGN.md). Only those who know the address
/// of the server can use it: see Guard.
class DesignServer {
 public:
  /// Binds to `port` of 127.0.0.1, or to a free port if `port` is 0. Throws std::system_error if the port is
  /// in use.
  DesignServer(Session& session, int port);

  std::string address() const { return guard_.address(); }
  /// Serves until `stop` is set. `ends_with_page`: also ends when no page has been open for several seconds.
  void run(const std::atomic<bool>& stop, bool ends_with_page);

 private:
  HttpReply reply_to(const HttpRequest& request);
  HttpReply page() const;
  HttpReply events(const HttpRequest& request);
  HttpReply answer(const std::string& name, const std::string& body);
  bool was_left(bool ends_with_page);

  Session& session_;
  HttpServer server_;
  Guard guard_;
  std::atomic<int> readers_{0};  // of events
  std::atomic<bool> was_read_{false};
  std::chrono::steady_clock::time_point left_at_{};
};

}  // namespace netloft::design
