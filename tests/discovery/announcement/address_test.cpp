// Numeric addresses, their scopes, and the interfaces on which they are announced.
#include "base/address.hpp"

#include <gmock/gmock.h>

#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/on_interface.hpp"

namespace geminga::announcement {
namespace {

using env::Interface;
using env::InterfaceIndex;

TEST(Address, KnowsItsScope) {
  const std::pair<const char*, base::AddressScope> cases[] = {
      {"0.0.0.0", base::AddressScope::unspecified},
      {"::", base::AddressScope::unspecified},
      {"127.0.0.1", base::AddressScope::loopback},
      {"127.255.255.255", base::AddressScope::loopback},
      {"::1", base::AddressScope::loopback},
      {"169.254.0.1", base::AddressScope::link_local},
      {"fe80::1", base::AddressScope::link_local},
      {"febf::1", base::AddressScope::link_local},
      {"fec0::1", base::AddressScope::global},
      {"10.1.2.3", base::AddressScope::private_use},
      {"172.15.0.1", base::AddressScope::global},
      {"172.16.0.1", base::AddressScope::private_use},
      {"172.31.0.1", base::AddressScope::private_use},
      {"172.32.0.1", base::AddressScope::global},
      {"192.168.0.1", base::AddressScope::private_use},
      {"100.63.0.1", base::AddressScope::global},
      {"100.64.0.1", base::AddressScope::private_use},
      {"100.128.0.1", base::AddressScope::global},
      {"fc00::1", base::AddressScope::private_use},
      {"fdff::1", base::AddressScope::private_use},
      {"2001:db8::1", base::AddressScope::global},
      {"8.8.8.8", base::AddressScope::global},
      {"224.0.0.1", base::AddressScope::multicast},
      {"239.192.47.17", base::AddressScope::multicast},
      {"240.0.0.1", base::AddressScope::global},
      {"ff02::4717", base::AddressScope::multicast},
  };
  for (const auto& [text, scope] : cases) EXPECT_EQ(base::address_scope(text), scope) << text;
}

TEST(Address, HasOneCanonicalText) {
  EXPECT_EQ(base::parse_address("FE80:0:0::1").value().text(), "fe80::1");
  EXPECT_EQ(base::parse_address("10.0.0.1").value().text(), "10.0.0.1");
  EXPECT_EQ(base::parse_address("fe80::1%eth0").value().text(), "fe80::1%eth0");
}

TEST(Address, RefusesWhatIsNoNumericAddress) {
  using namespace std::string_literals;
  for (const auto& text : {""s, "robot2"s, "1.2.3"s, "1.2.3.4.5"s, "01.2.3.4"s, "256.1.1.1"s, "1.2.3.4 "s, " 1.2.3.4"s,
                           "1.2.3.4\0x"s, ":::"s, "fe80::1%"s, "10.0.0.1%eth0"s, "2001:db8::1%eth0"s,
                           "fe80::1%0123456789abcdef"s, "fe80::1%a b"s, std::string(5000, '1')}) {
    EXPECT_EQ(base::parse_address(text), std::nullopt) << text;
  }
  EXPECT_TRUE(base::parse_address("fe80::1%0123456789abcde"));
}

TEST(Address, RanksIpv4BeforeIpv6AndRoutableBeforeLinkLocalBeforeLoopback) {
  int last = -1;
  for (const auto* text : {"10.0.0.1", "169.254.1.1", "2001:db8::1", "fe80::1", "127.0.0.1", "::1"}) {
    const int rank = base::address_rank(*base::parse_address(text));
    EXPECT_GT(rank, last) << text;
    last = rank;
  }
}

const Interface lo{.index = InterfaceIndex{1}, .name = "lo", .addresses = {"127.0.0.1", "::1"}, .is_loopback = true};
const Interface eth{.index = InterfaceIndex{2}, .name = "eth0", .addresses = {"10.0.0.1", "fe80::1"}};
const Interface wlan{.index = InterfaceIndex{3}, .name = "wlan0", .addresses = {"192.168.0.1", "fe80::2"}};

TEST(OnInterface, AnnouncesOtherAddressesThanItsOwnWhereTheOwnerSaysSo) {
  Interface behind = eth;
  behind.announced = {"192.0.2.7"};
  EXPECT_THAT(on_interface({}, behind, std::vector{behind}).addresses, ::testing::ElementsAre("192.0.2.7"));
  EXPECT_THAT(on_interface({}, eth, std::vector{eth}).addresses, ::testing::ElementsAre("10.0.0.1", "fe80::1"));
}

TEST(OnInterface, AnnouncesAnAddressOnlyWhereItIsValid) {
  const std::vector<Interface> ours{lo, eth, wlan};
  struct Case {
    const char* address;
    bool on_lo, on_eth, on_wlan;
  };
  for (const auto& [address, on_lo, on_eth, on_wlan] : {
           Case{"", true, true, true},
           Case{"127.0.0.1", true, false, false},
           Case{"127.0.0.9", true, false, false},
           Case{"::1", true, false, false},
           Case{"10.0.0.1", false, true, false},
           Case{"192.168.0.1", false, false, true},
           Case{"fe80::2", false, false, true},
           Case{"fe80::9%eth0", false, true, false},
           Case{"fe80::9", true, true, true},
           Case{"239.192.1.1", true, true, true},
           Case{"10.0.0.99", true, true, true},
       }) {
    EXPECT_EQ(is_announced_on(address, lo, ours), on_lo) << address;
    EXPECT_EQ(is_announced_on(address, eth, ours), on_eth) << address;
    EXPECT_EQ(is_announced_on(address, wlan, ours), on_wlan) << address;
  }
}

TEST(OnInterface, AnnouncesAnAddressThatTwoInterfacesShareOnBoth) {
  auto bridge = wlan;
  bridge.addresses = {"10.0.0.1"};
  const std::vector<Interface> ours{eth, bridge};
  EXPECT_TRUE(is_announced_on("10.0.0.1", eth, ours));
  EXPECT_TRUE(is_announced_on("10.0.0.1", bridge, ours));
}

TEST(OnInterface, WithholdsWhatIsNotValidThereAndTakesZonesOff) {
  auto state = worked_example();
  auto& peer = state.peers[0];
  peer.publications[0].publication.address = "fe80::1%eth0";
  peer.publications.push_back({7, simple_publication()});
  peer.publications.back().publication.address = "192.168.0.1";
  peer.subscriptions[0].subscription.address = "127.0.0.1";
  const std::vector<Interface> ours{lo, eth, wlan};

  const auto there = on_interface(state, eth, ours);
  EXPECT_EQ(there.link, 2U);
  EXPECT_EQ(there.addresses, eth.addresses);
  ASSERT_EQ(there.peers[0].publications.size(), 1U);
  EXPECT_EQ(there.peers[0].publications[0].publication.address, "fe80::1");
  EXPECT_TRUE(there.peers[0].subscriptions.empty());
  EXPECT_THAT(there.peers[0].withheld, ::testing::ElementsAre(7, 43));
  EXPECT_EQ(there.revision, state.revision);
}

TEST(OnInterface, AnnouncesAtMostTheNamedNumberOfAddresses) {
  for (const std::size_t count : {max_addresses - 1, max_addresses, max_addresses + 1}) {
    auto many = eth;
    many.addresses.clear();
    for (std::size_t i = 0; i < count; ++i) many.addresses.push_back("10.0.0." + std::to_string(i + 1));
    const auto there = on_interface(worked_example(), many, std::vector{many});
    EXPECT_EQ(there.addresses.size(), std::min(count, max_addresses));
    EXPECT_EQ(there.addresses.front(), "10.0.0.1");
  }
}

TEST(OnInterface, ATwinIsNumberedAfterItsInterfaceAndSaysWhatCanBeReachedThere) {
  const Interface own{.index = InterfaceIndex{3}, .name = "wlan0", .addresses = {"10.0.0.1"}};
  const Interface twin{
      .index = InterfaceIndex{77}, .name = "wlan0", .addresses = {"fe80::1"}, .ipv6_side_of = own.index};
  const std::vector<Interface> ours{own, twin};
  EXPECT_EQ(on_interface({}, own, ours).link, 3U);
  const Announcement there = on_interface({}, twin, ours);
  EXPECT_EQ(there.link, ipv6_side_bit | 3U);
  EXPECT_THAT(there.addresses, testing::ElementsAre("fe80::1"));
  EXPECT_TRUE(is_announced_on("10.0.0.1", own, ours));
  EXPECT_FALSE(is_announced_on("10.0.0.1", twin, ours)) << "who speaks IPv6 alone cannot reach it";
  EXPECT_TRUE(is_announced_on("fe80::1%wlan0", twin, ours));
  EXPECT_TRUE(is_announced_on("203.0.113.7", twin, ours));
}

}  // namespace
}  // namespace geminga::announcement
