// Hosts that get copies though nobody named them: where, and how much of it.
#include "env/asio/guests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::env {
namespace {

namespace ip = boost::asio::ip;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Clock::time_point start{std::chrono::hours(1)};
constexpr InterfaceIndex wlan{2};
constexpr InterfaceIndex lan{3};

Guests::Sender sender(std::uint16_t port, std::size_t octets = 100) {
  return {.to = {ip::make_address("192.0.2.7"), port},
          .via = ip::make_address("192.0.2.1"),
          .interface = wlan,
          .octets = octets};
}

TEST(Guests, AreSpokenToForAsLongAsItWasSaidOnTheirInterface) {
  Guests guests;
  EXPECT_THAT(guests.take_routes(1000, wlan, start), IsEmpty());
  guests.answer(sender(1), seconds(10), start);
  const auto routes = guests.take_routes(1000, wlan, start);
  ASSERT_THAT(routes, SizeIs(1));
  EXPECT_EQ(routes[0].to.port(), 1);
  EXPECT_EQ(routes[0].via, ip::make_address("192.0.2.1"));
  EXPECT_THAT(guests.take_routes(1000, lan, start), IsEmpty());
  EXPECT_THAT(guests.take_routes(1000, wlan, start + seconds(10) - milliseconds(1)), SizeIs(1));
  EXPECT_EQ(guests.count(start + seconds(10) - milliseconds(1)), 1U);
  EXPECT_THAT(guests.take_routes(1000, wlan, start + seconds(10)), IsEmpty());
  EXPECT_EQ(guests.count(start + seconds(10)), 0U);
}

TEST(Guests, StayAsLongAsTheyWereToldLast) {
  Guests guests;
  guests.answer(sender(1), seconds(300), start);
  guests.answer(sender(1), seconds(10), start);
  EXPECT_THAT(guests.take_routes(1000, wlan, start + seconds(100)), SizeIs(1)) << "a later word does not shorten it";
}

TEST(Guests, WhoHasProvedNothingIsAnsweredOnceByNothingLarge) {
  Guests guests;
  guests.answer(sender(1, 100), base::Duration(0), start);
  EXPECT_EQ(guests.count(start), 0U);
  EXPECT_THAT(guests.take_routes(max_answer_ratio * 100 + 1, wlan, start), IsEmpty());
  EXPECT_THAT(guests.take_routes(max_answer_ratio * 100, wlan, start), SizeIs(1));
  EXPECT_THAT(guests.take_routes(1, wlan, start), IsEmpty()) << "once";
}

TEST(Guests, AnAnswerForWhoIsOneAlreadyIsNoneMore) {
  Guests guests;
  guests.answer(sender(1), seconds(10), start);
  guests.answer(sender(1), base::Duration(0), start);
  EXPECT_THAT(guests.take_routes(1, wlan, start), SizeIs(1));
}

TEST(Guests, AnswersAreLimitedInEachSecond) {
  Guests guests;
  for (std::uint16_t port = 1; port <= max_answers_per_second + 1; ++port) {
    guests.answer(sender(port), base::Duration(0), start);
  }
  EXPECT_THAT(guests.take_routes(1, wlan, start), SizeIs(max_answers_per_second));
  guests.answer(sender(99), base::Duration(0), start + milliseconds(999));
  EXPECT_THAT(guests.take_routes(1, wlan, start), IsEmpty());
  guests.answer(sender(99), base::Duration(0), start + seconds(1));
  EXPECT_THAT(guests.take_routes(1, wlan, start), SizeIs(1));
}

TEST(Guests, OneTooManyTakesThePlaceOfTheOneThatWouldGoFirst) {
  Guests guests;
  for (std::uint16_t port = 1; port <= max_guests; ++port) {
    guests.answer(sender(port), port == 5 ? seconds(10) : seconds(20), start);
  }
  EXPECT_EQ(guests.count(start), max_guests);
  guests.answer(sender(1000), seconds(15), start);
  EXPECT_EQ(guests.count(start), max_guests);
  for (const Route& route : guests.take_routes(1, wlan, start)) EXPECT_NE(route.to.port(), 5);
}

}  // namespace
}  // namespace geminga::env
