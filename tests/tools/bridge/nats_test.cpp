// geminga-bridge nats between daemons that have a real nats-server and nothing else between them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "tools/bridge/server_link.hpp"

namespace geminga::system {
namespace {

constexpr const char* server = "/usr/sbin/nats-server";

class Nats : public testing::Test {
 protected:
  void SetUp() override {
    if (::access(server, X_OK) != 0) GTEST_SKIP() << server << " is not installed";
    if (!link_.lab().has_namespaces()) GTEST_SKIP() << "no network namespaces can be made";
  }

  ServerLink link_{{server, "-a", "10.47.17.1"}, "Server is ready", "nats", "nats://10.47.17.1"};
};

TEST_F(Nats, JoinsDaemonsThatHaveNothingElseBetweenThem) {
  expect_team_over(link_);
  link_.bridge(2).signal(SIGTERM);
  EXPECT_EQ(link_.bridge(2).wait(), 0);
  EXPECT_TRUE(link_.lab().wait_for_participants(0, 1));
}

TEST_F(Nats, JoinsASiteThroughItsRelay) { expect_site_over(link_); }

}  // namespace
}  // namespace geminga::system
