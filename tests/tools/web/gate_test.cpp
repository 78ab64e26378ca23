// The gate: methods, targets, hosts and tokens.
#include "web/site/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

constexpr const char* token = "0123456789abcdef";

Request request_for(const std::string& host) {
  return {.method = "GET", .target = "/api/status", .hosts = {host}, .authorizations = {}, .accept = ""};
}

/// The status of the refusal; 0: none.
unsigned status_of(const Request& request, const Rules& rules = {}) {
  const auto refusal = refuse(request, rules);
  return refusal ? refusal->status : 0;
}

TEST(Gate, LetsInWhoAsksByAddressOrLocalhost) {
  for (const char* host : {"127.0.0.1", "127.0.0.1:4780", "[::1]:4780", "[::1]", "localhost", "LocalHost:1",
                           "192.0.2.7:80", "localhost."}) {
    EXPECT_EQ(status_of(request_for(host)), 0U) << host;
  }
}

TEST(Gate, RefusesTheNameOfAnotherSite) {
  for (const char* host :
       {"evil.example", "evil.example:4780", "localhost.evil.example", "xlocalhost", "robot2.local"}) {
    EXPECT_EQ(status_of(request_for(host)), 421U) << host;
  }
}

TEST(Gate, RefusesANameThatBeginsAsAnAddress) {
  EXPECT_NE(status_of(request_for("127.0.0.1.evil.example")), 0U);
  EXPECT_NE(status_of(request_for("[::1].evil.example")), 0U);
  EXPECT_NE(status_of(request_for("0x7f.1")), 0U);
}

TEST(Gate, RefusesWhatIsNoHost) {
  for (const char* host :
       {"", ":4780", "a b", "user@localhost", "localhost/x", "[::1", "localhost:port", "http://localhost"}) {
    EXPECT_EQ(status_of(request_for(host)), 400U) << host;
  }
}

TEST(Gate, RefusesNoHostAndTwoHosts) {
  Request request = request_for("localhost");
  request.hosts.emplace_back("localhost");
  EXPECT_EQ(status_of(request), 400U);
  request.hosts.clear();
  EXPECT_EQ(status_of(request), 400U);
}

TEST(Gate, LetsInTheNamesThatItIsGiven) {
  const Rules rules{.names = {"robot2.local"}, .token = ""};
  EXPECT_EQ(status_of(request_for("Robot2.Local:4780"), rules), 0U);
  EXPECT_EQ(status_of(request_for("robot3.local"), rules), 421U);
}

TEST(Gate, TakesGetAndHeadOnly) {
  Request request = request_for("localhost");
  for (const char* method : {"GET", "HEAD"}) {
    request.method = method;
    EXPECT_EQ(status_of(request), 0U) << method;
  }
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "get", "BREW"}) {
    request.method = method;
    EXPECT_EQ(status_of(request), 405U) << method;
  }
}

TEST(Gate, BoundsTheTarget) {
  for (const int beyond : {-1, 0, 1}) {
    Request request = request_for("localhost");
    request.target = '/' + std::string(max_target_octets - 1 + static_cast<std::size_t>(beyond), 'a');
    EXPECT_EQ(status_of(request), beyond > 0 ? 414U : 0U) << beyond;
  }
}

TEST(Gate, AsksForTheToken) {
  const Rules rules{.names = {}, .token = token};
  Request request = request_for("localhost");
  EXPECT_EQ(status_of(request, rules), 401U);
  for (const char* right : {"Bearer 0123456789abcdef", "bearer 0123456789abcdef"}) {
    request.authorizations = {right};
    EXPECT_EQ(status_of(request, rules), 0U) << right;
  }
  for (const char* wrong : {"Bearer 0123456789abcdeg", "Bearer 0123456789abcde", "Bearer 0123456789abcdef0", "Bearer ",
                            "Bearer", "0123456789abcdef", "Basic 0123456789abcdef", ""}) {
    request.authorizations = {wrong};
    EXPECT_EQ(status_of(request, rules), 401U) << wrong;
  }
  request.authorizations = {"Bearer 0123456789abcdef", "Bearer 0123456789abcdef"};
  EXPECT_EQ(status_of(request, rules), 401U) << "two are none";
}

TEST(Gate, TellsEverybodyThatTheProgramLives) {
  Request request = request_for("localhost");
  request.target = std::string(open_path);
  EXPECT_EQ(status_of(request, {.names = {}, .token = token}), 0U);
  request.target += "?x=1";
  EXPECT_EQ(status_of(request, {.names = {}, .token = token}), 401U);
}

TEST(Gate, BoundsTokens) {
  for (const int beyond : {-1, 0, 1}) {
    const auto shift = static_cast<std::size_t>(beyond);
    EXPECT_EQ(complaint_about_token(std::string(min_token_octets + shift, 'a')).empty(), beyond >= 0) << beyond;
    EXPECT_EQ(complaint_about_token(std::string(max_token_octets + shift, 'a')).empty(), beyond <= 0) << beyond;
  }
  EXPECT_FALSE(complaint_about_token("0123456789 abcdef").empty());
  EXPECT_FALSE(complaint_about_token("0123456789\nabcdef").empty());
}

}  // namespace
}  // namespace geminga::web
