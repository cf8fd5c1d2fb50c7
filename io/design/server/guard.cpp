// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/guard.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <random>

namespace netloft::design {

namespace {

/// Compares two texts in a time that does not reveal where they differ.
bool are_equal_in_fixed_time(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

std::string random_token() {
  std::random_device system;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", system(), system(), system(), system());
}

std::string Guard::address() const { return fmt::format("http://127.0.0.1:{}/{}/", port_, token_); }

bool Guard::is_host(const std::string& host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

std::optional<HttpReply> Guard::refusal(const HttpRequest& request) const {
  const std::string& host = request.header("host");
  if (!is_host(host)) return error_reply(403, "this server answers only under its own address");
  const std::string& origin = request.header("origin");
  if (!origin.empty() && origin != "http://" + host)
    return error_reply(403, "pages of other sites are not answered");
  const std::string& site = request.header("sec-fetch-site");
  if (!site.empty() && site != "same-origin" && site != "none")
    return error_reply(403, "pages of other sites are not answered");
  const std::string_view target = request.target;
  const std::size_t end = target.find('/', 1);
  if (end == std::string_view::npos || !are_equal_in_fixed_time(target.substr(1, end - 1), token_))
    return error_reply(403, "the address lacks the token that the program printed");
  if (request.method != "GET" && request.method != "POST")
    return error_reply(405, "requests are GET or POST");
  const std::string& type = request.header("content-type");
  if (request.method == "POST" && type.substr(0, type.find(';')) != "application/json")
    return error_reply(415, "bodies are JSON: Content-Type: application/json");
  return std::nullopt;
}

std::string Guard::rest_of(const HttpRequest& request) const {
  return request.target.substr(token_.size() + 2);
}

HttpReply error_reply(int status, const std::string& sentence) {
  const nlohmann::ordered_json json = {{"error", sentence}};
  return {.status = status,
          .body = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)};
}

}  // namespace netloft::design
