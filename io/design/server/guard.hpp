// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/server/http.hpp"

#include <optional>
#include <string>

namespace netloft::design {

/// A random text that nobody can guess: 32 hexadecimal digits of the system's random numbers.
std::string random_token();

/// Decides which requests are accepted, because every page in a browser and every user of this machine can
/// reach the server. A request is refused
///   if its Host is not this server, as after DNS rebinding,
///   if the page of another site makes it (Origin, Sec-Fetch-Site),
///   if its address lacks the token,
///   if a form of another site could post it (a Content-Type other than JSON).
class Guard {
 public:
  Guard(int port, std::string token) : port_(port), token_(std::move(token)) {}

  std::string address() const;
  /// The reply to a request that is refused; nullopt if the request is accepted.
  std::optional<HttpReply> refusal(const HttpRequest& request) const;
  /// The part of the target after the token: "api/apply". The request must have been accepted.
  std::string rest_of(const HttpRequest& request) const;

 private:
  bool is_host(const std::string& host) const;

  int port_;
  std::string token_;
};

/// A reply with an error as {"error": "…"}.
HttpReply error_reply(int status, const std::string& sentence);

}  // namespace netloft::design
