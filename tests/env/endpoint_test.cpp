#include "env/asio/endpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::env {
namespace {

using testing::HasSubstr;

TEST(Endpoint, IsReadAndWrittenTheSame) {
  for (const char* text : {"127.0.0.1:4717", "[::1]:4717", "0.0.0.0:1", "[fd00::7]:65535"}) {
    const auto endpoint = parse_endpoint(text);
    ASSERT_TRUE(endpoint) << text << ": " << endpoint.error();
    EXPECT_EQ(to_string(*endpoint), text);
  }
  EXPECT_EQ(parse_endpoint("[0:0:0:0:0:0:0:1]:7")->address, "::1") << "the writing is canonical";
}

TEST(Endpoint, IsRefusedWithAReason) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "no ADDRESS:PORT"},          {"127.0.0.1", "no ADDRESS:PORT"},       {"::1", "no ADDRESS:PORT"},
      {"::1:4717", "no ADDRESS:PORT"},  {"[::1]", "no ADDRESS:PORT"},           {"[::1", "no ADDRESS:PORT"},
      {"[::1]4717", "no ADDRESS:PORT"}, {"[127.0.0.1]:1", "no ADDRESS:PORT"},   {"127.0.0.1:", "is no port"},
      {"127.0.0.1:0", "is no port"},    {"127.0.0.1:65536", "is no port"},      {"127.0.0.1:+1", "is no port"},
      {"127.0.0.1: 1", "is no port"},   {"127.0.0.256:1", "is no IP address"},  {"localhost:1", "is no IP address"},
      {":1", "is no IP address"},       {"[fe80::1%lo]:1", "is no IP address"}, {"1.2.3:1", "is no IP address"},
  };
  for (const auto& [text, words] : cases) {
    const auto endpoint = parse_endpoint(text);
    ASSERT_FALSE(endpoint) << text;
    EXPECT_THAT(endpoint.error(), HasSubstr(words)) << text;
  }
}

TEST(HostPort, TakesNumbersAndNames) {
  constexpr std::uint16_t otherwise = 4717;
  EXPECT_EQ(parse_host_port("robot2", otherwise), (HostPort{"robot2", 4717}));
  EXPECT_EQ(parse_host_port("robot-2.team.local:99", otherwise), (HostPort{"robot-2.team.local", 99}));
  EXPECT_EQ(parse_host_port("192.0.2.7", otherwise), (HostPort{"192.0.2.7", 4717}));
  EXPECT_EQ(parse_host_port("192.0.2.7:1", otherwise), (HostPort{"192.0.2.7", 1}));
  EXPECT_EQ(parse_host_port("fd00::7", otherwise), (HostPort{"fd00::7", 4717}));
  EXPECT_EQ(parse_host_port("[fd00::7]:1", otherwise), (HostPort{"fd00::7", 1}));
  EXPECT_EQ(to_string(HostPort{"fd00::7", 1}), "[fd00::7]:1");
  EXPECT_EQ(to_string(HostPort{"robot2", 1}), "robot2:1");
}

TEST(HostPort, IsNoTextWithOtherCharacters) {
  for (const char* text : {"", ":1", "a b", "a/b", "robot\xff", "robot:x", "robot:0", "[robot]", "[::1"}) {
    EXPECT_FALSE(parse_host_port(text, 1)) << text;
  }
}

TEST(HostPort, HasANameOfAtMost253Octets) {
  EXPECT_TRUE(parse_host_port(std::string(max_host_bytes - 1, 'a'), 1));
  EXPECT_TRUE(parse_host_port(std::string(max_host_bytes, 'a'), 1));
  EXPECT_FALSE(parse_host_port(std::string(max_host_bytes + 1, 'a'), 1));
}

TEST(Address, KnowsLoopbackAndMulticast) {
  EXPECT_TRUE(is_loopback("127.0.0.1"));
  EXPECT_TRUE(is_loopback("127.9.9.9"));
  EXPECT_TRUE(is_loopback("::1"));
  EXPECT_FALSE(is_loopback("0.0.0.0"));
  EXPECT_FALSE(is_loopback("::"));
  EXPECT_FALSE(is_loopback("192.0.2.1"));
  EXPECT_TRUE(is_multicast("239.192.47.17"));
  EXPECT_TRUE(is_multicast("ff02::4717"));
  EXPECT_FALSE(is_multicast("192.0.2.1"));
  EXPECT_FALSE(is_multicast("fe80::1"));
}

}  // namespace
}  // namespace geminga::env
