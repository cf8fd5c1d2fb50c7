// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/design_server.hpp"

#include "io/design/page/design_page.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/formats/work/long_work.hpp"

#include <charconv>
#include <memory>

namespace netloft::design {

namespace {

constexpr int kMostReaders = 16;                          // streams of events, one for each open page
constexpr std::chrono::seconds kLeft{5};                  // a page that is only reloaded comes back sooner
constexpr std::chrono::milliseconds kBetweenSigns{1000};  // interval of signs of life in a stream of events

/// The number after "after=" in the target, or else the header Last-Event-ID, which a browser sends when it
/// connects again.
std::uint64_t first_event(const HttpRequest& request) {
  const std::size_t at = request.target.find("after=");
  const std::string text =
      at == std::string::npos ? request.header("last-event-id") : request.target.substr(at + 6);
  std::uint64_t id = 0;
  std::from_chars(text.data(), text.data() + text.size(), id);
  return id;
}

std::string event_text(const Event& event) {
  return "id: " + std::to_string(event.id) + "\nevent: " + event.name + "\ndata: " + event.data + "\n\n";
}

/// Headers of every reply: browsers must not store it, show it in a frame, guess its type, or give it to
/// other sites.
void put_headers(HttpReply& reply) {
  reply.headers.insert({{"Cache-Control", "no-store"},
                        {"X-Content-Type-Options", "nosniff"},
                        {"X-Frame-Options", "DENY"},
                        {"Referrer-Policy", "no-referrer"},
                        {"Cross-Origin-Resource-Policy", "same-origin"},
                        {"Cross-Origin-Opener-Policy", "same-origin"}});
}

}  // namespace

DesignServer::DesignServer(Session& session, int port)
    : session_(session),
      server_([this](const HttpRequest& request) { return reply_to(request); }),
      guard_(server_.bind(port), random_token()) {}

void DesignServer::run(const std::atomic<bool>& stop, bool ends_with_page) {
  server_.run([&] {
    const bool is_over = stop || was_left(ends_with_page);
    if (is_over) session_.end();  // requests that still wait get an error
    return is_over;
  });
}

bool DesignServer::was_left(bool ends_with_page) {
  const auto now = std::chrono::steady_clock::now();
  if (!ends_with_page || !was_read_ || readers_ > 0) left_at_ = now;
  return now - left_at_ > kLeft;
}

HttpReply DesignServer::reply_to(const HttpRequest& request) {
  HttpReply reply;
  if (const auto refused = guard_.refusal(request)) {
    reply = *refused;
  } else {
    const std::string rest = guard_.rest_of(request);
    if (request.method == "POST" && rest.starts_with("api/"))
      reply = answer(rest.substr(4), request.body);
    else if (request.method == "GET" && rest.empty())
      reply = page();
    else if (request.method == "GET" && rest.substr(0, rest.find('?')) == "events")
      reply = events(request);
    else
      reply = error_reply(404, "there is nothing at this address");
  }
  put_headers(reply);
  return reply;
}

HttpReply DesignServer::page() const {
  const std::string nonce = random_token();
  return {.type = "text/html; charset=utf-8",
          .body = design_page(nonce),
          .headers = {{"Content-Security-Policy", design_policy(nonce)}}};
}

HttpReply DesignServer::events(const HttpRequest& request) {
  if (readers_ >= kMostReaders) return error_reply(503, "too many pages show this design");
  was_read_ = true;
  ++readers_;
  const std::shared_ptr<void> reader(nullptr, [this](void*) { --readers_; });
  auto last = std::make_shared<std::uint64_t>(first_event(request));
  return {.type = "text/event-stream",
          .stream = [this, reader, last](const std::function<bool(std::string_view)>& send) {
            std::string text;
            for (const Event& event : session_.events_after(*last, kBetweenSigns)) {
              text += event_text(event);
              *last = event.id;
            }
            return !session_.has_ended() && send(text.empty() ? ":\n\n" : text);
          }};
}

HttpReply DesignServer::answer(const std::string& name, const std::string& body) {
  try {
    const Json request = Json::parse(body.empty() ? "{}" : body);
    return {.body = session_.answer(name, request).dump(-1, ' ', false, Json::error_handler_t::replace)};
  } catch (const Json::exception& e) {
    return error_reply(400, std::string("the body cannot be read: ") + e.what());
  } catch (const WrongRequest& e) {
    return error_reply(400, e.what());
  } catch (const Refused& e) {
    return error_reply(422, e.what());
  } catch (const formats::Interrupted&) {
    return error_reply(409, "a newer change has ended this work");
  } catch (const std::exception& e) {  // such as a full disk: only this request fails
    return error_reply(500, e.what());
  }
}

}  // namespace netloft::design
