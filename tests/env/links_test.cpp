#include "env/asio/links.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "env/asio/virtual_links.hpp"

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
  const auto all = scan_links({});
  ASSERT_TRUE(all);
  for (const Link& link : all->links) EXPECT_FALSE(link.interface.is_loopback) << link.interface.name;
  const auto scan = scan_links({"lo", "no-such-link"});
  ASSERT_TRUE(scan);
  const auto& named = scan->links;
  ASSERT_THAT(named, testing::SizeIs(1));
  EXPECT_EQ(named[0].interface.name, "lo");
  EXPECT_TRUE(named[0].interface.is_loopback);
  EXPECT_THAT(named[0].interface.addresses, testing::Contains("127.0.0.1"));
  EXPECT_TRUE(named[0].is_on_link(ip::make_address("127.0.0.1")));
}

std::vector<LinkRank> ranks(std::uint32_t virtual_ones, std::uint32_t others) {
  std::vector<LinkRank> found;
  for (std::uint32_t index = 1; index <= virtual_ones + others; ++index) {
    const bool is_virtual = index <= virtual_ones;
    const std::string name = (is_virtual ? "veth" : "wlan") + std::to_string(index);
    found.push_back({.index = InterfaceIndex{index}, .name = name, .is_virtual = is_virtual});
  }
  return found;
}

TEST(Scan, IgnoresVirtualLinksBeforeOthersAndNamesThem) {
  auto found = ranks(max_links - 2, 1);
  EXPECT_THAT(take_ignored(found), testing::IsEmpty());
  EXPECT_THAT(found, testing::SizeIs(max_links - 1));
  found = ranks(max_links - 1, 1);
  EXPECT_THAT(take_ignored(found), testing::IsEmpty());
  EXPECT_THAT(found, testing::SizeIs(max_links));
  found = ranks(max_links, 1);
  EXPECT_THAT(take_ignored(found), testing::ElementsAre("veth64"));
  ASSERT_THAT(found, testing::SizeIs(max_links));
  EXPECT_EQ(found.back().name, "wlan65") << "however late it was plugged in";
  EXPECT_TRUE(std::ranges::is_sorted(found, {}, &LinkRank::index));
  found = ranks(0, max_links + 2);
  EXPECT_THAT(take_ignored(found), testing::ElementsAre("wlan65", "wlan66"));
}

TEST(Scan, KnowsVirtualLinksByTheirKind) {
  const auto found = virtual_links();
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->contains(InterfaceIndex{::if_nametoindex("lo")})) << "the loopback has no kind";
}

/// One message of an answer: a link with this index, and an attribute of this type with this content.
std::vector<std::byte> link_message(int index, std::uint16_t type, const std::vector<std::uint16_t>& content) {
  const auto attribute_size = static_cast<std::uint16_t>(4 + 2 * content.size());
  std::vector<std::byte> bytes(sizeof(nlmsghdr) + sizeof(ifinfomsg) + attribute_size);
  nlmsghdr header{};
  header.nlmsg_len = static_cast<std::uint32_t>(bytes.size());
  header.nlmsg_type = RTM_NEWLINK;
  ifinfomsg link{};
  link.ifi_index = index;
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, &link, sizeof link);
  std::byte* at = bytes.data() + sizeof header + sizeof link;
  std::memcpy(at, &attribute_size, 2);
  std::memcpy(at + 2, &type, 2);
  std::memcpy(at + 4, content.data(), 2 * content.size());
  return bytes;
}

TEST(Scan, ReadsTheKernelsAnswerWhateverIsInIt) {
  const auto virtual_one = link_message(7, IFLA_LINKINFO, {8, IFLA_INFO_KIND, 0x7576, 0});
  std::set<InterfaceIndex> found;
  EXPECT_TRUE(add_virtual_links(virtual_one, found));
  EXPECT_TRUE(add_virtual_links(link_message(8, IFLA_LINKINFO, {8, IFLA_INFO_SLAVE_KIND, 0, 0}), found));
  EXPECT_TRUE(add_virtual_links(link_message(9, IFLA_ADDRESS, {1, 2, 3}), found));
  EXPECT_THAT(found, testing::ElementsAre(InterfaceIndex{7}));
  for (std::size_t size = 0; size < virtual_one.size(); ++size) {
    std::set<InterfaceIndex> none;
    (void)add_virtual_links(std::span(virtual_one).first(size), none);
    EXPECT_THAT(none, testing::IsEmpty()) << "cut short at " << size;
  }
}

}  // namespace
}  // namespace geminga::env
