// Requests for expressions: their places are given, as the daemon gives them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string tracked_or_so = "<http://example.org/Ball> or <http://example.org/Robot>";

/// A place right below Tracked and right above Ball and Robot.
class Places {
 public:
  explicit Places(const vocabulary::Vocabulary& ontology) {
    const auto number = [&](std::string_view name) { return *ontology.find_iri(iri(name)); };
    vocabulary::Place place;
    place.parents = {number("Tracked")};
    place.children = {number("Ball"), number("Robot")};
    place_ = std::make_shared<const vocabulary::Place>(place);
  }
  Placing placing() {
    return [this](const vocabulary::Vocabulary&, const std::string& expression, ParticipantId from) {
      asked[expression] = from;
      return is_known && expression == tracked_or_so ? place_ : nullptr;
    };
  }
  bool is_known = true;
  std::map<std::string, ParticipantId> asked;

 private:
  std::shared_ptr<const vocabulary::Place> place_;
};

Identity expression(const std::string& text) { return SemanticIdentity{text, ""}; }

TEST(ExpressionMatcher, MeetsWhatIsBelowWhicheverComesFirst) {
  const auto ontology = soccer();
  for (const bool offer_comes_first : {true, false}) {
    Places places(ontology);
    Matcher matcher(ontology, places.placing());
    const auto offers = [&] {
      matcher.put(offer(key(2, 1, 1), semantic("OwnBall")));
      matcher.put(offer(key(2, 1, 2), semantic("Sphere")));
      matcher.put(offer(key(2, 1, 3), semantic("Robot")));
      matcher.put(offer(key(2, 1, 4), semantic("Tracked")));
      matcher.put(offer(key(2, 1, 5), semantic("Frame")));
    };
    if (offer_comes_first) offers();
    matcher.put(request(key(here, 1, 1), expression(tracked_or_so)));
    if (!offer_comes_first) offers();
    EXPECT_THAT(told(matcher),
                testing::UnorderedElementsAre("p1.1.1 pub add p2.1.1 narrower 2", "p1.1.1 pub add p2.1.2 narrower 1",
                                              "p1.1.1 pub add p2.1.3 narrower 1"));
    EXPECT_EQ(places.asked[tracked_or_so], ParticipantId{here});
  }
}

TEST(ExpressionMatcher, MeetsWhatIsAboveWhereTheConsumerAllowsIt) {
  const auto ontology = soccer();
  for (const bool offer_comes_first : {true, false}) {
    Places places(ontology);
    Matcher matcher(ontology, places.placing());
    if (offer_comes_first) matcher.put(offer(key(2, 1, 4), semantic("Tracked")));
    matcher.put(request(key(here, 1, 1), expression(tracked_or_so), 0, Degree::broader));
    if (!offer_comes_first) matcher.put(offer(key(2, 1, 4), semantic("Tracked")));
    EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.4 broader 1"));
  }
}

TEST(ExpressionMatcher, MeetsNothingUntilItsPlaceIsKnown) {
  const auto ontology = soccer();
  Places places(ontology);
  places.is_known = false;
  Matcher matcher(ontology, places.placing());
  matcher.put(offer(key(2, 1, 1), semantic("Ball")));
  const auto asking = request(key(here, 1, 1), expression(tracked_or_so));
  matcher.put(asking);
  EXPECT_THAT(told(matcher), IsEmpty());
  EXPECT_THAT(matcher.examination().why(asking, *matcher.publications().find_entry(key(2, 1, 1))).error(),
              HasSubstr("waits to be classified"));
  place_again(matcher);
  EXPECT_THAT(told(matcher), IsEmpty());
  places.is_known = true;
  place_again(matcher);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 narrower 1"));
  place_again(matcher);
  EXPECT_THAT(told(matcher), IsEmpty());
}

TEST(ExpressionMatcher, ForgetsItsPlaceWithTheOntology) {
  const auto ontology = soccer();
  Places places(ontology);
  Matcher matcher(ontology, places.placing());
  matcher.put(offer(key(2, 1, 1), semantic("Ball")));
  matcher.put(request(key(here, 1, 1), expression(tracked_or_so)));
  (void)told(matcher);
  change_vocabulary(matcher, {});
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 changed"));
  change_vocabulary(matcher, ontology);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 narrower 1"));
}

TEST(ExpressionMatcher, MeetsOneOfferOnceThoughItIsBelowTwoChildren) {
  Taxonomy taxonomy;
  taxonomy.sub("Ball", "Tracked").sub("Robot", "Tracked").sub("BallRobot", "Ball").sub("BallRobot", "Robot");
  const auto ontology = taxonomy.classified();
  Places places(ontology);
  Matcher matcher(ontology, places.placing());
  matcher.put(offer(key(2, 1, 1), semantic("BallRobot")));
  const auto asking = request(key(here, 1, 1), expression(tracked_or_so));
  matcher.put(asking);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 narrower 2"));
  EXPECT_THAT(matched(matcher, asking.subscription), ElementsAre(key(2, 1, 1)));
  EXPECT_TRUE(matcher.search().is_served(asking));
  EXPECT_TRUE(matcher.search().is_used(*matcher.publications().find_entry(key(2, 1, 1))));
}

}  // namespace
}  // namespace geminga::matching
