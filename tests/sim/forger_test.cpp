// Somebody on the link speaks in others' names: what it may cost them, and what not. GEMINGA_SEED chooses another seed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/membership/claim/identifier_claim.hpp"
#include "discovery/membership/schedule/schedule.hpp"
#include "sim/team.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* stream = "otm/stream";

/// Robots that offer and want the same things, and one more host, which is off, for whoever forges.
struct Field {
  Field(std::uint64_t seed, int count, int services = 1) : world(seed), team(world) {
    for (int i = 1; i <= count; ++i) {
      Host& host = world.add_host("robot" + std::to_string(i));
      // A peer has at most 256 publications.
      for (int left = services; left > 0; left -= 250) {
        Module& vision = team.add(host, host.name() + "-vision" + std::to_string(left));
        for (int n = 0; n < std::min(left, 250); ++n)
          vision.offer(n == 0 ? "ball" : "thing" + std::to_string(n), stream);
        vision.wish("ball", stream);
      }
    }
    forger = &world.add_host("forger");
  }

  void start() {
    for (int i = 0; i + 1 < static_cast<int>(world.hosts().size()); ++i) host(static_cast<std::size_t>(i)).switch_on();
    for (const auto& module : team.modules()) module->run();
    EXPECT_TRUE(team.settle(seconds(5)));
    world.run_for(seconds(2));
  }

  [[nodiscard]] Host& host(std::size_t index) { return *world.hosts().at(index); }
  [[nodiscard]] Module& module(std::size_t index) { return *team.modules().at(index); }

  void forge(const announcement::Announcement& lie) {
    for (const announcement::Datagram& datagram : announcement::encode(lie)) {
      world.transmit(*forger, forger->ports().front().index,
                     std::string_view(reinterpret_cast<const char*>(datagram.data()), datagram.size()));
    }
  }

  /// The last announcement of a host.
  [[nodiscard]] static announcement::Announcement read(std::string_view datagram) {
    return announcement::decode(std::as_bytes(std::span(datagram))).value_or(announcement::Announcement{});
  }

  /// One value of `query status`.
  [[nodiscard]] long status(Host& host, const std::string& key) {
    Client& client = world.add_client("asker");
    client.connect(host);
    client.say("1 query status");
    world.run_for(milliseconds(1));
    const auto line = gcnp::parse(client.lines.empty() ? "" : client.lines.front());
    client.hang_up();
    world.run_for(milliseconds(1));
    if (!line) return -1;
    return base::parse_number<long>(line->value(key).value_or("0")).value_or(-1);
  }

  World world;
  Team team;
  Host* forger = nullptr;
};

/// A state of nobody in particular.
announcement::Announcement stranger(std::uint32_t id, std::uint64_t boot) {
  announcement::Announcement state;
  state.group = "default";
  state.participant = ParticipantId(id);
  state.boot = announcement::BootNonce(boot);
  state.name = "x";
  return state;
}

TEST(Forger, ThatAnswersEveryDatagramWithAClashForAMinuteEndsNobodyAndHidesNobodyFromItsPeers) {
  Field field(World::seed_or(21), 3);
  field.start();
  bool is_forging = true;
  std::uint64_t forged = 0;
  std::set<std::string> identifiers;
  field.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (!is_forging || &sender != &field.host(0)) return;
    const auto heard = Field::read(datagram);
    if (heard.kind == announcement::Kind::goodbye) return;
    identifiers.insert(to_string(heard.participant));
    auto lie = stranger(static_cast<std::uint32_t>(heard.participant), 99);
    lie.revision = 7;
    lie.sequence = ++forged;
    field.world.after(base::Duration(0), [&field, lie] { field.forge(lie); });
  };
  // The checkers of Team watch all the while: no view may miss a service for longer than two intervals.
  field.world.run_for(seconds(60));
  is_forging = false;
  EXPECT_TRUE(field.host(0).is_on()) << field.world.when();
  EXPECT_TRUE(field.host(0).participant().is_ready());
  EXPECT_GT(forged, 30U);
  const auto refilled = seconds(60) / membership::redraw_refill;
  EXPECT_GE(field.status(field.host(0), "redraws"), 2);
  EXPECT_LE(field.status(field.host(0), "redraws"), membership::redraw_capacity + refilled);
  EXPECT_LE(identifiers.size(), static_cast<std::size_t>(membership::redraw_capacity + refilled + 1));
  EXPECT_GT(field.status(field.host(0), "contested"), 10);
  EXPECT_GT(field.status(field.host(0), "contested_for"), -2) << "a number with decimals";
  EXPECT_TRUE(field.team.settle(seconds(4)));
  field.world.run_for(seconds(60));
  EXPECT_TRUE(field.team.is_right()) << field.team.complaints();
}

TEST(Forger, WithEightClashesBeforeAnAnswerCanComeLeavesTheLocalServicesInForce) {
  Field field(World::seed_or(22), 1);
  field.start();
  Client& local = field.world.add_client("local");
  local.connect(field.host(0));
  local.say("1 sub create mode=otm/stream limit=0 text=ball");
  field.world.run_for(milliseconds(10));
  ASSERT_EQ(local.view(1).size(), 1U);
  ParticipantId id{};
  field.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (&sender == &field.host(0)) id = Field::read(datagram).participant;
  };
  field.world.run_for(seconds(3));
  std::size_t without = 0;
  local.on_line = [&](std::string_view, const gcnp::Statement& line) { without += line.subcommand == "del" ? 1 : 0; };
  for (int i = 0; i < 100; ++i) {
    field.forge(stranger(static_cast<std::uint32_t>(id), 99));
    field.world.run_for(milliseconds(3));
    EXPECT_EQ(local.view(1).size(), 1U) << "served while another identifier is claimed. " << field.world.when();
  }
  field.world.run_for(seconds(1));
  EXPECT_EQ(without, 1U) << "the services went and came back once";
  EXPECT_EQ(local.view(1).size(), 1U);
  EXPECT_EQ(field.status(field.host(0), "clashes"), 1);
}

/// The datagrams of the first robot within five milliseconds of a lie about it.
std::vector<announcement::Announcement> answer_to(Field& field,
                                                  const std::function<void(announcement::Announcement&)>& twist) {
  announcement::Announcement last;
  std::vector<announcement::Announcement> said;
  field.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (&sender == &field.host(0)) said.push_back(last = Field::read(datagram));
  };
  while (said.empty()) field.world.run_for(milliseconds(1));
  field.world.run_for(milliseconds(500));
  said.clear();
  twist(last);
  field.forge(last);
  field.world.run_for(milliseconds(5));
  field.world.on_transmit = nullptr;
  return said;
}

TEST(Forger, ThatLiesInAHostsNameWithItsBootNonceIsContradictedAtOnce) {
  const std::vector<std::pair<std::string, std::function<void(announcement::Announcement&)>>> lies = {
      {"a goodbye",
       [](announcement::Announcement& lie) {
         lie.kind = announcement::Kind::goodbye;
         lie.peers.clear();
         lie.addresses.clear();
         lie.revision = 0;
       }},
      {"a later revision", [](announcement::Announcement& lie) { lie.revision = ~std::uint64_t{0}; }},
      {"a later sequence", [](announcement::Announcement& lie) { lie.sequence += 1'000'000; }},
      {"other services", [](announcement::Announcement& lie) { lie.peers.clear(); }},
      {"another address", [](announcement::Announcement& lie) { lie.addresses = {"10.0.0.66"}; }},
      {"its own words from another address", [](announcement::Announcement&) {}},
  };
  for (const auto& [what, twist] : lies) {
    Field field(World::seed_or(23), 2);
    field.start();
    const auto said = answer_to(field, twist);
    ASSERT_EQ(said.size(), 1U) << what;
    EXPECT_EQ(said[0].kind, announcement::Kind::state) << what;
    EXPECT_EQ(said[0].peers.size(), 1U) << what;
    EXPECT_EQ(field.status(field.host(0), "contradicted"), 1) << what;
    EXPECT_EQ(field.status(field.host(1), "contradicted"), 0) << what;
  }
}

TEST(Forger, ThatLiesWithoutEndIsContradictedABoundedNumberOfTimes) {
  Field field(World::seed_or(24), 2);
  field.start();
  const auto quiet = field.world.datagrams();
  field.world.run_for(seconds(20));
  const auto periodic = field.world.datagrams() - quiet;
  announcement::Announcement last;
  field.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (&sender == &field.host(0)) last = Field::read(datagram);
  };
  field.world.run_for(seconds(3));
  std::uint64_t forged = 0;
  const auto before = field.world.datagrams();
  for (int i = 0; i < 2000; ++i, ++forged) {
    auto lie = last;
    lie.sequence += 1000 + forged;
    field.forge(lie);
    field.world.run_for(milliseconds(10));
  }
  const auto contradictions = field.world.datagrams() - before - forged;
  EXPECT_LE(contradictions, periodic + 10 * membership::contradictions_per_interval +
                                membership::contradiction_capacity + 4 + milliseconds(500) / membership::lack_spacing);
}

TEST(Forger, ThatClaimsAnOwnersIdentifierIsAnsweredWithOneDatagramBeforeItsClaimIsOver) {
  Field field(World::seed_or(25), 1, 100);  // a state of many datagrams
  field.start();
  announcement::Announcement last;
  std::vector<announcement::Announcement> said;
  field.world.on_transmit = [&](const Host& sender, std::string_view datagram) {
    if (&sender == &field.host(0)) said.push_back(last = Field::read(datagram));
  };
  while (said.empty()) field.world.run_for(milliseconds(1));
  field.world.run_for(milliseconds(500));
  said.clear();
  auto claim = stranger(static_cast<std::uint32_t>(last.participant), 99);
  claim.kind = announcement::Kind::claim;
  field.forge(claim);
  field.world.run_for(milliseconds(5));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].participant, last.participant);
  EXPECT_EQ(said[0].revision, last.revision);
  EXPECT_EQ(said[0].kind, announcement::Kind::presence);
  // And so is an honest claimant's one claim among a forger's without end.
  for (int i = 0; i < 300; ++i) {
    field.forge(claim);
    field.world.run_for(milliseconds(1));
  }
  said.clear();
  field.forge(claim);
  field.world.run_for(milliseconds(80));
  EXPECT_FALSE(said.empty());
}

TEST(Forger, ThatShowsAPresenceWithoutAStateMakesATeamSayLittle) {
  Field field(World::seed_or(28), 7);
  field.start();
  field.world.run_for(seconds(60));
  const auto octets_in_a_minute = [&](bool is_forged) {
    const auto before = field.world.datagram_bytes();
    std::uint64_t forged = 0;
    for (std::uint32_t i = 0; i < 120; ++i) {
      const auto was = field.world.datagram_bytes();
      if (is_forged) {
        auto presence = stranger(2000, 77);
        presence.kind = announcement::Kind::presence;
        presence.sequence = i;
        presence.lacks = {ParticipantId{1}};
        field.forge(presence);
      }
      forged += field.world.datagram_bytes() - was;
      field.world.run_for(milliseconds(500));
    }
    return static_cast<double>(field.world.datagram_bytes() - before - forged);
  };
  const auto quiet = octets_in_a_minute(false);
  (void)octets_in_a_minute(true);  // uses up what is said quickly
  const auto forged = octets_in_a_minute(true);
  EXPECT_LE(forged, (1.2 + membership::asks_per_interval) * quiet);
}

/// Octets that a team sends in a minute for each octet of a forged newcomer a second.
double amplification(int robots, int services) {
  const auto octets = [&](bool has_newcomers) {
    Field field(World::seed_or(26), robots, services);
    field.start();
    field.world.run_for(seconds(20));
    const auto before = field.world.datagram_bytes();
    std::uint64_t forged = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const auto was = field.world.datagram_bytes();
      if (has_newcomers) field.forge(stranger(1000 + i, i));
      forged += field.world.datagram_bytes() - was;
      field.world.run_for(seconds(1));
    }
    return std::pair(static_cast<double>(field.world.datagram_bytes() - before - forged), static_cast<double>(forged));
  };
  const auto [with, forged] = octets(true);
  const auto [without, nothing] = octets(false);
  const double ratio = (with - without) / forged;
  std::cerr << robots << " robots of " << services << " services: " << forged << " octets of newcomers cost " << ratio
            << " times as many; the periodic announcements are " << without << '\n';
  return ratio;
}

TEST(Newcomers, ThatAreForgedOnceASecondCostABoundedNumberOfOctets) {
  EXPECT_LE(amplification(1, 16), 10);
  EXPECT_LE(amplification(7, 16), 70);
  EXPECT_LE(amplification(1, 1000), 60) << "a large state is told once";
}

/// How long after the start of the last robot every robot knows all others' services.
base::Duration time_to_know_all(int robots, base::Duration spread) {
  Field field(World::seed_or(27), robots);
  base::Instant last = field.world.now();
  for (int i = 0; i < robots; ++i) {
    const auto when = field.world.now() + spread * i / robots;
    last = when;
    field.world.at(when, [&field, i] {
      field.host(static_cast<std::size_t>(i)).switch_on();
      field.module(static_cast<std::size_t>(i)).run();
    });
  }
  field.team.is_excused = true;
  field.world.run_for(last - field.world.now());
  while (!field.team.is_right() && field.world.now() - last < seconds(20)) field.world.run_for(milliseconds(10));
  const auto took = field.world.now() - last;
  std::cerr << robots << " robots switched on within " << spread / milliseconds(1) << " ms know all after "
            << took / milliseconds(1) << " ms\n";
  return took;
}

TEST(Newcomers, OfAWholeTeamAreAnsweredAsQuicklyAsOne) {
  EXPECT_LE(time_to_know_all(10, milliseconds(0)), milliseconds(200));
  EXPECT_LE(time_to_know_all(30, milliseconds(0)), milliseconds(400));
  // One behind the other they are answered together, once in newcomer_spacing, and the budget lasts for all of them.
  const auto longest = membership::newcomer_spacing + milliseconds(100);
  EXPECT_LE(time_to_know_all(30, milliseconds(500)), longest);
  EXPECT_LE(time_to_know_all(10, seconds(5)), longest);
  EXPECT_LE(time_to_know_all(30, seconds(10)), longest);
}

}  // namespace
}  // namespace geminga::sim
