// The addresses of a named host, and when its name is resolved again.
#include "env/asio/named_peer.hpp"

#include <gtest/gtest.h>

namespace geminga::env {
namespace {

namespace ip = boost::asio::ip;
using std::chrono::seconds;

constexpr Clock::time_point start{std::chrono::hours(1)};
const ip::address first = ip::make_address("192.0.2.7");
const ip::address second = ip::make_address("192.0.2.8");
const ip::address third = ip::make_address("2001:db8::7");

ip::address target(const NamedPeer& peer) {
  return peer.route() == nullptr ? ip::address() : peer.route()->to.address();
}

TEST(NamedPeer, ByNumberIsThereAtOnceAndNeverLookedAt) {
  const NamedPeer peer({"192.0.2.7", 4718}, start);
  EXPECT_EQ(target(peer), first);
  EXPECT_EQ(peer.route()->to.port(), 4718);
  EXPECT_FALSE(peer.is_due(start + seconds(1000)));
}

TEST(NamedPeer, ByNameIsTriedUntilItResolves) {
  NamedPeer peer({"robot2", 4717}, start);
  EXPECT_TRUE(peer.is_due(start));
  EXPECT_EQ(peer.route(), nullptr);
  for (int i = 0; i < 10; ++i) peer.take({}, start);
  EXPECT_FALSE(peer.is_due(start + resolve_retry - seconds(1)));
  EXPECT_TRUE(peer.is_due(start + resolve_retry)) << "what does not resolve is tried no less often";
  peer.take({third, first, first}, start + resolve_retry);
  EXPECT_EQ(target(peer), first) << "IPv4 before IPv6";
  EXPECT_TRUE(peer.is_at(third));
  EXPECT_FALSE(peer.is_at(second));
}

TEST(NamedPeer, WhileItIsHeardItsNameIsLookedAtRarely) {
  NamedPeer peer({"robot2", 4717}, start);
  peer.take({first}, start);
  Clock::time_point now = start;
  for (; now < start + resolve_refresh; now += seconds(2)) {
    peer.heard_from(first, now);
    EXPECT_FALSE(peer.is_due(now + seconds(1)));
  }
  peer.heard_from(first, now);
  EXPECT_TRUE(peer.is_due(now));
}

TEST(NamedPeer, WhenItFallsSilentItMayHaveMoved) {
  NamedPeer peer({"robot2", 4717}, start);
  peer.take({first}, start);
  peer.heard_from(first, start + seconds(100));
  Clock::time_point now = start + seconds(100) + peer_silence;
  EXPECT_FALSE(peer.is_due(now - seconds(1)));
  EXPECT_TRUE(peer.is_due(now));
  peer.take({second}, now);
  EXPECT_EQ(target(peer), second);
  EXPECT_FALSE(peer.is_at(first)) << "whoever has that address now is somebody else";
  std::chrono::seconds pause = resolve_retry;
  while (pause < slowest_look) {
    EXPECT_FALSE(peer.is_due(now + pause - seconds(1)));
    now += pause;
    EXPECT_TRUE(peer.is_due(now));
    peer.take({second}, now);
    pause *= 2;
  }
  EXPECT_FALSE(peer.is_due(now + slowest_look - seconds(1)));
  EXPECT_TRUE(peer.is_due(now + slowest_look)) << "no less often than that";
  peer.heard_from(second, now + seconds(1));
  EXPECT_TRUE(peer.is_due(now + seconds(1) + peer_silence));
}

TEST(NamedPeer, IsTriedAtAllItsAddressesUntilItIsHeardFromOne) {
  NamedPeer peer({"robot2", 4717}, start);
  peer.take({first, second, third}, start);
  EXPECT_EQ(target(peer), first);
  peer.take({first, second, third}, start + seconds(5));
  EXPECT_EQ(target(peer), second);
  peer.take({third, second, first}, start + seconds(10));
  EXPECT_EQ(target(peer), first) << "the one after it, in the new order";
  peer.heard_from(third, start + seconds(11));
  EXPECT_EQ(target(peer), third);
  peer.take({first, second, third}, start + seconds(40));
  EXPECT_EQ(target(peer), third) << "silence alone does not move it";
  peer.take({first, second, third}, start + seconds(11) + resolve_refresh + seconds(1));
  EXPECT_EQ(target(peer), first);
  peer.take({}, start + seconds(1000));
  EXPECT_EQ(target(peer), first) << "a name that resolves no more keeps its address";
}

TEST(NamedPeer, HasAtMostTheNamedNumberOfAddresses) {
  NamedPeer peer({"robot2", 4717}, start);
  std::vector<ip::address> many;
  for (unsigned i = 0; i <= max_peer_addresses; ++i) many.emplace_back(ip::address_v4(0xc0000200 + i));
  peer.take(many, start);
  EXPECT_TRUE(peer.is_at(many[max_peer_addresses - 1]));
  EXPECT_FALSE(peer.is_at(many[max_peer_addresses]));
}

TEST(NamedPeer, MayBeOurselves) {
  NamedPeer peer({"192.0.2.7", 4717}, start);
  const auto here = [](const ip::udp::endpoint& to) { return std::optional(to.address()); };
  peer.find_routes(4718, here);
  EXPECT_FALSE(peer.is_ourselves()) << "another daemon of this host";
  peer.find_routes(4717, here);
  EXPECT_TRUE(peer.is_ourselves());
  EXPECT_EQ(peer.route(), nullptr);
}

}  // namespace
}  // namespace geminga::env
