// Events that follow from the ontology, and from a change of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SemanticMatcher, TellsOfNarrowerConceptsWhicheverComesFirst) {
  const auto ontology = soccer();
  for (const bool offer_comes_first : {true, false}) {
    Matcher matcher(ontology);
    if (offer_comes_first) matcher.put(offer(key(2, 1, 7), semantic("OwnBall", "PolarFieldFrame")));
    matcher.put(request(key(here, 1, 1), semantic("Tracked", "Frame")));
    matcher.put(request(key(here, 1, 2), semantic("Robot")));
    if (!offer_comes_first) matcher.put(offer(key(2, 1, 7), semantic("OwnBall", "PolarFieldFrame")));
    EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 narrower 4"));
  }
}

TEST(SemanticMatcher, TheWeakestDegreeDecides) {
  const auto ontology = soccer();
  const std::vector<std::pair<const char*, Degree>> offers{{"Ball", Degree::exact},
                                                           {"Sphere", Degree::equivalent},
                                                           {"OwnBall", Degree::narrower},
                                                           {"Tracked", Degree::broader},
                                                           {"Robot", Degree::overlapping}};
  for (const auto weakest :
       {Degree::exact, Degree::equivalent, Degree::narrower, Degree::broader, Degree::overlapping}) {
    for (const auto& [concept_name, degree] : offers) {
      for (const bool offer_comes_first : {true, false}) {
        Matcher matcher(ontology);
        if (offer_comes_first) matcher.put(offer(key(2, 1, 7), semantic(concept_name)));
        matcher.put(request(key(here, 1, 1), semantic("Ball"), 0, weakest));
        if (!offer_comes_first) matcher.put(offer(key(2, 1, 7), semantic(concept_name)));
        const auto events = matcher.take_events();
        ASSERT_EQ(events.size(), degree <= weakest ? 1U : 0U) << concept_name << ' ' << to_string(weakest);
        if (!events.empty()) {
          EXPECT_EQ(events[0].match.degree, degree);
        }
      }
    }
  }
}

TEST(SemanticMatcher, ABetterDegreeOutranksAndAGreaterPriorityOutranksThat) {
  const auto ontology = soccer();
  Matcher matcher(ontology);
  matcher.put(request(key(here, 1, 1), semantic("Ball"), 1));
  matcher.put(offer(key(2, 1, 1), semantic("OwnBall")));
  matcher.put(offer(key(2, 1, 2), semantic("Sphere")));
  matcher.put(offer(key(2, 1, 3), semantic("Ball")));
  matcher.put(offer(key(2, 1, 4), semantic("OwnBall"), 1));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 narrower 1", "p1.1.1 pub add p2.1.2 equivalent 0",
                                         "p1.1.1 pub del p2.1.1 outranked", "p1.1.1 pub add p2.1.3 exact 0",
                                         "p1.1.1 pub del p2.1.2 outranked", "p1.1.1 pub add p2.1.4 narrower 1",
                                         "p1.1.1 pub del p2.1.3 outranked"));
}

TEST(SemanticMatcher, AServiceThatBecomesNarrowerIsModifiedForThoseWhoKeepIt) {
  const auto ontology = soccer();
  Matcher matcher(ontology);
  matcher.put(request(key(here, 1, 1), semantic("Tracked")));
  matcher.put(request(key(here, 1, 2), semantic("OwnBall")));
  matcher.put(request(key(here, 1, 3), semantic("Robot")));
  matcher.put(offer(key(2, 1, 1), semantic("Ball")));
  matcher.put(offer(key(2, 1, 1), semantic("OwnBall")));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 narrower 1", "p1.1.1 pub modify p2.1.1 narrower 2",
                                         "p1.1.2 pub add p2.1.1 exact 0"));
}

TEST(SemanticMatcher, AnotherOntologyTellsOnlyWhatItChanges) {
  const auto ontology = soccer();
  Taxonomy flat;
  flat.sub("OwnBall", "Tracked").sub("Ball", "Round");
  const auto other = flat.classified();
  Matcher matcher(ontology);
  matcher.put(request(key(here, 1, 1), semantic("Tracked")));
  matcher.put(request(key(here, 1, 2), semantic("Ball")));
  matcher.put(request(key(here, 1, 3), semantic("Round")));
  matcher.put(offer(key(2, 1, 1), semantic("OwnBall")));
  matcher.put(offer(key(2, 1, 2), semantic("Ball")));
  EXPECT_EQ(matcher.take_events().size(), 4U);
  change_vocabulary(matcher, other);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.2 changed", "p1.1.1 pub modify p2.1.1 narrower 1",
                                         "p1.1.2 pub del p2.1.1 changed", "p1.1.3 pub add p2.1.2 narrower 1"));
  change_vocabulary(matcher, other);
  EXPECT_THAT(told(matcher), IsEmpty());
  change_vocabulary(matcher, {});
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 changed", "p1.1.3 pub del p2.1.2 changed"));
  change_vocabulary(matcher, ontology);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.2 narrower 1", "p1.1.1 pub add p2.1.1 narrower 2",
                                         "p1.1.2 pub add p2.1.1 narrower 1"));
}

TEST(SemanticMatcher, SaysWhyAPairDoesNotMatch) {
  const auto ontology = soccer();
  Matcher matcher(ontology);
  const auto why = [&](const Identity& requested, const Identity& offered) {
    const auto match = matcher.examination().why(request(key(here, 1, 1), requested), offer(key(2, 1, 1), offered));
    return match ? "matches " + std::string(to_string(match->degree)) : match.error();
  };
  EXPECT_EQ(why(semantic("Tracked"), semantic("Ball")), "matches narrower");
  EXPECT_EQ(why(semantic("Ball"), semantic("Tracked")), "degree: broader, but at least narrower is asked for");
  EXPECT_EQ(why(semantic("Ball"), TextIdentity{"ball"}), "identity: a text is offered, a concept is asked for");
  EXPECT_EQ(why(NumericIdentity{1}, NumericIdentity{2}), "identity: 2 is offered, 1 is asked for");
  EXPECT_THAT(why(semantic("Ball"), semantic("Robot")), HasSubstr("neither subsumes the other"));
  EXPECT_THAT(why(semantic("Ball"), semantic("New")), HasSubstr("is unknown to the ontology"));
  EXPECT_THAT(why(semantic("Ball"), semantic("Ghost")), HasSubstr("is unsatisfiable"));
  EXPECT_THAT(why(semantic("Ball", "Frame"), semantic("Ball")), HasSubstr("representation: none is stated"));
  EXPECT_THAT(why(semantic("Ball", "Frame"), semantic("Ball", "Robot")), HasSubstr("representation: "));
  EXPECT_THAT(why(semantic("New", "Frame"), semantic("New", "FieldFrame")), HasSubstr("the concept has no class"));
}

TEST(SemanticMatcher, NamesEverythingThatDoesNotFit) {
  Matcher matcher;
  auto wish = request(key(here, 1, 1), TextIdentity{"ball"});
  wish.subscription.mode = ChannelMode::one_to_many_stream;
  wish.subscription.providers = {{"robot9", ""}};
  wish.subscription.where = "rate > 3";
  const auto match = matcher.examination().why(wish, offer(key(2, 1, 1), TextIdentity{"goal"}));
  ASSERT_FALSE(match);
  EXPECT_EQ(
      match.error(),
      "identity: goal is offered, ball is asked for; mode: oto is offered, otm/stream is asked for; provider: it is "
      "not among those that are asked for; filter: rate > 3 does not hold: rate is absent");
  wish.subscription.where = "rate >";
  EXPECT_THAT(matcher.examination().why(wish, offer(key(2, 1, 1), TextIdentity{"goal"})).error(),
              HasSubstr("filter: it cannot be read"));
}

}  // namespace
}  // namespace geminga::matching
