// Many statements at once share datagrams. GEMINGA_SEED chooses another seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <span>
#include <string>

#include "discovery/announcement/codec.hpp"
#include "discovery/membership/schedule/schedule.hpp"
#include "sim/team.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int statements = 42;

/// What three hosts send when each of them is told so many statements, one after the other in this pace.
struct Burst {
  double octets = 0;  ///< of a host
  double state = 0;   ///< octets of its whole state
};

Burst burst(double loss, base::Duration pace, std::uint64_t seed) {
  World world(World::seed_or(seed), {.loss = loss, .longest_delay = milliseconds(5)});
  Team team(world, {.missing = seconds(30), .surplus = seconds(30)});
  for (int i = 1; i <= 3; ++i) world.add_host("robot" + std::to_string(i)).switch_on();
  // What is lost is known by then.
  world.run_for(seconds(40));
  Burst measured;
  world.on_transmit = [&](const Host&, std::string_view datagram) {
    measured.octets += static_cast<double>(datagram.size());
    const auto heard = announcement::decode(std::as_bytes(std::span(datagram)));
    const bool is_told =
        heard && (heard->kind == announcement::Kind::state || heard->kind == announcement::Kind::change);
    if (is_told) measured.state = std::max(measured.state, static_cast<double>(heard->part_count * datagram.size()));
  };
  for (const auto& host : world.hosts()) {
    Module& module = team.add(*host, host->name() + "-many");
    module.run();
    for (int number = 0; number < statements; ++number) {
      const std::string text = "thing" + std::to_string(number / 2);
      world.after(pace * number, [&module, text, number] {
        (void)(number % 2 == 0 ? module.offer(text, "otm/stream") : module.wish(text, "otm/stream"));
      });
    }
  }
  world.run_for(pace * statements + seconds(1));
  EXPECT_TRUE(team.settle(seconds(30)));
  world.run_for(seconds(1));
  measured.octets /= 3;
  return measured;
}

TEST(Burst, OfStatementsTakesAtMostTwiceTheOctetsOfOneStateAndItsCopies) {
  for (const double loss : {0.0, 0.1, 0.3, 0.5}) {
    for (const auto pace : {base::Duration(0), base::Duration(milliseconds(1)), base::Duration(milliseconds(5)),
                            base::Duration(milliseconds(19))}) {
      const Burst one = burst(loss, pace, 95);
      const auto copies = static_cast<double>(membership::state_copies(loss));
      std::cerr << "loss " << loss << ", one statement each " << pace / milliseconds(1) << " ms: " << one.octets
                << " octets a host, a state has " << one.state << " and " << copies << " copies\n";
      // What goes on for most of a second is told meanwhile.
      const double times = pace < milliseconds(5) ? 2 : 4;
      EXPECT_LE(one.octets, times * copies * one.state);
    }
  }
}

}  // namespace
}  // namespace geminga::sim
