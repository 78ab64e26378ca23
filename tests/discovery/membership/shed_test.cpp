// A table gives up its newest strangers where memory is short, and many silent ones in several calls.
#include <gmock/gmock.h>

#include <string>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/table_rig.hpp"

namespace geminga::membership {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Shedding, GivesUpTheNewestQuarterOfThoseThatAreNotSeasoned) {
  TableRig rig;
  rig.source = "10.0.0.1";
  ASSERT_EQ(rig.hear(speaker(1, 1)), Hearing::newcomer);
  const base::Instant later = rig_start + announcement::seasoned_after;
  rig.hear(speaker(1, 1), later);
  ASSERT_EQ(rig.table.seasoned(), 1U);
  for (std::uint32_t id = 2; id <= 9; ++id) {
    rig.source = "10.0.0." + std::to_string(id);
    EXPECT_EQ(rig.hear(speaker(id, 1), later), Hearing::newcomer);
  }
  (void)rig.lines();
  EXPECT_EQ(rig.table.shed(later), 2U);
  EXPECT_THAT(rig.lines(), ElementsAre("remove 00000009 expired", "remove 00000008 expired"));
  EXPECT_EQ(rig.table.neighbours().size(), 7U);
  rig.source = "10.0.0.30";
  EXPECT_EQ(rig.hear(speaker(30, 1), later), Hearing::full) << "nobody comes while memory is short";
  rig.source = "10.0.0.1";
  EXPECT_EQ(rig.hear(speaker(1, 1), later), Hearing::known) << "who is known stays known";
  rig.source = "10.0.0.30";
  while (rig.table.shed(later) > 0) {
  }
  EXPECT_EQ(rig.table.neighbours().size(), 1U) << "a seasoned one is never given up";
  EXPECT_EQ(rig.hear(speaker(31, 1), later + memory_pause - milliseconds(1)), Hearing::full);
  EXPECT_EQ(rig.hear(speaker(32, 1), later + memory_pause), Hearing::newcomer);
}

TEST(Shedding, OfManyThatAreSilentTakesSomeInEachCall) {
  TableRig rig;
  const auto count = static_cast<std::uint32_t>(max_expired_at_once + 1);
  for (std::uint32_t id = 1; id <= count; ++id) {
    rig.source = "10.0.0." + std::to_string(id);
    rig.hear(speaker(id, 1));
  }
  const base::Instant end = rig_start + seconds(600);
  rig.table.expire(end);
  EXPECT_EQ(rig.table.neighbours().size(), 1U);
  EXPECT_LE(rig.table.next_deadline(), end) << "the rest is due at once";
  rig.table.expire(end);
  EXPECT_EQ(rig.table.neighbours().size(), 0U);
}

}  // namespace
}  // namespace geminga::membership
