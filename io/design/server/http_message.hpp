// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/server/http.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace netloft::design {

/// An error of a request, as the status of the reply.
struct HttpFault {
  int status;
  std::string sentence;
};

/// The head of a request, read from the bytes before the empty line.
struct HttpHead {
  HttpRequest request;
  std::size_t body_bytes = 0;
  std::optional<HttpFault> fault = {};
};
HttpHead read_head(std::string_view bytes, const HttpLimits& limits);

/// The head of a reply. A reply with a stream has no length; the connection is closed at its end.
std::string head_of(const HttpReply& reply, bool stays_open);

}  // namespace netloft::design
