// Packets of the link that hold announcements, and others.
#include "doctor/overhearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "doctor/listening.hpp"

namespace geminga::doctor {
namespace {

using Octets = std::vector<unsigned char>;

/// An IPv4 packet of 10.0.0.7 to a group, with a UDP header to port 4800.
Octets packet(const Octets& payload, unsigned char group = 239, unsigned char protocol = 17) {
  Octets all{0x45, 0, 0,     0,   0,  0,  0,    0,    1,    protocol, 0, 0, 10, 0,
             0,    7, group, 192, 47, 17, 0x12, 0x6d, 0x12, 0xc0,     0, 0, 0,  0};
  all.insert(all.end(), payload.begin(), payload.end());
  return all;
}
const Octets plain{0x0d, 0x47, 0x4d, 0x4e, 0x01, 0x18, 0x01, 0x25, 0x4d, 0x3c, 0x2b, 0x1a};

TEST(Overhearing, ReadsWhoSpeaksToWhichGroup) {
  Overheard one;
  ASSERT_TRUE(read_packet(packet(plain), false, one));
  EXPECT_EQ(one.source, "10.0.0.7");
  EXPECT_EQ(one.group, "239.192.47.17");
  EXPECT_EQ(one.port, 4800);
  EXPECT_EQ(one.participant, "1a2b3c4d");
  Octets sealed(32, 0);
  sealed[0] = 'G';
  sealed[1] = 0x11;
  ASSERT_TRUE(read_packet(packet(sealed), false, one));
  EXPECT_EQ(one.participant, "");
}

TEST(Overhearing, TakesNothingElseForAnAnnouncement) {
  Overheard one;
  EXPECT_FALSE(read_packet(packet(plain, 10), false, one)) << "it is for one host";
  EXPECT_FALSE(read_packet(packet(plain, 239, 6), false, one)) << "TCP";
  EXPECT_FALSE(read_packet(packet({1, 2, 3}), false, one));
  EXPECT_FALSE(read_packet(packet(plain), true, one)) << "no IPv6";
  Octets sealed(31, 0);
  sealed[0] = 'G';
  sealed[1] = 0x11;
  EXPECT_FALSE(read_packet(packet(sealed), false, one)) << "shorter than an envelope";
  const Octets whole = packet(plain);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(read_packet(std::span(whole).first(size), false, one)) << size;
  Octets long_header = whole;
  long_header[0] = 0x4f;
  EXPECT_FALSE(read_packet(long_header, false, one)) << "the header would end behind the packet";
}

TEST(Overhearing, ListensBesideOurPortAndGroupAndTheUsualOnes) {
  const Places usual = places_beside({.port = 4717, .groups = {"239.192.47.17", "ff02::4717"}});
  EXPECT_EQ(usual.ports.size(), 2U * neighbouring_ports + 1);
  EXPECT_EQ(usual.ports.front(), 4717 - neighbouring_ports);
  EXPECT_EQ(usual.groups, (std::vector<std::string>{"239.192.47.17", "ff02::4717"}));
  EXPECT_EQ(usual.next_groups.size(), 2U * neighbouring_groups);
  const Places edges = places_beside({.port = 65535, .groups = {"239.1.1.255"}});
  EXPECT_EQ(edges.ports.back(), 65535);
  EXPECT_EQ(edges.ports.size(), 2U * neighbouring_ports + 1 + neighbouring_ports + 1);
  EXPECT_EQ(edges.next_groups.size(), 3U * neighbouring_groups);
}

}  // namespace
}  // namespace geminga::doctor
