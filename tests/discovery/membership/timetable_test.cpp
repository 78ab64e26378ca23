// Deadlines that move to later, move nearer and go.
#include "discovery/membership/timetable.hpp"

#include <gmock/gmock.h>

#include <map>

#include "base/random.hpp"

namespace geminga::membership {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

base::Instant at(std::int64_t time) { return base::Instant(base::Duration(time)); }

TEST(Timetable, KnowsTheEarliestWhateverMoves) {
  Timetable timetable;
  EXPECT_EQ(timetable.next(), base::never);
  const auto first = timetable.take(ParticipantId{1});
  const auto second = timetable.take(ParticipantId{2});
  timetable.set(first, at(10));
  timetable.set(second, at(20));
  EXPECT_EQ(timetable.next(), at(10));
  timetable.set(first, at(30));
  EXPECT_EQ(timetable.next(), at(20));
  timetable.set(second, base::never);
  EXPECT_EQ(timetable.next(), at(30));
  timetable.give(first);
  EXPECT_EQ(timetable.next(), base::never);
}

TEST(Timetable, GivesWhatIsDueInTheOrderOfIdentifiers) {
  Timetable timetable;
  for (const std::uint32_t id : {7U, 3U, 5U}) timetable.set(timetable.take(ParticipantId{id}), at(10 + id));
  EXPECT_THAT(timetable.due(at(12)), IsEmpty());
  EXPECT_THAT(timetable.due(at(17)), ElementsAre(ParticipantId{3}, ParticipantId{5}, ParticipantId{7}));
}

TEST(Timetable, IsRightWhateverIsDoneAndKeepsFewEntries) {
  Timetable timetable;
  base::Random random(7);
  std::map<Slot, base::Instant> known;
  for (int step = 0; step < 20'000; ++step) {
    const auto chosen =
        known.empty() ? known.end() : std::next(known.begin(), static_cast<std::ptrdiff_t>(random.below(known.size())));
    if (known.size() < 5 || (known.size() < 20 && random.chance(0.05))) {
      known[timetable.take(ParticipantId{static_cast<std::uint32_t>(step + 1)})] = base::never;
    } else if (random.chance(0.05)) {
      timetable.give(chosen->first);
      known.erase(chosen);
    } else {
      chosen->second = random.chance(0.1) ? base::never : at(static_cast<std::int64_t>(random.below(1000)));
      timetable.set(chosen->first, chosen->second);
    }
    auto earliest = base::never;
    for (const auto& [slot, due] : known) earliest = std::min(earliest, due);
    ASSERT_EQ(timetable.next(), earliest);
    ASSERT_LE(timetable.entries(), 4U * 21U);
  }
}

}  // namespace
}  // namespace geminga::membership
