// The kernel's routes, in a network namespace of the test's own.
#include "env/asio/routes.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include "env/loop.hpp"

namespace geminga::env {
namespace {

bool has_done(const std::string& commands) { return std::system(("set -e; " + commands).c_str()) == 0; }

/// Runs `action` on a thread of its own, with a network of its own: one link with the networks 10.1.0.0/24 and
/// fd01::/64. False: that may not be made here.
bool in_a_network(const std::function<void()>& action) {
  bool is_made = false;
  std::thread([&] {
    if (::unshare(CLONE_NEWNET) != 0) return;
    is_made = has_done(
        "exec 2>/dev/null; ip link set lo up; ip link add one type veth peer name other; ip link set one up; "
        "ip link set other up; ip address add 10.1.0.1/24 dev one; ip address add fd01::1/64 dev one nodad");
    if (is_made) action();
  }).join();
  return is_made;
}

TEST(Routes, TellWhichOneLeadsToAnAddress) {
  const bool is_made = in_a_network([] {
    ASSERT_TRUE(
        has_done("ip route add 10.2.0.0/16 via 10.1.0.2; ip route add unreachable 10.3.0.0/16; "
                 "ip route add prohibit 10.4.0.0/16; ip route add blackhole 10.5.0.0/16; "
                 "ip -6 route add fd02::/64 via fd01::2; ip -6 route add unreachable fd03::/64; "
                 "ip -6 route add blackhole fd05::/64"));
    const std::pair<const char*, RouteKind> always[] = {
        {"127.0.0.1", RouteKind::own},       {"10.1.0.1", RouteKind::own},  {"10.1.0.77", RouteKind::own},
        {"10.2.3.4", RouteKind::specific},   {"10.3.0.1", RouteKind::none}, {"10.4.0.1", RouteKind::none},
        {"10.5.0.1", RouteKind::none},       {"fd01::77", RouteKind::own},  {"fd02::1", RouteKind::specific},
        {"fd03::1", RouteKind::none},        {"fd05::1", RouteKind::none},  {"", RouteKind::unknown},
        {"robot.local", RouteKind::unknown},
    };
    for (const char* further : {"", "ip route add default via 10.1.0.2; ip -6 route add default via fd01::2"}) {
      ASSERT_TRUE(has_done(further[0] == '\0' ? "true" : further));
      for (const auto& [address, route] : always) EXPECT_EQ(find_route(address), route) << address << further;
      const RouteKind rest = further[0] == '\0' ? RouteKind::none : RouteKind::fallback;
      EXPECT_EQ(find_route("192.0.2.1"), rest);
      EXPECT_EQ(find_route("10.9.9.9"), rest);
      EXPECT_EQ(find_route("2001:db8::1"), rest);
    }
  });
  if (!is_made) GTEST_SKIP() << "network namespaces may not be made here";
}

TEST(Routes, AreAskedForAnewWhenTheyChange) {
  const bool is_made = in_a_network([] {
    boost::asio::io_context context;
    int changes = 0;
    Routes routes(context, [&changes] { ++changes; });
    const auto changed = [&changes] { return changes > 0; };
    EXPECT_EQ(routes.find("192.0.2.1"), RouteKind::none);
    ASSERT_TRUE(has_done("ip route add 192.0.2.0/24 via 10.1.0.2"));
    EXPECT_EQ(routes.find("192.0.2.1"), RouteKind::none) << "remembered until the change is told";
    ASSERT_TRUE(run_until(context, changed));
    EXPECT_EQ(routes.find("192.0.2.1"), RouteKind::specific);
    // A link that goes down takes the route away, and the kernel reports the link alone.
    changes = 0;
    ASSERT_TRUE(has_done("ip link set one down"));
    ASSERT_TRUE(run_until(context, changed));
    EXPECT_EQ(routes.find("192.0.2.1"), RouteKind::none);
  });
  if (!is_made) GTEST_SKIP() << "network namespaces may not be made here";
}

}  // namespace
}  // namespace geminga::env
