// A client that reads now and then: what it missed in between does not matter when it has caught up.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t all = 1;
constexpr std::uint32_t best_two = 2;

void subscribe(sim::Client& client) {
  client.say(std::to_string(all) + " sub create mode=otm/pubsub text=x");
  client.say(std::to_string(best_two) + " sub create mode=otm/pubsub text=x limit=2");
}

/// The contents of a view, apart from the client that it was told to.
std::map<std::string, std::string> ports(const sim::Client& client, std::uint32_t request) {
  std::map<std::string, std::string> found;
  for (const auto& [service, statement] : client.view(request)) {
    found[service] = std::string(statement.value("port").value_or(""));
  }
  return found;
}

class LaggingTest : public testing::TestWithParam<std::uint64_t> {};

/// The client itself checks that every event fits what it was told before.
TEST_P(LaggingTest, LeavesAViewThatIsExactWhateverWasMissed) {
  sim::World world(GetParam());
  sim::Host& host = world.add_host("robot1");
  host.settings.limits.unread = 2000;
  host.settings.limits.unread_before_more = 1000;
  host.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& provider = world.add_client("provider");
  sim::Client& witness = world.add_client("witness");
  sim::Client& slow = world.add_client("slow");
  for (sim::Client* one : {&provider, &witness, &slow}) one->connect(host);
  subscribe(witness);
  subscribe(slow);
  int lags = 0;
  slow.on_line = [&](std::string_view line, const gcnp::Statement&) { lags += line == "0 msg lagged" ? 1 : 0; };
  base::Random& random = world.random();
  for (int step = 0; step < 600; ++step) {
    const std::string number = std::to_string(1 + random.below(40));
    const std::string port = " port=" + std::to_string(1 + random.below(60'000));
    const std::string priority = " priority=" + std::to_string(random.below(1'000'000));
    if (random.chance(0.5)) provider.say(number + " pub create mode=otm/pubsub text=x" + port + priority);
    if (random.chance(0.5)) provider.say(number + " pub modify" + port + priority);
    if (random.chance(0.3)) {
      // The provider's own view ends with its request, so nothing may be on its way then.
      world.run_for(milliseconds(1));
      provider.say(number + " pub remove");
      world.run_for(milliseconds(1));
    }
    if (random.chance(0.05)) slow.set_reading(random.chance(0.5));
    if (random.chance(0.5)) world.run_for(milliseconds(1));
  }
  slow.set_reading(true);
  world.run_for(milliseconds(10));
  EXPECT_GT(lags, 0) << world.when();
  ASSERT_TRUE(slow.is_connected());
  EXPECT_EQ(ports(slow, all), ports(witness, all)) << world.when();
  EXPECT_EQ(ports(slow, best_two), ports(witness, best_two)) << world.when();
}

INSTANTIATE_TEST_SUITE_P(Seeds, LaggingTest, testing::Range<std::uint64_t>(1, 9));

/// However much changes, what waits for a client that does not read stays within its bound and one event more.
TEST(Lagging, BoundsWhatWaitsForAClientThatNeverReads) {
  constexpr std::size_t bound = 4000;
  constexpr std::size_t longest_line = 400;
  sim::World world(1);
  sim::Host& host = world.add_host("robot1");
  host.settings.limits.unread = bound;
  host.settings.limits.unread_before_more = bound / 2;
  host.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& provider = world.add_client("provider");
  sim::Client& stalled = world.add_client("stalled");
  provider.connect(host);
  stalled.connect(host);
  stalled.say("1 sub create mode=otm/stream text=x");
  provider.say("1 pub create mode=otm/stream text=x port=1");
  world.run_for(milliseconds(1));
  stalled.set_reading(false);
  for (int port = 1; port <= 1000; ++port) {
    provider.say("1 pub modify port=" + std::to_string(port));
    if (port % 10 == 0) world.run_for(milliseconds(1));
    ASSERT_LE(stalled.unread(), bound + longest_line);
  }
  EXPECT_GT(stalled.unread(), bound - longest_line);
}

/// A consumer that does not read, and so many changes that it lags.
class Laggard : public testing::Test {
 protected:
  Laggard() {
    host.settings.limits.unread = 4000;
    host.settings.limits.unread_before_more = 2000;
    host.settings.limits.services = 3;
    host.switch_on();
    world.run_for(milliseconds(200));
    provider.connect(host);
    slow.connect(host);
    slow.say("1 sub create mode=otm/stream text=other");
    slow.say("2 sub create mode=otm/stream text=x");
    provider.say("1 pub create mode=otm/stream text=x port=1");
    world.run_for(milliseconds(1));
    slow.set_reading(false);
    for (int port = 1; port <= 100; ++port) provider.say("1 pub modify port=" + std::to_string(port));
    world.run_for(milliseconds(10));
  }

  sim::World world{1};
  sim::Host& host = world.add_host("robot1");
  sim::Client& provider = world.add_client("provider");
  sim::Client& slow = world.add_client("slow");
};

TEST_F(Laggard, IsNotClosedWhileItReadsHoweverSlowly) {
  for (int tick = 0; tick < 10; ++tick) {
    world.run_for(std::chrono::seconds(20));
    slow.read(100);
  }
  ASSERT_TRUE(slow.is_connected());
  world.run_for(std::chrono::seconds(51));
  EXPECT_FALSE(slow.is_connected()) << "it has read nothing between two looks";
}

TEST_F(Laggard, IsNotClosedWhenItHasCaughtUpAndTheRequestIsTakenBack) {
  sim::Client& another = world.add_client("another");
  another.connect(host);
  another.say("1 pub create mode=otm/stream text=y port=1");
  world.run_for(milliseconds(10));
  slow.set_reading(true);
  world.run_for(std::chrono::seconds(60));
  EXPECT_TRUE(slow.is_connected());
  EXPECT_TRUE(std::ranges::any_of(slow.lines, [](const auto& line) { return line.starts_with("2 429 taken back"); }));
}

}  // namespace
}  // namespace geminga::participant
