// The groups that an interface is given, and dual-stack interfaces.
#include "env/asio/families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::env {
namespace {

namespace ip = boost::asio::ip;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const ip::address group4 = ip::make_address("239.192.47.17");
const ip::address group6 = ip::make_address("ff02::4717");
const std::vector<ip::address> both{group4, group6};

Link link_with(std::uint32_t index, const std::vector<std::string>& addresses) {
  Link link;
  link.interface.index = InterfaceIndex{index};
  link.interface.name = "eth" + std::to_string(index);
  for (const auto& address : addresses) link.prefixes.push_back({ip::make_address(address), 64});
  link.interface.addresses = announced_addresses(link.prefixes);
  return link;
}

TEST(Families, ALinkWithBothIsItselfOnIpv4AndItsTwinOnIpv6) {
  const auto joined = by_family({link_with(2, {"10.0.0.1", "fd00::1", "fe80::1"}), link_with(3, {"10.1.0.1"})}, both);
  ASSERT_THAT(joined, SizeIs(3));
  EXPECT_THAT(joined[0].groups, ElementsAre(group4));
  EXPECT_THAT(joined[0].link.interface.addresses, ElementsAre("10.0.0.1", "fd00::1"));
  EXPECT_FALSE(joined[0].link.interface.ipv6_side_of);
  EXPECT_EQ(joined[1].link.interface.name, "eth3");
  const Interface& twin = joined[2].link.interface;
  EXPECT_THAT(joined[2].groups, ElementsAre(group6));
  EXPECT_EQ(twin.ipv6_side_of, InterfaceIndex{2});
  EXPECT_EQ(twin.index, InterfaceIndex{0x80000002});
  EXPECT_EQ(twin.name, "eth2");
  EXPECT_THAT(twin.addresses, ElementsAre("fd00::1"));
  EXPECT_FALSE(joined[2].link.first_v4());
}

TEST(Families, ATwinWithoutABetterAddressHasItsLinkLocalOne) {
  const auto joined = by_family({link_with(2, {"10.0.0.1", "fe80::1"})}, both);
  ASSERT_THAT(joined, SizeIs(2));
  EXPECT_THAT(joined[0].link.interface.addresses, ElementsAre("10.0.0.1"));
  EXPECT_THAT(joined[1].link.interface.addresses, ElementsAre("fe80::1"));
}

TEST(Families, WithoutIpv4ItHearsNoIpv4ThatItCouldNotAnswer) {
  const auto joined = by_family({link_with(2, {"fe80::1"})}, both);
  ASSERT_THAT(joined, SizeIs(1));
  EXPECT_THAT(joined[0].groups, ElementsAre(group6));
  EXPECT_FALSE(joined[0].link.interface.ipv6_side_of);
}

TEST(Families, OnlyWhereThereAreGroupsOfBoth) {
  for (const auto& groups : {std::vector{group4}, std::vector{group6}, std::vector<ip::address>{}}) {
    const auto joined = by_family({link_with(2, {"10.0.0.1", "fe80::1"})}, groups);
    ASSERT_THAT(joined, SizeIs(1));
    EXPECT_EQ(joined[0].groups, groups);
  }
  const auto without_its_own = by_family({link_with(2, {"fe80::1"})}, {group4});
  EXPECT_THAT(without_its_own[0].groups, ElementsAre(group4));
}

TEST(Families, OneWithoutAddressesYetAndTheLoopbackHearAll) {
  Link loopback = link_with(1, {"127.0.0.1", "::1"});
  loopback.interface.is_loopback = true;
  for (const Link& link : {link_with(2, {}), loopback}) {
    const auto joined = by_family({link}, both);
    ASSERT_THAT(joined, SizeIs(1));
    EXPECT_EQ(joined[0].groups, both);
  }
}

}  // namespace
}  // namespace geminga::env
