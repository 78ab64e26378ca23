// Choices: order, limits, incumbents.
#include "discovery/matching/arbitration/choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class Arbitration : public testing::Test {
 protected:
  Rank rank(std::uint32_t number, std::int32_t priority, Degree degree = Degree::exact, std::uint32_t distance = 0) {
    return {priority, {degree, distance}, {ParticipantId{1}, PeerId{1}, number}};
  }

  const registry::StoredPublication& store(const ServiceKey& key) {
    auto entry = std::make_shared<registry::PublicationEntry>();
    entry->key = key;
    return stored_.emplace_back(std::move(entry));
  }

  void offer(const Rank& rank) {
    const auto& stored = store(rank.key);
    ranks_[rank.key.number] = rank;
    choice_.offer(rank, stored);
    collect_dropped();
  }

  void collect_dropped() {
    for (const auto* dropped : choice_.take_dropped()) dropped_.push_back(dropped);
  }

  /// One settling in words: "-1 outranked", "*2", "+3".
  std::vector<std::string> settle() {
    std::vector<std::string> words;
    const Verdict verdict = choice_.settle([this] {
      ++refills_;
      for (const auto* dropped : std::exchange(dropped_, {})) {
        choice_.offer(ranks_.at(dropped->entry.key.number), *dropped);
        collect_dropped();
      }
    });
    collect_dropped();
    const auto number = [](const auto& about) { return std::to_string(about.publication->entry.key.number); };
    for (const auto& gone : verdict.gone)
      words.push_back("-" + number(gone) + " " + std::string(to_string(gone.reason)));
    for (const auto& kept : verdict.kept) words.push_back("*" + number(kept));
    for (const auto& come : verdict.come) words.push_back("+" + number(come));
    for (const auto& gone : verdict.outranked) {
      words.push_back("-" + number(gone) + " " + std::string(to_string(gone.reason)));
    }
    return words;
  }

  std::deque<registry::StoredPublication> stored_;
  std::map<std::uint32_t, Rank> ranks_;
  Choice::Dropped dropped_;
  int refills_ = 0;
  Choice choice_;
};

TEST_F(Arbitration, RanksByPriorityThenDegreeThenDistanceThenKey) {
  const std::vector<Rank> best_first{rank(9, 3, Degree::broader, 9),
                                     rank(1, 2),
                                     rank(2, 2),
                                     rank(8, 1, Degree::exact),
                                     rank(7, 1, Degree::equivalent),
                                     rank(6, 1, Degree::narrower, 1),
                                     rank(5, 1, Degree::narrower, 2),
                                     rank(4, 1, Degree::broader, 1),
                                     rank(3, -1)};
  for (std::size_t i = 0; i < best_first.size(); ++i) {
    for (std::size_t j = 0; j < best_first.size(); ++j) {
      EXPECT_EQ(BestFirst{}(best_first[i], best_first[j]), i < j) << i << ' ' << j;
    }
  }
}

TEST_F(Arbitration, WithoutALimitAllAreChosenBestFirst) {
  for (const auto& one : {rank(1, 0), rank(2, 5), rank(3, 0, Degree::narrower, 1)}) offer(one);
  EXPECT_THAT(settle(), ElementsAre("+2", "+1", "+3"));
  EXPECT_THAT(settle(), IsEmpty());
}

TEST_F(Arbitration, TheBetterOneComesBeforeTheWorstGoes) {
  choice_.set_limit(2);
  offer(rank(1, 1));
  offer(rank(2, 2));
  EXPECT_THAT(settle(), ElementsAre("+2", "+1"));
  offer(rank(3, 3));
  EXPECT_THAT(settle(), ElementsAre("+3", "-1 outranked"));
}

TEST_F(Arbitration, AnIncumbentWinsATieAndLosesToWhatIsBetter) {
  choice_.set_limit(1);
  offer(rank(5, 1));
  EXPECT_THAT(settle(), ElementsAre("+5"));
  offer(rank(1, 1));
  EXPECT_THAT(settle(), IsEmpty());
  offer(rank(2, 1, Degree::narrower, 1));
  EXPECT_THAT(settle(), IsEmpty());
  choice_.withdraw(rank(5, 1), Reason::expired);
  EXPECT_THAT(settle(), ElementsAre("-5 expired", "+1"));
  offer(rank(9, 2));
  EXPECT_THAT(settle(), ElementsAre("+9", "-1 outranked"));
}

TEST_F(Arbitration, NewcomersThatTieAreTakenByKey) {
  choice_.set_limit(1);
  offer(rank(7, 1));
  offer(rank(4, 1));
  EXPECT_THAT(settle(), ElementsAre("+4"));
}

TEST_F(Arbitration, ALimitThatShrinksAndGrowsKeepsTheBest) {
  for (std::uint32_t number = 1; number <= 4; ++number) offer(rank(number, static_cast<std::int32_t>(number)));
  EXPECT_THAT(settle(), ElementsAre("+4", "+3", "+2", "+1"));
  choice_.set_limit(2);
  EXPECT_THAT(settle(), ElementsAre("-1 outranked", "-2 outranked"));
  choice_.set_limit(3);
  EXPECT_THAT(settle(), ElementsAre("+2"));
  choice_.set_limit(0);
  EXPECT_THAT(settle(), ElementsAre("+1"));
}

TEST_F(Arbitration, AChosenOneThatChangesIsKeptWhereItStillWins) {
  choice_.set_limit(1);
  offer(rank(1, 3));
  offer(rank(2, 2));
  EXPECT_THAT(settle(), ElementsAre("+1"));
  choice_.change(rank(1, 3), rank(1, 2));
  EXPECT_THAT(settle(), ElementsAre("*1")) << "a tie now, and it is the incumbent";
  choice_.change(rank(1, 2), rank(1, 1));
  EXPECT_THAT(settle(), ElementsAre("+2", "-1 outranked"));
  choice_.change(rank(1, 1), rank(1, 0));
  EXPECT_THAT(settle(), IsEmpty()) << "nobody sees a change of one that waits";
  choice_.change(rank(1, 0), rank(1, 9));
  EXPECT_THAT(settle(), ElementsAre("+1", "-2 outranked"));
}

TEST_F(Arbitration, OneThatWasChosenUnseenIsAnIncumbent) {
  choice_.set_limit(1);
  const auto& stored = store({.participant = {}, .peer = {}, .number = 9});
  choice_.offer({1, {}, stored.entry.key}, stored, true);
  offer(rank(1, 1));
  EXPECT_THAT(settle(), IsEmpty());
}

TEST_F(Arbitration, RemembersUpToItsLimitOfWaitingOnesAndSearchesAgainForMore) {
  constexpr std::uint32_t limit = 2;
  constexpr auto most = static_cast<std::uint32_t>(first_waiting) + limit;
  choice_.set_limit(limit);
  offer(rank(1001, 9));
  offer(rank(1002, 9));
  EXPECT_THAT(settle(), ElementsAre("+1001", "+1002"));
  for (std::uint32_t number = 1; number < most; ++number) offer(rank(number, 1));
  EXPECT_TRUE(dropped_.empty());
  offer(rank(most, 1));
  EXPECT_TRUE(dropped_.empty());
  offer(rank(most + 1, 1));
  ASSERT_EQ(dropped_.size(), 1U) << "the worst by key";
  EXPECT_EQ(dropped_[0]->entry.key.number, most + 1);
  offer(rank(0, 1));
  ASSERT_EQ(dropped_.size(), 2U);
  EXPECT_EQ(dropped_[1]->entry.key.number, most) << "a better one takes its place";
  EXPECT_THAT(settle(), IsEmpty());
  for (std::uint32_t number = 0; number < most; ++number) choice_.withdraw(rank(number, 1), Reason::left);
  EXPECT_THAT(settle(), IsEmpty());
  EXPECT_EQ(refills_, 0) << "no dropped one could matter yet";
  choice_.withdraw(rank(1001, 9), Reason::left);
  EXPECT_THAT(settle(), ElementsAre("-1001 left", "+" + std::to_string(most)));
  EXPECT_EQ(refills_, 1);
  choice_.withdraw(rank(1002, 9), Reason::left);
  EXPECT_THAT(settle(), ElementsAre("-1002 left", "+" + std::to_string(most + 1)));
  EXPECT_EQ(refills_, 1) << "nobody was dropped since";
}

TEST_F(Arbitration, SearchesAgainWhenAChosenOneFallsBehindTheDropped) {
  constexpr auto most = static_cast<std::uint32_t>(first_waiting) + 1;
  choice_.set_limit(1);
  offer(rank(1001, 9));
  EXPECT_THAT(settle(), ElementsAre("+1001"));
  for (std::uint32_t number = 1; number <= most + 1; ++number) offer(rank(number, 1));
  for (std::uint32_t number = 1; number <= most; ++number) choice_.withdraw(rank(number, 1), Reason::left);
  ranks_[1001] = rank(1001, 0);
  choice_.change(rank(1001, 9), rank(1001, 0));
  EXPECT_THAT(settle(), ElementsAre("+" + std::to_string(most + 1), "-1001 outranked"));
  EXPECT_EQ(refills_, 1);
}

TEST_F(Arbitration, NobodyWaitsWhoRanksBehindADroppedOne) {
  constexpr auto most = static_cast<std::uint32_t>(first_waiting) + 1;
  choice_.set_limit(1);
  offer(rank(1001, 9));
  EXPECT_THAT(settle(), ElementsAre("+1001"));
  for (std::uint32_t number = 1; number <= most + 1; ++number) offer(rank(number, 5));
  ASSERT_EQ(dropped_.size(), 1U);
  for (std::uint32_t number = 1; number < most; ++number) choice_.withdraw(rank(number, 5), Reason::left);
  offer(rank(500, 1));
  EXPECT_EQ(dropped_.size(), 2U) << "there is room, but the one dropped before is better";
  ranks_[most] = rank(most, 0);
  choice_.change(rank(most, 5), rank(most, 0));
  collect_dropped();
  EXPECT_EQ(dropped_.size(), 3U) << "one that waited is the worst now";
  choice_.withdraw(rank(1001, 9), Reason::left);
  EXPECT_THAT(settle(), ElementsAre("-1001 left", "+" + std::to_string(most + 1)));
}

TEST_F(Arbitration, RemembersMoreWhereManyWerePassedOver) {
  constexpr std::uint32_t many = 10'000;
  constexpr std::uint32_t root = 100;
  choice_.set_limit(1);
  for (std::uint32_t number = 1; number <= many; ++number) offer(rank(number, 1));
  EXPECT_THAT(settle(), ElementsAre("+1"));
  std::uint32_t gone = 0;
  const auto leave_until_refill = [&](int refills) {
    const std::uint32_t before = gone;
    for (; refills_ < refills; static_cast<void>(settle())) choice_.withdraw(rank(++gone, 1), Reason::left);
    return gone - before;
  };
  leave_until_refill(1);
  EXPECT_NEAR(leave_until_refill(2), root, 2);
  EXPECT_NEAR(leave_until_refill(3), root, 2);
}

TEST_F(Arbitration, NoMoreWaitThanTheirLimitHoweverManyWerePassedOver) {
  constexpr auto most = static_cast<std::uint32_t>(first_waiting) + 1;
  choice_.set_limit(1);
  offer(rank(1, 1));
  EXPECT_THAT(settle(), ElementsAre("+1"));
  for (std::uint32_t number = 2; number <= 1 + most + 1; ++number) offer(rank(number, 1));
  for (std::size_t i = 0; i < (max_waiting + 1) * (max_waiting + 1); ++i) {
    ASSERT_TRUE(choice_.passes_over(rank(9000, 0)));
  }
  for (std::uint32_t number = 1; number <= 1 + most; ++number) choice_.withdraw(rank(number, 1), Reason::left);
  static_cast<void>(settle());
  ASSERT_EQ(refills_, 1);
  for (std::uint32_t number = 1; number <= 2 * max_waiting; ++number) offer(rank(10'000 + number, 0));
  EXPECT_EQ(choice_.candidates().size(), 1 + 1 + max_waiting)
      << "the chosen one, and as many as the limit and the room";
}

TEST_F(Arbitration, WithoutALimitNobodyIsDropped) {
  for (std::uint32_t number = 1; number <= 100; ++number) offer(rank(number, 1));
  EXPECT_TRUE(dropped_.empty());
  EXPECT_EQ(settle().size(), 100U);
}

}  // namespace
}  // namespace geminga::matching
