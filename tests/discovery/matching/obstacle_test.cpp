// Obstacles between an offer and a request: a case for each, and which of two offers is nearer.
#include "discovery/matching/meeting/obstacle.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;

const ServiceKey asking = key(here, 1, 1);
const ServiceKey offering = key(2, 1, 1);

Finding found(const SubscriptionEntry& request, const PublicationEntry& offer, const vocabulary::Vocabulary& ontology) {
  const Matcher matcher(ontology);
  return matcher.examination().examine(request, *matcher.examination().prepare(request), offer);
}

Obstacle between(const Identity& offered, const Identity& requested, Degree weakest = Degree::narrower,
                 const vocabulary::Vocabulary& ontology = soccer()) {
  return found(request(asking, requested, 0, weakest), offer(offering, offered), ontology).first();
}

TEST(Obstacle, HasAWordForEach) {
  EXPECT_EQ(to_string(Obstacle::none), "none");
  EXPECT_EQ(to_string(Obstacle::representation_unstated), "representation_unstated");
  EXPECT_EQ(to_string(Obstacle::broader), "broader");
  EXPECT_EQ(to_string(Obstacle::ontology_differs), "ontology_differs");
}

TEST(Obstacle, OfAnIdentityIsTheFirstThatKeepsItApart) {
  EXPECT_EQ(between(semantic("OwnBall"), semantic("Ball")), Obstacle::none);
  EXPECT_EQ(between(TextIdentity{"Ball"}, semantic("Ball")), Obstacle::kind);
  EXPECT_EQ(between(NumericIdentity{7}, NumericIdentity{8}), Obstacle::number);
  EXPECT_EQ(between(TextIdentity{"camera"}, TextIdentity{"lidar"}), Obstacle::text);
  EXPECT_EQ(between(TextIdentity{"camera"}, TextIdentity{"Camrea"}), Obstacle::similar_text);
  EXPECT_EQ(between(semantic("OwnBall"), semantic("Ball"), Degree::narrower, {}), Obstacle::no_ontology);
  EXPECT_EQ(between(semantic("Ball"), semantic("New")), Obstacle::unknown_concept);
  EXPECT_EQ(between(semantic("New"), semantic("Ball")), Obstacle::unknown_offer);
  EXPECT_EQ(between(semantic("Ghost"), semantic("Ball")), Obstacle::unsatisfiable);
  EXPECT_EQ(between(semantic("Robot"), semantic("Ball")), Obstacle::unrelated);
  EXPECT_EQ(between(semantic("Ball"), SemanticIdentity{"(<http://x/A> and <http://x/B>)", ""}), Obstacle::unclassified);
  EXPECT_EQ(between(semantic("Ball", "Robot"), semantic("Ball", "Frame")), Obstacle::representation);
  EXPECT_EQ(between(semantic("Ball"), semantic("Ball", "Frame")), Obstacle::representation_unstated);
  EXPECT_EQ(between(semantic("Ball", "New"), semantic("Ball", "Frame")), Obstacle::unknown_representation);
  EXPECT_EQ(between(semantic("Tracked"), semantic("Ball")), Obstacle::broader);
  EXPECT_EQ(between(semantic("Tracked"), semantic("Ball"), Degree::broader), Obstacle::none);
  EXPECT_EQ(between(semantic("OwnBall"), semantic("Ball"), Degree::equivalent), Obstacle::degree);
  EXPECT_EQ(between(semantic("Sphere"), semantic("Ball"), Degree::exact), Obstacle::degree);
}

TEST(Obstacle, AnExpressionWhosePlaceHasGapsMayMissWhatIsBelowAllThatIsKnownToBeAboveIt) {
  const auto ontology = soccer();
  vocabulary::Place place;
  place.parents = {*ontology.find_iri(iri("Tracked"))};
  place.children = {*ontology.find_iri(iri("OwnBall"))};
  const auto between_gaps = [&](const Identity& offered, Degree weakest = Degree::narrower) {
    const auto shared = std::make_shared<const vocabulary::Place>(place);
    const Matcher matcher(ontology,
                          [&](const vocabulary::Vocabulary&, const std::string&, ParticipantId) { return shared; });
    const SubscriptionEntry asked =
        request(asking, SemanticIdentity{"(<http://x/A> and <http://x/B>)", ""}, 0, weakest);
    const auto found =
        matcher.examination().examine(asked, *matcher.examination().prepare(asked), offer(offering, offered)).first();
    const auto why = matcher.examination().why(asked, offer(offering, offered));
    EXPECT_EQ(!why && why.error().find("the answer may be incomplete") != std::string::npos,
              found == Obstacle::incomplete);
    return found;
  };
  EXPECT_EQ(between_gaps(semantic("Ball")), Obstacle::unrelated);
  place.gaps = {"a gap"};
  EXPECT_EQ(between_gaps(semantic("Ball")), Obstacle::incomplete);
  EXPECT_EQ(between_gaps(semantic("OwnBall")), Obstacle::none);
  EXPECT_EQ(between_gaps(semantic("Tracked")), Obstacle::broader);
  EXPECT_EQ(between_gaps(semantic("Frame")), Obstacle::unrelated);
  EXPECT_EQ(between_gaps(semantic("New")), Obstacle::unknown_offer);
  EXPECT_EQ(between_gaps(semantic("Ghost")), Obstacle::unrelated);
  place.parents = {*ontology.find_iri(iri("Robot"))};
  EXPECT_EQ(between_gaps(semantic("Ball")), Obstacle::unrelated) << "it is below no Robot";
  EXPECT_EQ(between_gaps(semantic("Ball"), Degree::broader), Obstacle::incomplete) << "but above what is below it";
}

TEST(Obstacle, OfTheRestComesInTheOrderInWhichAPairIsWalked) {
  SubscriptionEntry asked = request(asking, semantic("Ball"));
  asked.subscription.protocols = {"tcp"};
  asked.subscription.providers = {{"robot9", ""}};
  asked.subscription.where = "rate > 5";
  asked.subscription.scope = "host";
  asked.subscription.on = "<" + iri("Robot") + ">";
  PublicationEntry offered = offer(offering, semantic("Tracked"), 0, ChannelMode::one_to_many_stream);
  offered.publication.for_whom = "rate > 5";
  const auto next = [&] { return found(asked, offered, soccer()); };
  EXPECT_EQ(next().first(), Obstacle::broader);
  EXPECT_EQ(next().count(), 8U);
  offered.publication.identity = semantic("Ball");
  EXPECT_EQ(next().first(), Obstacle::mode);
  offered.publication.mode = ChannelMode::one_to_one;
  EXPECT_EQ(next().first(), Obstacle::protocol);
  offered.publication.protocol = "tcp";
  EXPECT_EQ(next().first(), Obstacle::provider);
  offered.participant_name = "robot9";
  EXPECT_EQ(next().first(), Obstacle::scope);
  asked.subscription.scope = "hsot/a/b";
  EXPECT_EQ(next().first(), Obstacle::unreadable);
  asked.subscription.scope = "any";
  EXPECT_EQ(next().first(), Obstacle::on) << "the participant does not say what it is";
  asked.subscription.on.clear();
  EXPECT_EQ(next().first(), Obstacle::where);
  asked.subscription.where = "rate >";
  EXPECT_EQ(next().first(), Obstacle::unreadable);
  asked.subscription.where.clear();
  EXPECT_EQ(next().first(), Obstacle::for_whom);
  asked.subscription.attributes = {{"rate", "6"}, {"outputs", "word"}};
  EXPECT_EQ(next().first(), Obstacle::signature);
  asked.subscription.attributes = {{"rate", "6"}};
  EXPECT_TRUE(next().meets());
  EXPECT_EQ(next().count(), 0U);
}

TEST(Obstacle, WhatFitsInItsConceptIsNearAndTheLessIsWrongTheNearer) {
  const auto remoteness = [](const Identity& offered, ChannelMode mode = ChannelMode::one_to_one) {
    return found(request(asking, semantic("Ball", "Frame")), offer(offering, offered, 0, mode), soccer()).remoteness();
  };
  const std::vector<Identity> in_order{semantic("Tracked", "Frame"), semantic("Ball", "Robot"), semantic("Ghost"),
                                       semantic("Robot", "Frame"),   semantic("New"),           TextIdentity{"Ball"}};
  for (std::size_t i = 1; i < in_order.size(); ++i) {
    EXPECT_LT(remoteness(in_order[i - 1]), remoteness(in_order[i])) << canonical_form(in_order[i]);
  }
  EXPECT_LT(remoteness(semantic("Ball", "Frame"), ChannelMode::one_to_many_stream), remoteness(in_order[0]));
  EXPECT_LT(remoteness(semantic("Ball", "Robot")), remoteness(in_order[0], ChannelMode::one_to_many_stream))
      << "two things are wrong";
}

/// Random pairs: there is no obstacle exactly where the two meet.
TEST(Obstacle, IsThereExactlyWhereTheTwoDoNotMeet) {
  const std::vector<Identity> identities{
      NumericIdentity{7}, NumericIdentity{8},        TextIdentity{"a"},
      TextIdentity{"b"},  semantic("Ball"),          semantic("OwnBall"),
      semantic("Sphere"), semantic("Ball", "Frame"), semantic("Tracked", "FieldFrame"),
      semantic("Ghost"),  semantic("New"),           semantic("Robot", "New")};
  for (const auto& ontology : {soccer(), vocabulary::Vocabulary()}) {
    for (const Identity& offered : identities) {
      for (const Identity& asked : identities) {
        for (const Degree weakest :
             {Degree::exact, Degree::equivalent, Degree::narrower, Degree::broader, Degree::overlapping}) {
          Matcher matcher(ontology);
          matcher.put(offer(offering, offered));
          const SubscriptionEntry entry = request(asking, asked, 0, weakest);
          const auto prepared = matcher.examination().prepare(entry);
          const auto* stored = matcher.publications().find_entry(offering);
          EXPECT_EQ(matcher.examination().examine(entry, *prepared, *stored).meets(),
                    matcher.examination().meets(entry, *prepared, *stored).has_value())
              << canonical_form(offered) << " for " << canonical_form(asked);
        }
      }
    }
  }
}

}  // namespace
}  // namespace geminga::matching
