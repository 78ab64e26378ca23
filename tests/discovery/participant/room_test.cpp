// Ten thousand subscriptions of one client: told all that there is, announced to nobody, and nobody else is worse off.
#include <gtest/gtest.h>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::seconds;

TEST(Room, OfTenThousandSubscriptionsServesEachAndIsNotAnnounced) {
  constexpr int subscriptions = 10'000;
  sim::World world(sim::World::seed_or(1));
  sim::Host& here = world.add_host("robot1");
  sim::Host& there = world.add_host("robot2");
  here.switch_on();
  there.switch_on();
  world.run_for(seconds(1));
  sim::Client& monitor = world.add_client("monitor");
  monitor.keeps_lines = false;
  monitor.connect(here);
  monitor.say("0 sys hello name=monitor room=10000");
  world.run_for(seconds(1));
  const auto before = here.datagrams_sent();
  for (int number = 1; number <= subscriptions; ++number) {
    const std::string id = std::to_string(number);
    monitor.say(id + " sub create mode=otm/stream text=thing-" + id);
    if (number % 1000 == 0) world.run_for(seconds(1));
  }
  world.run_for(seconds(1));
  EXPECT_LE(here.datagrams_sent() - before, 8U) << "the presences of eleven seconds";

  sim::Client& provider = world.add_client("provider");
  provider.connect(there);
  for (int number = 1; number <= 250; ++number) {
    const std::string id = std::to_string(number);
    provider.say(id + " pub create mode=otm/stream port=" + id + " text=thing-" + std::to_string(40 * number));
  }
  world.run_for(seconds(5));
  std::size_t told = 0;
  for (std::uint32_t number = 1; number <= subscriptions; ++number) told += monitor.view(number).size();
  EXPECT_EQ(told, 250U);

  sim::Client& other = world.add_client("other");
  other.connect(here);
  for (int number = 1; number <= 256; ++number) other.say(std::to_string(number) + " sub create mode=oto text=x");
  world.run_for(seconds(1));
  EXPECT_TRUE(other.lines.empty()) << other.lines.front();

  monitor.hang_up();
  world.run_for(seconds(5));
  sim::Client& next = world.add_client("next");
  next.connect(here);
  next.say("0 sys hello name=next room=16384");
  world.run_for(seconds(1));
  ASSERT_EQ(next.lines.size(), 1U);
  EXPECT_NE(next.lines[0].find("room=16384"), std::string::npos);
}

}  // namespace
}  // namespace geminga::participant
