#include "discovery/participant/air/reach_judge.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::participant {
namespace {

using env::RouteKind;
using membership::Reachability;

struct Case {
  std::string address;
  std::string observed;
  RouteKind route;
  Reachability verdict;
};

TEST(ReachJudge, IsCertainOrSaysReachable) {
  using enum Reachability;
  const Case cases[] = {
      // without a route nothing can be reached, whatever the address is
      {"10.47.18.3", "", RouteKind::none, no_route},
      {"203.0.113.5", "", RouteKind::none, no_route},
      {"fd00::5", "", RouteKind::none, no_route},
      {"2001:db8::5", "", RouteKind::none, no_route},
      // a translation and the default route alone: each kind of address for private use
      {"10.0.0.5", "203.0.113.7", RouteKind::fallback, translated},
      {"172.16.0.5", "203.0.113.7", RouteKind::fallback, translated},
      {"192.168.1.5", "10.1.1.1", RouteKind::fallback, translated},
      {"100.64.0.5", "203.0.113.7", RouteKind::fallback, translated},
      {"169.254.7.7", "203.0.113.7", RouteKind::fallback, translated},
      {"fd00::5", "2001:db8::7", RouteKind::fallback, translated},
      // one of the three is missing
      {"10.0.0.5", "", RouteKind::fallback, reachable},
      {"10.0.0.5", "203.0.113.7", RouteKind::specific, reachable},
      {"10.0.0.5", "203.0.113.7", RouteKind::own, reachable},
      {"198.51.100.5", "203.0.113.7", RouteKind::fallback, reachable},
      {"172.32.0.5", "203.0.113.7", RouteKind::fallback, reachable},
      {"100.128.0.5", "203.0.113.7", RouteKind::fallback, reachable},
      {"2001:db8::5", "2001:db8::7", RouteKind::fallback, reachable},
      // nothing is known, or it is no address of a host
      {"10.0.0.5", "203.0.113.7", RouteKind::unknown, reachable},
      {"239.1.2.3", "203.0.113.7", RouteKind::none, reachable},
      {"ff02::1", "", RouteKind::none, reachable},
      {"0.0.0.0", "", RouteKind::none, reachable},
      {"", "", RouteKind::none, reachable},
      {"robot.local", "", RouteKind::none, reachable},
  };
  for (const Case& one : cases) {
    EXPECT_EQ(judged_reach(one.address, one.observed, one.route), one.verdict)
        << one.address << " observed " << one.observed;
  }
}

}  // namespace
}  // namespace geminga::participant
