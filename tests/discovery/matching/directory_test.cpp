// The directory files what comes by each vocabulary at work, and gives what was replaced.
#include "discovery/matching/directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/owners.hpp"
#include "discovery/matching/taxonomy.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<ServiceKey> keys(const std::vector<const registry::StoredSubscription*>& subscriptions) {
  std::vector<ServiceKey> found;
  for (const auto* one : subscriptions) found.push_back(one->entry.key);
  return found;
}

TEST(Directory, FindsTheSubscriptionsOfAPublicationByItsSuperclassesInOrderOfKey) {
  Owners owners(soccer());
  owners.add(request(key(here, 1, 3), semantic("Tracked")));
  owners.add(request(key(here, 1, 2), semantic("Robot")));
  owners.add(request(key(here, 1, 1), semantic("Sphere")));
  const auto& ball = owners.add(offer(key(2, 1, 1), semantic("OwnBall")));
  EXPECT_THAT(keys(owners.directory.subscriptions_for(ball)), ElementsAre(key(here, 1, 1), key(here, 1, 3)));
}

TEST(Directory, GivesTheEntryAndTheRequestThatWereReplaced) {
  Owners owners(soccer());
  const auto& offered = owners.add(offer(key(2, 1, 1), semantic("Ball"), 1));
  const auto& asked = owners.add(request(key(here, 1, 1), semantic("Robot")));
  const auto former = owners.directory.offers().replace(offered, offer(key(2, 1, 1), semantic("Robot"), 2));
  EXPECT_EQ(former->publication.priority, 1);
  EXPECT_EQ(offered.entry.publication.priority, 2);
  EXPECT_THAT(keys(owners.directory.subscriptions_for(offered)), ElementsAre(key(here, 1, 1)));
  auto next = request(key(here, 1, 1), semantic("Ball"));
  const Classes classes = owners.directory.requests().request(asked).classes;
  const auto before = owners.directory.requests().replace(asked, next, owners.preparation.prepare(next));
  EXPECT_EQ(before.entry->subscription.identity, semantic("Robot"));
  EXPECT_EQ(before.request.classes.concept_class, classes.concept_class);
  EXPECT_THAT(owners.directory.subscriptions_for(offered), IsEmpty());
}

TEST(Directory, SaysOfWhatIsRetiredThatItGoesAndWhy) {
  Owners owners;
  const auto& offered = owners.add(offer(key(2, 1, 1), TextIdentity{"ball"}));
  const auto& asked = owners.add(request(key(here, 1, 1), TextIdentity{"ball"}));
  EXPECT_FALSE(owners.directory.offers().is_going(offered));
  EXPECT_FALSE(owners.directory.requests().is_going(asked));
  owners.directory.offers().retire({&offered}, Reason::expired);
  owners.directory.requests().retire(asked);
  EXPECT_EQ(owners.directory.offers().reason_to_go(offered), Reason::expired);
  EXPECT_TRUE(owners.directory.requests().is_going(asked));
  owners.directory.offers().erase(offered);
  owners.directory.requests().erase(asked);
  EXPECT_EQ(owners.directory.offers().table().size() + owners.directory.requests().table().size(), 0U);
  const auto& again = owners.add(offer(key(2, 1, 1), TextIdentity{"ball"}));
  EXPECT_FALSE(owners.directory.offers().is_going(again)) << "its slot has been used before";
}

TEST(Directory, FilesByBothVocabulariesUntilTheFormerOneIsEmptied) {
  Owners owners(soccer());
  const auto& early = owners.add(offer(key(2, 1, 1), semantic("Car")));
  const auto next = soccer([](Taxonomy& taxonomy) { taxonomy.sub("Car", "Tracked"); });
  owners.editions.begin_filing(next);
  owners.directory.offers().open_index(owners.editions.other());
  owners.directory.requests().open_index(owners.editions.other());
  const auto& late = owners.add(offer(key(2, 1, 2), semantic("Car")));
  EXPECT_FALSE(owners.directory.offers().classes(early, owners.editions.other()).concept_class)
      << "its step has not come";
  EXPECT_TRUE(owners.directory.offers().classes(late, owners.editions.other()).concept_class);
  EXPECT_FALSE(owners.directory.offers().classes(late, owners.editions.in_force()).concept_class);
  owners.directory.offers().file(early, owners.editions.other());
  const auto& former = owners.add(request(key(here, 1, 1), semantic("Tracked")));
  owners.editions.begin_rematching();
  const auto& current = owners.add(request(key(here, 1, 2), semantic("Tracked")));
  EXPECT_NE(owners.directory.requests().edition_of(former).generation,
            owners.directory.requests().edition_of(current).generation);
  EXPECT_THAT(keys(owners.directory.subscriptions_for(early)), ElementsAre(current.entry.key));
  owners.directory.requests().unfile(former);
  owners.directory.requests().file(former, owners.preparation.prepare(former.entry));
  EXPECT_THAT(keys(owners.directory.subscriptions_for(early)), ElementsAre(former.entry.key, current.entry.key));
}

}  // namespace
}  // namespace geminga::matching
