// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/http_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace netloft::design {

namespace {

constexpr std::size_t kMostHeaders = 100;

constexpr std::array<std::pair<int, const char*>, 15> kReasons{{{200, "OK"},
                                                                {400, "Bad Request"},
                                                                {403, "Forbidden"},
                                                                {404, "Not Found"},
                                                                {405, "Method Not Allowed"},
                                                                {409, "Conflict"},
                                                                {411, "Length Required"},
                                                                {413, "Payload Too Large"},
                                                                {415, "Unsupported Media Type"},
                                                                {422, "Unprocessable Content"},
                                                                {431, "Request Header Fields Too Large"},
                                                                {500, "Internal Server Error"},
                                                                {501, "Not Implemented"},
                                                                {503, "Service Unavailable"},
                                                                {505, "HTTP Version Not Supported"}}};

bool is_token_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_token_character);
}

bool is_visible(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c > 0x20 && c < 0x7F; });
}

std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find("\r\n");
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
  return line;
}

std::string_view trimmed_of_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::optional<HttpFault> read_request_line(std::string_view line, HttpRequest& request) {
  const std::size_t first = line.find(' '), second = line.rfind(' ');
  if (first == std::string_view::npos || second == first) return HttpFault{400, "this is no request of HTTP"};
  const std::string_view target = line.substr(first + 1, second - first - 1);
  if (line.substr(second + 1) != "HTTP/1.1") return HttpFault{505, "HTTP/1.1 is spoken here"};
  if (!is_token(line.substr(0, first)) || !target.starts_with('/') || !is_visible(target))
    return HttpFault{400, "this is no request of HTTP"};
  request.method = line.substr(0, first);
  request.target = target;
  return std::nullopt;
}

std::optional<HttpFault> read_header_line(std::string_view line, HttpRequest& request) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon)))
    return HttpFault{400, "a header has no name"};
  const std::string_view value = trimmed_of_blanks(line.substr(colon + 1));
  const bool is_plain =
      std::ranges::none_of(value, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; });
  if (!is_plain) return HttpFault{400, "a header has control characters"};
  if (!request.headers.emplace(in_lower_case(line.substr(0, colon)), value).second)
    return HttpFault{400, "a header is given twice"};
  return request.headers.size() > kMostHeaders ? std::optional(HttpFault{431, "there are too many headers"})
                                               : std::nullopt;
}

std::optional<HttpFault> read_length(const HttpLimits& limits, HttpHead& head) {
  if (head.request.headers.contains("transfer-encoding"))
    return HttpFault{501, "a body in chunks is not read here; give its Content-Length"};
  if (head.request.headers.contains("expect")) return HttpFault{501, "Expect is not answered here"};
  const std::string& length = head.request.header("content-length");
  if (length.empty())
    return head.request.method == "POST" ? std::optional(HttpFault{411, "give the Content-Length"})
                                         : std::nullopt;
  const auto [end, code] = std::from_chars(length.data(), length.data() + length.size(), head.body_bytes);
  if (code != std::errc() || end != length.data() + length.size())
    return HttpFault{400, "the Content-Length is no number"};
  if (head.body_bytes > limits.body_bytes)
    return HttpFault{413, fmt::format("at most {} bytes are read", limits.body_bytes)};
  return std::nullopt;
}

}  // namespace

const std::string& HttpRequest::header(const std::string& name) const {
  static const std::string none;
  const auto at = headers.find(name);
  return at == headers.end() ? none : at->second;
}

HttpHead read_head(std::string_view bytes, const HttpLimits& limits) {
  HttpHead head;
  head.fault = read_request_line(take_line(bytes), head.request);
  while (!head.fault && !bytes.empty()) head.fault = read_header_line(take_line(bytes), head.request);
  if (!head.fault) head.fault = read_length(limits, head);
  return head;
}

std::string head_of(const HttpReply& reply, bool stays_open) {
  const auto* reason = std::ranges::find(kReasons, reply.status, &std::pair<int, const char*>::first);
  std::string text = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\n", reply.status,
                                 reason == kReasons.end() ? "" : reason->second, reply.type);
  if (!reply.stream) text += fmt::format("Content-Length: {}\r\n", reply.body.size());
  for (const auto& [name, value] : reply.headers) text += name + ": " + value + "\r\n";
  return text + (stays_open ? "Connection: keep-alive\r\n\r\n" : "Connection: close\r\n\r\n");
}

}  // namespace netloft::design
