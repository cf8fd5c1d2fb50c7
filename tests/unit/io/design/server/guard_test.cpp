// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/guard.hpp"

#include <gtest/gtest.h>

#include "io/design/server/http_message.hpp"

namespace netloft::design {
namespace {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

HttpRequest good() {
  return {"POST",
          std::string("/") + kToken + "/api/state",
          {{"host", "127.0.0.1:8000"}, {"content-type", "application/json"}},
          "{}"};
}

int status_of(const HttpRequest& request) {
  const auto refused = Guard(8000, kToken).refusal(request);
  return refused ? refused->status : 200;
}

TEST(Guard, HearsThePageAndProgramsOfThisMachine) {
  EXPECT_EQ(status_of(good()), 200);
  HttpRequest request = good();
  request.headers["host"] = "localhost:8000";
  request.headers["origin"] = "http://localhost:8000";
  request.headers["sec-fetch-site"] = "same-origin";
  request.headers["content-type"] = "application/json; charset=utf-8";
  EXPECT_EQ(status_of(request), 200);
  EXPECT_EQ(Guard(8000, kToken).rest_of(request), "api/state");
}

TEST(Guard, RefusesOtherHostsSitesAndTokens) {
  struct Attack {
    const char *header, *value;
    int status;
  };
  for (const auto& [header, value, status] :
       std::initializer_list<Attack>{{"host", "evil.example", 403},
                                     {"host", "evil.example:8000", 403},
                                     {"host", "127.0.0.1:8001", 403},
                                     {"host", "127.0.0.1", 403},
                                     {"host", "", 403},
                                     {"host", "127.0.0.1:8000.evil.example", 403},
                                     {"origin", "http://evil.example", 403},
                                     {"origin", "null", 403},
                                     {"origin", "https://127.0.0.1:8000", 403},
                                     {"origin", "http://127.0.0.1:8001", 403},
                                     {"origin", "http://localhost:8000", 403},
                                     {"sec-fetch-site", "cross-site", 403},
                                     {"sec-fetch-site", "same-site", 403},
                                     {"content-type", "text/plain", 415},
                                     {"content-type", "application/x-www-form-urlencoded", 415},
                                     {"content-type", "multipart/form-data; boundary=x", 415},
                                     {"content-type", "", 415}}) {
    HttpRequest request = good();
    request.headers[header] = value;
    EXPECT_EQ(status_of(request), status) << header << ": " << value;
  }
  for (const std::string target :
       {"/", "/api/state", "//api/state", "/0123456789abcdef0123456789abcdeF/api/state", "/0/api/state",
        "/../0123456789abcdef0123456789abcdef/api/state", "/0123456789abcdef0123456789abcdef"}) {
    HttpRequest request = good();
    request.target = target;
    EXPECT_EQ(status_of(request), 403) << target;
  }
  HttpRequest request = good();
  request.method = "DELETE";
  EXPECT_EQ(status_of(request), 405);
}

TEST(Guard, MakesTokensThatDiffer) {
  EXPECT_EQ(random_token().size(), 32u);
  EXPECT_NE(random_token(), random_token());
}

TEST(HttpMessage, ReadsARequest) {
  const HttpHead head = read_head("POST /a/b HTTP/1.1\r\nHost: x\r\nContent-Length:  12 \r\n", {});
  EXPECT_FALSE(head.fault);
  EXPECT_EQ(head.request.method, "POST");
  EXPECT_EQ(head.request.target, "/a/b");
  EXPECT_EQ(head.request.header("host"), "x");
  EXPECT_EQ(head.body_bytes, 12u);
}

TEST(HttpMessage, RefusesWhatIsNoRequest) {
  struct Wrong {
    const char* bytes;
    int status;
  };
  for (const auto& [bytes, status] :
       std::initializer_list<Wrong>{{"", 400},
                                    {"GET", 400},
                                    {"GET /\r\n", 400},
                                    {"GET / HTTP/1.0\r\n", 505},
                                    {"GET / HTTP/2\r\n", 505},
                                    {"GET x HTTP/1.1\r\n", 400},
                                    {"GET http://evil.example/ HTTP/1.1\r\n", 400},
                                    {"GET /a b HTTP/1.1\r\n", 400},
                                    {"G(T / HTTP/1.1\r\n", 400},
                                    {"GET / HTTP/1.1\r\nno colon\r\n", 400},
                                    {"GET / HTTP/1.1\r\n: x\r\n", 400},
                                    {"GET / HTTP/1.1\r\nHost: a\r\nhost: b\r\n", 400},
                                    {"GET / HTTP/1.1\r\nA: x\x01\r\n", 400},
                                    {"POST / HTTP/1.1\r\n", 411},
                                    {"POST / HTTP/1.1\r\nContent-Length: -1\r\n", 400},
                                    {"POST / HTTP/1.1\r\nContent-Length: 1x\r\n", 400},
                                    {"POST / HTTP/1.1\r\nContent-Length: 99999999999999999999999\r\n", 400},
                                    {"POST / HTTP/1.1\r\nContent-Length: 999999999\r\n", 413},
                                    {"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n", 501},
                                    {"POST / HTTP/1.1\r\nExpect: 100-continue\r\n", 501}}) {
    const HttpHead head = read_head(bytes, {});
    ASSERT_TRUE(head.fault) << bytes;
    EXPECT_EQ(head.fault->status, status) << bytes;
  }
}

}  // namespace
}  // namespace netloft::design
