#include "client/channels/endpoint.hpp"

#include <gtest/gtest.h>

namespace geminga::client {
namespace {

TEST(Endpoint, IsAddressAndPort) {
  EXPECT_EQ(endpoint("127.0.0.1:4717"), (Endpoint{"127.0.0.1", 4717}));
  EXPECT_EQ(endpoint("[::1]:65535"), (Endpoint{"::1", 65535}));
  EXPECT_EQ(to_string(Endpoint{"127.0.0.1", 4717}), "127.0.0.1:4717");
  EXPECT_EQ(to_string(Endpoint{"::1", 4717}), "[::1]:4717");
}

TEST(Endpoint, IsAPathToo) {
  EXPECT_EQ(endpoint("/run/geminga/gcnp"), (Endpoint{"", 0, "/run/geminga/gcnp"}));
  EXPECT_EQ(endpoint("unix:/run/a:1"), (Endpoint{"", 0, "/run/a:1"}));
  EXPECT_EQ(endpoint("unix:here"), (Endpoint{"", 0, "here"}));
  EXPECT_EQ(to_string(Endpoint{"", 0, "/run/gcnp"}), "/run/gcnp");
}

TEST(Endpoint, IsNothingElse) {
  for (const char* text : {"", ":", "4717", "127.0.0.1", "127.0.0.1:", "127.0.0.1:0", "127.0.0.1:65536", ":4717",
                           "::1:4717", "[]:1", "[::1]", "127.0.0.1:47 17", "unix:"}) {
    EXPECT_EQ(endpoint(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace geminga::client
