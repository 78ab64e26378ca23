#include "env/asio/links.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/socket.h>

#include <string>

namespace geminga::env {
namespace {

namespace ip = boost::asio::ip;

Link link_with(const std::vector<std::pair<std::string, unsigned>>& prefixes) {
  Link link;
  for (const auto& [address, length] : prefixes) link.prefixes.push_back({ip::make_address(address), length});
  return link;
}

TEST(Link, TellsWhoIsOnLink) {
  const Link link = link_with({{"10.1.2.3", 22}, {"fd00::1", 64}, {"fe80::1", 64}});
  EXPECT_TRUE(link.is_on_link(ip::make_address("10.1.2.99")));
  EXPECT_TRUE(link.is_on_link(ip::make_address("10.1.0.1"))) << "inside the 22 bits";
  EXPECT_FALSE(link.is_on_link(ip::make_address("10.1.4.1"))) << "outside the 22 bits";
  EXPECT_FALSE(link.is_on_link(ip::make_address("192.0.2.1")));
  EXPECT_TRUE(link.is_on_link(ip::make_address("fd00::ffff")));
  EXPECT_FALSE(link.is_on_link(ip::make_address("fd01::1")));
  EXPECT_TRUE(link.is_on_link(ip::make_address("fe80::abcd"))) << "link-local is on link";
}

TEST(Link, WithoutAnAddressOfAFamilyCannotJudgeIt) {
  const Link only_link_local = link_with({{"fe80::1", 64}});
  EXPECT_TRUE(only_link_local.is_on_link(ip::make_address("10.0.0.1")));
  EXPECT_TRUE(only_link_local.is_on_link(ip::make_address("fd00::1")));
  const Link only_v4 = link_with({{"10.0.0.1", 32}});
  EXPECT_FALSE(only_v4.is_on_link(ip::make_address("10.0.0.2")));
  EXPECT_TRUE(only_v4.is_on_link(ip::make_address("fd00::1")));
}

TEST(Link, KnowsItsOwnAddresses) {
  const Link link = link_with({{"fd00::1", 64}, {"10.0.0.1", 8}});
  EXPECT_TRUE(link.has_address(ip::make_address("10.0.0.1")));
  EXPECT_FALSE(link.has_address(ip::make_address("10.0.0.2")));
  EXPECT_EQ(link.first_v4(), ip::make_address_v4("10.0.0.1"));
  EXPECT_FALSE(link_with({{"fd00::1", 64}}).first_v4());
}

TEST(Scan, FindsALinkWithoutAnAddressOfItsOwn) {
  std::string name = "lo";
  ifaddrs entry{};  // as getifaddrs() shows a TUN device
  entry.ifa_name = name.data();
  EXPECT_EQ(link_of(entry), InterfaceIndex{::if_nametoindex("lo")});
  sockaddr address{};
  address.sa_family = AF_INET;
  entry.ifa_addr = &address;
  EXPECT_FALSE(link_of(entry)) << "an address of a link, and not the link";
}

TEST(Scan, LeavesTheLoopbackOutUnlessItIsNamed) {
  for (const Link& link : scan_links({})) EXPECT_FALSE(link.interface.is_loopback) << link.interface.name;
  const auto named = scan_links({"lo", "no-such-link"});
  ASSERT_THAT(named, testing::SizeIs(1));
  EXPECT_EQ(named[0].interface.name, "lo");
  EXPECT_TRUE(named[0].interface.is_loopback);
  EXPECT_THAT(named[0].interface.addresses, testing::Contains("127.0.0.1"));
  EXPECT_TRUE(named[0].is_on_link(ip::make_address("127.0.0.1")));
}

}  // namespace
}  // namespace geminga::env
