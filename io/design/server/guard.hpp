// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/server/http.hpp"

#include <optional>
#include <string>

namespace netloft::design {

/// A random text that nobody can guess: 32 hexadecimal digits of the system's random numbers.
std::string random_token();

/// Decides which requests are heard. A server on this machine can be reached by every page that a browser
/// shows, and by every user of the machine. Refused is a request
///   whose Host is not this server, as after DNS rebinding,
///   that the page of another site makes (Origin, Sec-Fetch-Site),
///   whose address lacks the token,
///   that a form of another site could post (a Content-Type other than JSON).
class Guard {
 public:
  Guard(int port, std::string token) : port_(port), token_(std::move(token)) {}

  std::string address() const;
  /// The reply to a request that is refused; nullopt if it is heard.
  std::optional<HttpReply> refusal(const HttpRequest& request) const;
  /// The part of the target behind the token: "api/apply". Requires that the request is heard.
  std::string rest_of(const HttpRequest& request) const;

 private:
  bool is_host(const std::string& host) const;

  int port_;
  std::string token_;
};

/// A reply with an error as {"error": "…"}.
HttpReply error_reply(int status, const std::string& sentence);

}  // namespace netloft::design
