// Overlapping concepts: neither is above the other, and something can be both.
#include "discovery/matching/degrees/overlap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using registry::SubscriptionEntry;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto overlapping = Degree::overlapping;

/// Balls are no robots; a moving thing may be either.
vocabulary::Vocabulary movers(bool is_whole = true) {
  return soccer([is_whole](Taxonomy& taxonomy) {
    taxonomy.sub("Moving", "Tracked").disjoint("Ball", "Robot");
    if (!is_whole) taxonomy.leave_out("owl:imports");
  });
}

struct Case {
  Identity offered;
  Identity asked;
  std::string wanted;  ///< the event of a request for overlapping concepts; empty: none
  std::string code;    ///< the code of the obstacle; empty: none
};

TEST(Overlap, MeetsWhatCanBeBothAndNothingElse) {
  const std::vector<Case> cases{
      {semantic("Moving"), semantic("Ball"), "overlapping 2", ""},
      {semantic("Moving"), semantic("OwnBall"), "overlapping 3", ""},
      {semantic("OwnBall"), semantic("Moving"), "overlapping 3", ""},
      {semantic("Robot"), semantic("Moving"), "overlapping 2", ""},
      {semantic("Robot"), semantic("OwnBall"), "", "disjoint"},
      {semantic("Sphere"), semantic("Robot"), "", "disjoint"},
      {semantic("Tracked"), semantic("OwnBall"), "broader 2", ""},
      {semantic("OwnBall"), semantic("Ball"), "narrower 1", ""},
      // Unknown and unsatisfiable concepts overlap with nothing.
      {semantic("New"), semantic("Ball"), "", "unknown_offer"},
      {semantic("Ball"), semantic("New"), "", "unknown_concept"},
      {semantic("Phantom"), semantic("Moving"), "", "unsatisfiable"},
      // Representations never overlap.
      {semantic("Moving", "FieldFrame"), semantic("Ball", "Frame"), "overlapping 3", ""},
      {semantic("Moving", "Frame"), semantic("Ball", "FieldFrame"), "overlapping 3", ""},
      {semantic("Moving", "Robot"), semantic("Ball", "Frame"), "", "representation"},
      {semantic("Moving"), semantic("Ball", "Frame"), "", "representation_unstated"},
      {NumericIdentity{7}, semantic("Ball"), "", "kind"},
  };
  const auto ontology = movers();
  for (const Case& one : cases) {
    for (const bool offer_comes_first : {true, false}) {
      Matcher matcher(ontology);
      if (offer_comes_first) matcher.put(offer(key(2, 1, 7), one.offered));
      matcher.put(request(key(here, 1, 1), one.asked, 0, overlapping));
      matcher.put(request(key(here, 1, 2), one.asked, 0, Degree::broader));
      if (!offer_comes_first) matcher.put(offer(key(2, 1, 7), one.offered));
      const std::string what = canonical_form(one.offered) + " for " + canonical_form(one.asked);
      std::vector<std::string> wanted;
      if (!one.wanted.empty()) wanted.push_back("p1.1.1 pub add p2.1.7 " + one.wanted);
      if (!one.wanted.empty() && !one.wanted.starts_with("overlapping"))
        wanted.push_back("p1.1.2 pub add p2.1.7 " + one.wanted);
      EXPECT_EQ(told(matcher), wanted) << what;
      const SubscriptionEntry asked = request(key(here, 1, 1), one.asked, 0, overlapping);
      const auto finding = matcher.examination().examine(asked, *matcher.examination().prepare(asked),
                                                         *matcher.publications().find_entry(key(2, 1, 7)));
      EXPECT_EQ(to_string(finding.first()), one.code.empty() ? "none" : one.code) << what;
    }
  }
}

TEST(Overlap, RanksBehindAllOthers) {
  Matcher matcher(movers());
  matcher.put(request(key(here, 1, 1), semantic("Ball"), 1, overlapping));
  matcher.put(offer(key(2, 1, 1), semantic("Moving")));
  matcher.put(offer(key(2, 1, 2), semantic("Tracked")));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 overlapping 2", "p1.1.1 pub add p2.1.2 broader 1",
                                         "p1.1.1 pub del p2.1.1 outranked"));
}

TEST(Overlap, IsRefusedWhereTheReasonerCannotTell) {
  Matcher matcher(movers(false));
  matcher.put(offer(key(2, 1, 1), semantic("Moving")));
  const SubscriptionEntry asked = request(key(here, 1, 1), semantic("Ball"), 0, overlapping);
  matcher.put(asked);
  EXPECT_THAT(told(matcher), IsEmpty());
  const auto* offered = matcher.publications().find_entry(key(2, 1, 1));
  EXPECT_EQ(matcher.examination().examine(asked, *matcher.examination().prepare(asked), *offered).first(),
            Obstacle::undecided);
  EXPECT_THAT(matcher.examination().why(asked, *offered).error(),
              HasSubstr("undecided whether something can be both: axioms were"));
}

TEST(Overlap, FollowsTheOntology) {
  Matcher matcher(movers());
  matcher.put(offer(key(2, 1, 1), semantic("Moving")));
  matcher.put(request(key(here, 1, 1), semantic("Ball"), 0, overlapping));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 overlapping 2"));
  const auto change_to = [&](vocabulary::Vocabulary next) {
    matcher.vocabulary_change().begin(std::move(next));
    while (matcher.vocabulary_change().file_next()) {
    }
    matcher.vocabulary_change().put_in_force();
    while (matcher.vocabulary_change().rematch_next()) {
    }
    return told(matcher);
  };
  EXPECT_THAT(change_to(soccer([](Taxonomy& other) { other.sub("Moving", "Robot").disjoint("Ball", "Robot"); })),
              ElementsAre("p1.1.1 pub del p2.1.1 changed"));
  EXPECT_THAT(change_to(soccer([](Taxonomy& other) { other.sub("Moving", "Ball"); })),
              ElementsAre("p1.1.1 pub add p2.1.1 narrower 1"));
  EXPECT_THAT(change_to(movers()), ElementsAre("p1.1.1 pub modify p2.1.1 overlapping 2"));
  EXPECT_THAT(change_to({}), ElementsAre("p1.1.1 pub del p2.1.1 changed"));
}

/// Answers about overlaps, of which one comes in each step.
TEST(Overlap, WaitsForTheReasonerAndLosesNothingMeanwhile) {
  std::set<std::pair<std::uint64_t, std::string>> known;
  bool may_ask = true;
  Matcher matcher(movers(), {},
                  [&](const vocabulary::Vocabulary& by, const Meaning& offered, const Meaning& requested,
                      ParticipantId) -> OverlapAnswer {
                    const auto question = std::pair(by.digest(), offered.identity.concept_iri);
                    if (!known.contains(question) && !std::exchange(may_ask, false)) return nullptr;
                    known.insert(question);
                    return decided_at_once(by, offered, requested);
                  });
  const auto finish = [&] {
    matcher.vocabulary_change().place_again();
    for (int step = 0; step < 50 && matcher.vocabulary_change().rematch_next(); ++step) may_ask = true;
    EXPECT_FALSE(matcher.vocabulary_change().rematch_next());
    return told(matcher);
  };
  for (const char* name : {"Moving", "Robot", "Sphere", "Frame"}) {
    matcher.put(offer(key(2, 1, static_cast<std::uint32_t>(name[0])), semantic(name)));
  }
  matcher.put(request(key(here, 1, 1), semantic("OwnBall"), 0, overlapping));
  const auto at_once = told(matcher);
  EXPECT_EQ(at_once.size(), 2U) << "what needs no answer, and one that there was";
  const auto later = finish();
  EXPECT_EQ(at_once.size() + later.size(), 3U) << "Moving, Frame, and Sphere, which is broader";
  EXPECT_THAT(later, testing::Each(HasSubstr("pub add")));

  // Another ontology, without answers at first: nothing is lost and regained.
  may_ask = true;
  matcher.vocabulary_change().begin(soccer(
      [](Taxonomy& other) { other.sub("Moving", "Tracked").disjoint("Ball", "Robot").sub("Unheard", "Tracked"); }));
  while (matcher.vocabulary_change().file_next()) {
  }
  matcher.vocabulary_change().put_in_force();
  EXPECT_THAT(finish(), IsEmpty());
  EXPECT_EQ(matcher.choices().chosen(key(here, 1, 1)).size(), 3U);
}

}  // namespace
}  // namespace geminga::matching
