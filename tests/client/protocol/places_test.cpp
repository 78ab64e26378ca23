// Shared places against the vectors of all languages, listeners, cookies, and the budget of answers, in given time.
#include "client/protocol/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "client/protocol/answer_budget.hpp"
#include "client/protocol/cookies.hpp"
#include "client/protocol/listeners.hpp"
#include "client/protocol/vector_file.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;

constexpr base::Instant start{1000s};
constexpr Life one_life{1};

PeerAddress at_port(std::uint16_t port, const char* address = "10.0.0.1") { return *peer_address(address, port); }

TEST(Places, AreSharedAsInEveryLanguage) {
  const auto rows = vector_rows("places.tsv", 3);
  ASSERT_GE(rows.size(), 10U);
  for (const auto& row : rows) {
    Places places(std::stoul(row[0]));
    std::string results;
    Places::Number newcomers = 0;
    for (const std::string& word : words_of(row[1])) {
      if (word[0] == '!') {
        places.serve(std::stoul(word.substr(1)));
      } else if (word[0] == '-') {
        places.leave(std::stoul(word.substr(1)));
      } else {
        const auto address = "10.0.0." + std::to_string(word[0] - 'a' + 1);
        const auto number = ++newcomers;
        const auto given = places.take(number, at_port(static_cast<std::uint16_t>(number), address.c_str()));
        if (newcomers > 1) results += ' ';
        results += given.is_taken ? "taken" : "refused";
        if (given.loser) results += '-' + std::to_string(*given.loser);
      }
    }
    EXPECT_EQ(results, row[2]) << row[0] << ' ' << row[1];
  }
}

TEST(Crowding, IsToldOnceUntilAQuarterIsFree) {
  Places places(4);
  for (Places::Number i = 1; i <= 4; ++i) EXPECT_TRUE(places.take(i, at_port(1)).is_taken);
  Crowding crowding;
  EXPECT_EQ(crowding.on_left(places), Crowding::News::none);
  EXPECT_EQ(crowding.on_full(), Crowding::News::full);
  EXPECT_EQ(crowding.on_full(), Crowding::News::none);
  EXPECT_EQ(crowding.on_left(places), Crowding::News::none);
  places.leave(2);
  EXPECT_EQ(crowding.on_left(places), Crowding::News::free);
  EXPECT_EQ(crowding.on_left(places), Crowding::News::none);
  EXPECT_EQ(crowding.on_full(), Crowding::News::full);
}

TEST(Listeners, AreForgottenAfterThreeSecondsOfSilence) {
  Listeners listeners;
  EXPECT_TRUE(listeners.add({at_port(1), one_life}, start).is_added);
  listeners.find(at_port(1))->until = start + 1s + listener_patience;
  listeners.expire(start + listener_patience);
  EXPECT_EQ(listeners.all().size(), 1U);
  EXPECT_EQ(listeners.next_end(), start + 1s + listener_patience);
  listeners.expire(start + 1s + listener_patience);
  EXPECT_THAT(listeners.all(), IsEmpty());
  EXPECT_EQ(listeners.places().taken(), 0U);
}

TEST(Listeners, OfOneAddressTakeAllPlacesAndGiveThemToOthers) {
  Listeners listeners;
  for (std::uint16_t port = 1; port < max_listeners; ++port) {
    EXPECT_TRUE(listeners.add({at_port(port), one_life}, start).is_added);
  }
  EXPECT_TRUE(listeners.add({at_port(max_listeners), one_life}, start).is_added);
  EXPECT_FALSE(listeners.add({at_port(max_listeners + 1), one_life}, start).is_added);
  EXPECT_TRUE(listeners.add({at_port(1), one_life}, start).is_added) << "which has its place already";
  const auto other = listeners.add({at_port(1, "10.0.0.2"), one_life}, start);
  ASSERT_TRUE(other.is_added && other.loser);
  EXPECT_EQ(other.loser->address, at_port(1)) << "the newest one";
  EXPECT_EQ(listeners.find(at_port(1)), nullptr);
  EXPECT_EQ(listeners.all().size(), max_listeners);
  listeners.end(at_port(2));
  EXPECT_TRUE(listeners.add({at_port(max_listeners + 1), one_life}, start).is_added);
}

TEST(Cookies, AreGoodInTheirEightSecondsAndTheNext) {
  const Cookies cookies;
  const base::Instant begin{8000s};
  const auto cookie = cookies.make(at_port(1), one_life, 7, begin);
  EXPECT_NE(cookie, 0U);
  EXPECT_TRUE(cookies.accepts(cookie, at_port(1), one_life, 7, begin));
  EXPECT_TRUE(cookies.accepts(cookie, at_port(1), one_life, 7, begin + 2 * cookie_interval - 1ns));
  EXPECT_FALSE(cookies.accepts(cookie, at_port(1), one_life, 7, begin + 2 * cookie_interval));
  EXPECT_FALSE(cookies.accepts(cookie, at_port(2), one_life, 7, begin)) << "another port";
  EXPECT_FALSE(cookies.accepts(cookie, at_port(1, "10.0.0.2"), one_life, 7, begin));
  EXPECT_FALSE(cookies.accepts(cookie, at_port(1), Life{2}, 7, begin));
  EXPECT_FALSE(cookies.accepts(cookie, at_port(1), one_life, 8, begin));
  EXPECT_FALSE(cookies.accepts(0, at_port(1), one_life, 7, begin));
  EXPECT_FALSE(Cookies().accepts(cookie, at_port(1), one_life, 7, begin)) << "of another publisher";
}

TEST(AnswerBudget, IsWholeAgainAfterASecond) {
  AnswerBudget budget;
  for (std::size_t i = 0; i < max_answers; ++i) ASSERT_TRUE(budget.take(start)) << i;
  EXPECT_FALSE(budget.take(start));
  EXPECT_FALSE(budget.take(start + 1ms));
  EXPECT_TRUE(budget.take(start + 2ms));
  EXPECT_FALSE(budget.take(start + 2ms));
  std::size_t renewals = 0;
  while (budget.take_renewal(start + 10s)) ++renewals;
  EXPECT_EQ(renewals, max_answers / 2) << "the other half is for newcomers";
  std::size_t given = 0;
  while (budget.take(start + 10s)) ++given;
  EXPECT_EQ(given, max_answers / 2);
}

}  // namespace
}  // namespace geminga::client
