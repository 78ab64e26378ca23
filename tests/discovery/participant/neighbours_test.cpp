// Changes of neighbours come to local clients in turns that are counted and not timed.
#include <gtest/gtest.h>

#include <algorithm>

#include "discovery/participant/knowledge/neighbour_queue.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

ServiceKey key(std::uint32_t participant, std::uint32_t number) {
  return {.participant = ParticipantId{participant}, .peer = PeerId{1}, .number = number};
}

membership::PutPublication put(const ServiceKey& one, std::uint16_t port) {
  membership::PutPublication change;
  change.key = one;
  change.publication.port = port;
  return change;
}

base::Instant at(int instant) { return base::Instant(milliseconds(1'000'000 + instant)); }

membership::PutPublication put_converter(const ServiceKey& one, std::uint16_t port = 1) {
  membership::PutPublication change = put(one, port);
  change.publication.attributes = {{"converts", "A>B"}};
  return change;
}

/// How many changes come out at `now`.
int count_due(NeighbourQueue& queue, base::Instant now) {
  int count = 0;
  while (queue.has_due(now)) count += queue.pop(now) ? 1 : 0;
  return count;
}

TEST(NeighbourQueue, KeepsTheOrderAndTheLastChangeOfEachService) {
  NeighbourQueue queue;
  queue.push(put(key(1, 1), 1));
  queue.push(put(key(1, 2), 2));
  queue.push(put(key(1, 1), 3));
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 3);
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 2);
  EXPECT_FALSE(queue.has_due(at(0)));
}

TEST(NeighbourQueue, APublicationDoesNotHideThatASubscriptionOfTheSameNumberWent) {
  NeighbourQueue queue;
  queue.push(membership::RemoveSubscription{key(1, 1), membership::Departure::withdrawn});
  queue.push(put(key(1, 1), 1));
  EXPECT_TRUE(std::holds_alternative<membership::RemoveSubscription>(*queue.pop(at(0))));
  EXPECT_TRUE(std::holds_alternative<membership::PutPublication>(*queue.pop(at(0))));
}

TEST(NeighbourQueue, ADepartureTakesThePlaceOfAllThatWaitsOfTheParticipantAndOfNoOther) {
  NeighbourQueue queue;
  queue.push(put(key(1, 1), 1));
  queue.push(put(key(2, 1), 2));
  queue.push(put(key(3, 1), 3));
  queue.push(membership::RemoveParticipant{ParticipantId{2}, membership::Departure::left});
  queue.push(put(key(2, 1), 4));
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 1);
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 3);
  EXPECT_TRUE(std::holds_alternative<membership::RemoveParticipant>(*queue.pop(at(0))));
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 4);
  EXPECT_FALSE(queue.has_due(at(0)));
}

TEST(NeighbourQueue, HoldsChangesOfConvertersBeyondTheBudgetOfTheirParticipant) {
  for (const int count : {converter_burst - 1, converter_burst, converter_burst + 1}) {
    NeighbourQueue queue;
    for (int number = 0; number < count; ++number)
      queue.push(put_converter(key(1, static_cast<std::uint32_t>(number))));
    EXPECT_EQ(count_due(queue, at(0)), std::min(count, converter_burst)) << count;
    EXPECT_EQ(queue.held(), static_cast<std::size_t>(std::max(0, count - converter_burst)));
  }
}

TEST(NeighbourQueue, GivesTheLastChangeOfAConverterWhenThereIsBudgetAgain) {
  constexpr int period = 1000 / converter_changes_per_second;
  NeighbourQueue queue;
  for (std::uint32_t count = 0; count < converter_burst; ++count) queue.push(put_converter(key(1, 1000 + count)));
  EXPECT_EQ(count_due(queue, at(0)), converter_burst);
  for (std::uint16_t port = 1; port <= 100; ++port) {
    for (const std::uint32_t number : {1U, 2U}) queue.push(put_converter(key(1, number), port));
    EXPECT_EQ(count_due(queue, at(0)), 0);
  }
  queue.push(put(key(1, 3), 7));
  EXPECT_EQ(count_due(queue, at(0)), 1) << "what converts nothing does not wait";
  queue.push(put_converter(key(2, 1)));
  EXPECT_EQ(count_due(queue, at(0)), 1) << "another participant has a budget of its own";
  EXPECT_EQ(queue.next_due(), at(period));
  EXPECT_EQ(count_due(queue, at(period - 1)), 0);
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(period))).publication.port, 100);
  EXPECT_EQ(count_due(queue, at(period)), 0);
  EXPECT_EQ(count_due(queue, at(2 * period)), 1);
  EXPECT_EQ(queue.next_due(), base::never);
}

TEST(NeighbourQueue, DropsWhatIsHeldWhenItsServiceOrItsParticipantGoes) {
  NeighbourQueue queue;
  for (std::uint32_t count = 0; count < converter_burst; ++count) queue.push(put_converter(key(1, 1000 + count)));
  EXPECT_EQ(count_due(queue, at(0)), converter_burst);
  for (const std::uint32_t number : {1U, 2U, 3U, 4U}) queue.push(put_converter(key(1, number)));
  EXPECT_EQ(count_due(queue, at(0)), 0);
  queue.push(membership::RemovePublication{key(1, 1), membership::Departure::withdrawn});
  queue.push(put(key(1, 2), 9));
  EXPECT_EQ(queue.held(), 2U);
  EXPECT_TRUE(std::holds_alternative<membership::RemovePublication>(*queue.pop(at(0))));
  EXPECT_EQ(std::get<membership::PutPublication>(*queue.pop(at(0))).publication.port, 9);
  queue.push(membership::RemoveParticipant{ParticipantId{1}, membership::Departure::left});
  EXPECT_EQ(queue.held(), 0U);
  EXPECT_EQ(count_due(queue, at(0)), 1);
  EXPECT_FALSE(queue.has_due(at(1'000'000)));
}

TEST(NeighbourQueue, HoldsChangesOfConvertersBeyondTheBudgetOfAll) {
  NeighbourQueue queue;
  constexpr std::uint32_t participants = converter_burst_of_all / converter_burst + 1;
  for (std::uint32_t one = 1; one <= participants; ++one) {
    for (std::uint32_t number = 0; number < converter_burst; ++number) queue.push(put_converter(key(one, number)));
  }
  EXPECT_EQ(count_due(queue, at(0)), converter_burst_of_all);
  EXPECT_EQ(count_due(queue, at(1000)), std::min(converter_changes_per_second_of_all, converter_burst));
}

/// A neighbour that offers much, a consumer that asks for all of it many times, and somebody who pings when it is told.
class NeighboursTest : public testing::Test {
 protected:
  NeighboursTest() {
    host.switch_on();
    neighbour.switch_on();
    world.run_for(milliseconds(500));
    consumer.on_line = [this](std::string_view line, const gcnp::Statement&) {
      if (line.find(" pub ") == std::string_view::npos) return;
      if (!is_waiting) {
        is_waiting = true;
        at_ping = events;
        victim.say("0 sys ping");
      }
      ++events;
    };
    consumer.connect(host);
    for (int number = 1; number <= requests; ++number) {
      consumer.say(std::to_string(number) + " sub create mode=otm/stream text=x");
    }
    victim.on_line = [this](std::string_view, const gcnp::Statement&) {
      worst = std::max(worst, events - at_ping);
      is_waiting = false;
    };
    victim.connect(host);
    world.run_for(milliseconds(10));
    provider.connect(neighbour);
    for (int number = 1; number <= services; ++number) {
      provider.say(std::to_string(number) + " pub create mode=otm/stream text=x port=1");
    }
  }

  /// The events of one turn and of one step beyond it; and the turns that come while a ping is on its way.
  static constexpr int told_in_turn = static_cast<int>(work_in_turn / cost_of_event) + 250;
  static constexpr int told_meanwhile = 4 * told_in_turn;
  static constexpr int requests = 80;
  static constexpr int services = 250;
  sim::World world{sim::World::seed_or(1)};
  sim::Host& host = world.add_host("robot1");
  sim::Host& neighbour = world.add_host("robot2");
  sim::Client& provider = world.add_client("provider");
  sim::Client& consumer = world.add_client("consumer");
  sim::Client& victim = world.add_client("victim");
  int events = 0;
  bool is_waiting = false;  ///< for a pong
  int at_ping = 0;          ///< events, when it was asked for
  int worst = 0;            ///< the most events that were told between a ping and its pong
};

TEST_F(NeighboursTest, APingWaitsForOneTurnOfWhatANeighbourAnnouncesAndOfItsDeparture) {
  world.run_for(seconds(3));
  EXPECT_EQ(consumer.view(1).size(), services);
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, told_meanwhile) << "announced";
  worst = 0;
  neighbour.stop();
  world.run_for(seconds(1));
  EXPECT_EQ(consumer.view(1).size(), 0U);
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, told_meanwhile) << "said goodbye";
}

TEST_F(NeighboursTest, OneThatComesBackAtOnceIsThereAgain) {
  world.run_for(seconds(3));
  neighbour.crash();
  neighbour.switch_on();
  provider.connect(neighbour);
  provider.say("1 pub create mode=otm/stream text=x port=1");
  world.run_for(seconds(12));
  EXPECT_EQ(consumer.view(1).size(), 1U);
  EXPECT_EQ(consumer.view(requests).size(), 1U);
}

}  // namespace
}  // namespace geminga::participant
