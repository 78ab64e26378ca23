// Tables: look-ups by key, identity and concept, and walks in order of key.
#include "discovery/registry/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "discovery/registry/entries.hpp"

namespace geminga::registry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Registry, FindsAnEntryByItsKeyUntilItIsErased) {
  Publications table;
  EXPECT_EQ(table.find(key(1, 1, 1)), nullptr);
  const auto& stored = table.insert(offer(key(1, 1, 1), TextIdentity{"a"}), {});
  EXPECT_EQ(table.find(key(1, 1, 1)), &stored);
  EXPECT_EQ(table.find(key(1, 1, 2)), nullptr);
  EXPECT_EQ(table.size(), 1U);
  table.erase(stored);
  EXPECT_EQ(table.find(key(1, 1, 1)), nullptr);
  EXPECT_EQ(table.size(), 0U);
}

TEST(Registry, SlotsAreDenseAndUsedAgain) {
  Publications table;
  const auto& one = table.insert(offer(key(1, 1, 1), TextIdentity{"a"}), {});
  const auto& two = table.insert(offer(key(1, 1, 2), TextIdentity{"a"}), {});
  EXPECT_EQ(one.slot, 0U);
  EXPECT_EQ(two.slot, 1U);
  table.erase(one);
  EXPECT_EQ(table.insert(offer(key(1, 1, 3), TextIdentity{"a"}), {}).slot, 0U);
  EXPECT_EQ(table.insert(offer(key(1, 1, 4), TextIdentity{"a"}), {}).slot, 2U);
}

TEST(Registry, ListsByKeyByParticipantAndByPeer) {
  Publications table;
  for (const auto& one : {key(2, 1, 1), key(1, 2, 7), key(1, 1, 9), key(1, 2, 3), key(3, 0, 0)}) {
    table.insert(offer(one, TextIdentity{"a"}), {});
  }
  std::vector<ServiceKey> all;
  table.visit_after(std::nullopt, [&all](const StoredPublication& stored) {
    all.push_back(stored.entry.key);
    return true;
  });
  EXPECT_THAT(all, ElementsAre(key(1, 1, 9), key(1, 2, 3), key(1, 2, 7), key(2, 1, 1), key(3, 0, 0)));
  EXPECT_THAT(keys_of(table.of_participant(ParticipantId{1})), ElementsAre(key(1, 1, 9), key(1, 2, 3), key(1, 2, 7)));
  EXPECT_THAT(keys_of(table.of_participant(ParticipantId{4})), IsEmpty());
  EXPECT_THAT(keys_of(table.of_peer(ParticipantId{1}, PeerId{2})), ElementsAre(key(1, 2, 3), key(1, 2, 7)));
  EXPECT_THAT(keys_of(table.of_peer(ParticipantId{2}, PeerId{2})), IsEmpty());
}

TEST(Registry, CollidingIdentitiesAreTwo) {
  for (const bool is_turned : {false, true}) {
    std::vector<Identity> names{TextIdentity{"service-3352"}, TextIdentity{"service-724358"},
                                NumericIdentity{0x9ddb3b5f}};
    if (is_turned) std::ranges::reverse(names);
    Publications table;
    for (std::uint32_t i = 0; i < names.size(); ++i) table.insert(offer(key(1, 1, i), names[i]), {});
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      EXPECT_EQ(id32(names[i]), id32(names.front()));
      EXPECT_THAT(keys_of_filed(table.with_identity(names[i], id32(names[i]))), ElementsAre(key(1, 1, i)));
    }
    table.erase(*table.find(key(1, 1, 0)));
    EXPECT_THAT(keys_of_filed(table.with_identity(names[0], id32(names[0]))), IsEmpty());
    EXPECT_THAT(keys_of_filed(table.with_identity(names[1], id32(names[1]))), ElementsAre(key(1, 1, 1)));
  }
}

TEST(Registry, FindsAConceptInEveryRepresentation) {
  Publications table;
  table.insert(offer(key(1, 1, 1), semantic("Ball", "Frame")), {});
  table.insert(offer(key(1, 1, 2), semantic("Ball")), {});
  table.insert(offer(key(1, 1, 3), semantic("Goal", "Frame")), {});
  table.insert(offer(key(1, 1, 4), TextIdentity{"<http://example.org/Ball>"}), {});
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/Ball")), ElementsAre(key(1, 1, 1), key(1, 1, 2)));
  const Identity alone = semantic("Ball");
  EXPECT_THAT(keys_of_filed(table.with_identity(alone, id32(alone))), ElementsAre(key(1, 1, 2)));
  table.erase(*table.find(key(1, 1, 2)));
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/Ball")), ElementsAre(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.with_identity(alone, id32(alone))), IsEmpty());
  table.erase(*table.find(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/Ball")), IsEmpty());
}

TEST(Registry, AReplacedEntryIsFoundByWhatItIsNow) {
  Publications table;
  const auto& stored = table.insert(offer(key(1, 1, 1), semantic("Ball")), {});
  const auto slot = stored.slot;
  table.replace(stored, offer(key(1, 1, 1), TextIdentity{"ball"}, at(5)), {});
  EXPECT_EQ(table.find(key(1, 1, 1)), &stored);
  EXPECT_EQ(stored.slot, slot);
  EXPECT_EQ(stored.identity, id32(TextIdentity{"ball"}));
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/Ball")), IsEmpty());
  EXPECT_THAT(keys_of_filed(table.with_identity(TextIdentity{"ball"}, id32(TextIdentity{"ball"}))),
              ElementsAre(key(1, 1, 1)));
  EXPECT_EQ(stored.updated, at(5));
}

TEST(Registry, ARefreshedEntryIsTheSameButForItsAge) {
  Publications table;
  const auto& stored = table.insert(offer(key(1, 1, 1), TextIdentity{"a"}, at(0)), {});
  table.refresh(stored, at(4));
  EXPECT_EQ(table.find(key(1, 1, 1)), &stored);
  EXPECT_EQ(stored.updated, at(4));
  EXPECT_TRUE(stored.entry.same_as(offer(key(1, 1, 1), TextIdentity{"a"})));
}

TEST(Registry, SubscriptionsStandUnderTheSameKeys) {
  Subscriptions table;
  SubscriptionEntry entry;
  entry.key = key(1, 2, 3);
  entry.subscription.identity = semantic("Ball", "Frame");
  table.set_class_count(2);
  table.insert(entry, Filing{1, {}});
  EXPECT_THAT(keys_of_filed(table.own(1)), ElementsAre(key(1, 2, 3)));
  EXPECT_THAT(keys_of_filed(table.below(1)), IsEmpty());
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/Ball")), ElementsAre(key(1, 2, 3)));
}

}  // namespace
}  // namespace geminga::registry
