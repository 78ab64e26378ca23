#include "discovery/announcement/announcements.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

using base::Random;

std::string random_text(Random& random, std::size_t least, std::size_t most, std::string_view alphabet) {
  std::string text;
  const auto size = least + random.below(most - least + 1);
  while (text.size() < size) text += alphabet[random.below(alphabet.size())];
  return text;
}

std::string random_name(Random& random, std::size_t least = 1) {
  if (random.chance(0.2)) return "Ölstand";
  return random_text(random, least, random.chance(0.1) ? max_name_bytes : 12, "abcXYZ019_-. ");
}

std::string random_iri(Random& random) {
  static constexpr std::string_view spaces[] = {"https://geminga.example/soccer#", "http://a.example/", "urn:x:", "#",
                                                ""};
  return std::string(spaces[random.below(5)]) + random_text(random, 1, random.chance(0.1) ? 200 : 20, "abcXYZ019_-");
}

Identity random_identity(Random& random) {
  switch (random.below(4)) {
    case 0:
      return NumericIdentity{static_cast<std::uint32_t>(random.next())};
    case 1:
      return TextIdentity{
          random_text(random, 1, 40, "abc \"\\'äü")[0] == '\xc3' ? "ä" : random_text(random, 1, 40, "abc \"\\'")};
    default:
      return SemanticIdentity{random_iri(random), random.chance(0.7) ? random_iri(random) : std::string()};
  }
}

std::string random_address(Random& random) {
  static constexpr std::string_view addresses[] = {
      "",          "10.0.0.7", "127.0.0.1",    "239.192.1.1", "169.254.3.4",
      "fe80::1:2", "::1",      "2001:db8::17", "ff02::4717",  "192.168.1.255"};
  return std::string(addresses[random.below(10)]);
}

Attributes random_attributes(Random& random) {
  Attributes attributes;
  const auto count = random.chance(0.5) ? 0 : random.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    attributes[random_text(random, 1, 10, "abcXYZ_.-09")] = random_text(random, 0, 20, "abc =\"\n\t{}");
  }
  return attributes;
}

ChannelMode random_mode(Random& random) { return static_cast<ChannelMode>(random.below(3)); }

Publication random_publication(Random& random) {
  Publication publication;
  publication.mode = random_mode(random);
  publication.identity = random_identity(random);
  publication.address = random_address(random);
  publication.port = static_cast<std::uint16_t>(1 + random.below(65535));
  publication.protocol = random.chance(0.7) ? "udp" : random_text(random, 1, max_protocol_bytes, "abc/+-1");
  publication.priority = static_cast<std::int32_t>(random.next());
  publication.attributes = random_attributes(random);
  publication.scope = random_text(random, 0, 20, "abc,!/*");
  publication.for_whom = random_text(random, 0, 40, "abc<>=&|() 0123\"");
  return publication;
}

Subscription random_subscription(Random& random) {
  Subscription subscription;
  subscription.mode = random_mode(random);
  subscription.identity = random_identity(random);
  if (random.chance(0.2)) {
    subscription.identity = SemanticIdentity{"not (<" + random_iri(random) + "> some <" + random_iri(random) + ">)",
                                             random.chance(0.5) ? random_iri(random) : std::string()};
  }
  subscription.weakest = random.chance(0.2) ? Degree::overlapping : static_cast<Degree>(random.below(4));
  for (auto count = random.below(3); count > 0; --count) {
    subscription.providers.push_back({random_name(random), random.chance(0.5) ? random_name(random) : std::string()});
  }
  subscription.where = random_text(random, 0, 60, "abc<>=&|() 0123\"");
  subscription.limit = static_cast<std::uint32_t>(random.below(5));
  subscription.priority = static_cast<std::int32_t>(random.next());
  subscription.port = static_cast<std::uint16_t>(random.below(65536));
  subscription.address = random_address(random);
  subscription.attributes = random_attributes(random);
  for (auto count = random.below(3); count > 0; --count) {
    subscription.protocols.push_back(random_text(random, 1, 6, "abc/+-1"));
  }
  for (auto count = random.below(3); count > 0; --count) {
    subscription.favoured.push_back({random_name(random), random.chance(0.5) ? random_name(random) : std::string()});
  }
  subscription.prefer = random_text(random, 0, 40, "abc desc,by0123");
  subscription.rank = random_text(random, 0, 20, "abc,");
  subscription.scope = random_text(random, 0, 20, "abc,!/*");
  const auto most = random.chance(0.1) ? max_announced_choice : 3;
  for (auto left = random.below(most + 1); left > 0; --left) {
    subscription.chosen.push_back({ParticipantId{static_cast<std::uint32_t>(1 + random.below(9))},
                                   PeerId{static_cast<std::uint32_t>(1 + random.below(4))},
                                   static_cast<std::uint32_t>(1 + random.below(99))});
  }
  std::ranges::sort(subscription.chosen);
  subscription.chosen.erase(std::ranges::unique(subscription.chosen).begin(), subscription.chosen.end());
  subscription.convert = random.chance(0.5) ? 0 : static_cast<std::uint32_t>(random.next());
  if (random.chance(0.2)) subscription.on = "<" + random_iri(random) + ">";
  return subscription;
}

}  // namespace

Announcement worked_example() {
  Announcement example;
  example.kind = Kind::state;
  example.group = "default";
  example.participant = ParticipantId{0x1a2b3c4d};
  example.boot = BootNonce{0x0102030405060708};
  example.link = 2;
  example.sequence = 300;
  example.interval = std::chrono::seconds(2);
  example.name = "robot2";
  example.ontology_digest = 0x1122334455667788;
  example.addresses = {"192.168.1.2"};
  example.revision = 3;
  PeerState vision;
  vision.id = PeerId{1};
  vision.name = "vision";
  Publication ball;
  ball.mode = ChannelMode::one_to_many_stream;
  ball.identity =
      SemanticIdentity{"https://geminga.example/soccer#BallInfo", "https://geminga.example/soccer#CartesianFieldFrame"};
  ball.port = 5000;
  ball.priority = -1;
  ball.attributes = {{"rate", "33"}};
  vision.publications.push_back({42, ball});
  Subscription odometry;
  odometry.mode = ChannelMode::one_to_one;
  odometry.identity = TextIdentity{"odometry"};
  odometry.limit = 1;
  vision.subscriptions.push_back({43, odometry});
  example.peers.push_back(vision);
  return example;
}

Announcement random_presence(Random& random) {
  Announcement made;
  made.kind = Kind::presence;
  made.group = random.chance(0.5) ? "default" : random_name(random);
  made.participant = ParticipantId{static_cast<std::uint32_t>(1 + random.below(0xffffffff))};
  made.boot = BootNonce{random.next()};
  made.link = static_cast<std::uint32_t>(random.below(10));
  made.sequence = random.below(1'000'000);
  made.revision = random.below(1'000);
  made.doublings = static_cast<std::uint8_t>(random.below(max_doublings + 1));
  made.witness.members = static_cast<std::uint16_t>(random.next());
  for (auto count = 4 * random.below(max_participants / 4 + 1); count > 0; --count) {
    made.witness.heard.push_back(static_cast<HeardWithin>(random.below(4)));
  }
  if (made.witness.heard.empty()) made.witness.members = 0;
  for (auto* named : {&made.lacks, &made.doubts}) {
    for (auto count = random.below(max_named + 1); count > 0; --count) {
      named->push_back(ParticipantId{static_cast<std::uint32_t>(1 + random.below(0xffffffff))});
    }
  }
  for (auto count = random.below(max_introductions + 1); count > 0; --count) {
    const std::string host = std::to_string(1 + random.below(254));
    made.introductions.push_back({ParticipantId{static_cast<std::uint32_t>(1 + random.below(0xffffffff))},
                                  (random.chance(0.5) ? "10.0.0." : "fd00::") + host});
  }
  return made;
}

Announcement worked_diagnosis() {
  Announcement diagnosis;
  diagnosis.kind = Kind::diagnosis;
  diagnosis.group = default_group;
  diagnosis.participant = ParticipantId{0x1a2b3c4d};
  diagnosis.boot = BootNonce{0x0102030405060708};
  diagnosis.link = 2;
  diagnosis.sequence = 300;
  diagnosis.revision = 3;
  diagnosis.partner = ParticipantId{0x5e6f7a8b};
  diagnosis.token = 0x1122334455667788;
  diagnosis.lines = {"status version=1.0.0"};
  return diagnosis;
}

Announcement random_announcement(Random& random, std::size_t max_services) {
  Announcement made;
  made.kind = random.chance(0.8) ? Kind::state : static_cast<Kind>(random.below(3));
  made.group = random.chance(0.8) ? "default" : random_name(random);
  made.participant = ParticipantId{static_cast<std::uint32_t>(1 + random.below(0xffffffff))};
  made.boot = BootNonce{random.next()};
  made.link = static_cast<std::uint32_t>(random.below(10));
  made.sequence = random.below(1'000'000);
  made.interval = std::chrono::milliseconds(50 + random.below(59'950));
  made.name = random.chance(0.2) ? std::string() : random_name(random);
  made.ontology_digest = random.chance(0.2) ? 0 : random.next();
  made.lasting = random.chance(0.5) ? 0 : static_cast<std::uint32_t>(random.next());
  made.revision = random.below(1'000);
  static constexpr std::string_view addresses[] = {"10.0.0.7", "169.254.3.4", "fe80::1:2", "2001:db8::17", "127.0.0.1"};
  for (auto count = random.below(4); count > 0; --count) made.addresses.emplace_back(addresses[random.below(5)]);
  auto left = random.below(max_services + 1);
  for (std::uint32_t id = 1; left > 0; ++id) {
    PeerState peer;
    peer.id = PeerId{id};
    peer.name = random.chance(0.2) ? std::string() : random_name(random);
    std::uint32_t number = 0;
    for (auto count = 1 + random.below(left); count > 0; --count, --left) {
      number += static_cast<std::uint32_t>(1 + random.below(1000));
      const auto what = random.below(10);
      if (what == 0) {
        peer.withheld.push_back(number);
      } else if (what < 6) {
        NumberedPublication entry{number, random_publication(random)};
        if (!check(entry.publication)) peer.publications.push_back(entry);
      } else {
        NumberedSubscription entry{number, random_subscription(random)};
        if (!check(entry.subscription)) peer.subscriptions.push_back(entry);
      }
    }
    if (!peer.publications.empty() || !peer.subscriptions.empty() || !peer.withheld.empty()) made.peers.push_back(peer);
  }
  return made;
}

Announcement random_change(Random& random) {
  auto made = random_announcement(random);
  made.kind = Kind::change;
  made.name.clear();
  made.ontology_digest = 0;
  made.lasting = 0;
  made.interval = Announcement{}.interval;
  made.addresses.clear();
  made.doublings = static_cast<std::uint8_t>(random.below(max_doublings + 1));
  made.since = made.revision;
  made.revision += 1 + random.below(100);
  for (auto& peer : made.peers) {
    for (auto count = random.below(3); count > 0; --count) {
      peer.removed.push_back(static_cast<std::uint32_t>(1'000'000 + peer.removed.size()));
    }
  }
  return made;
}

Publication simple_publication(std::uint16_t port) {
  Publication publication;
  publication.mode = ChannelMode::one_to_many_stream;
  publication.identity = NumericIdentity{7};
  publication.port = port;
  return publication;
}

Subscription simple_subscription() {
  Subscription subscription;
  subscription.mode = ChannelMode::one_to_many_stream;
  subscription.identity = NumericIdentity{7};
  return subscription;
}

std::string to_hex_text(std::span<const std::byte> octets) {
  std::string text;
  for (const auto octet : octets) text += base::to_hex(static_cast<std::uint64_t>(octet), 2);
  return text;
}

std::vector<std::byte> octets_of(std::string_view hex) {
  std::string digits;
  std::ranges::copy_if(hex, std::back_inserter(digits), [](char c) { return c > ' '; });
  std::vector<std::byte> octets;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    octets.push_back(static_cast<std::byte>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  }
  return octets;
}

Announcement joined(const std::vector<Announcement>& parts) {
  Announcement whole = parts.front();
  whole.part = 0;
  whole.part_count = 1;
  whole.peers.clear();
  for (const auto& part : parts) {
    for (const auto& peer : part.peers) {
      if (whole.peers.empty() || whole.peers.back().id != peer.id) {
        whole.peers.push_back(peer);
        continue;
      }
      auto& to = whole.peers.back();
      to.publications.insert(to.publications.end(), peer.publications.begin(), peer.publications.end());
      to.subscriptions.insert(to.subscriptions.end(), peer.subscriptions.begin(), peer.subscriptions.end());
      to.withheld.insert(to.withheld.end(), peer.withheld.begin(), peer.withheld.end());
    }
  }
  return whole;
}

}  // namespace geminga::announcement
