// A site says how much it offers to those who ask, and again when that changes.
#include "discovery/summary/offerings.hpp"

#include <gtest/gtest.h>

#include "discovery/summary/limits.hpp"
#include "sim/small_ontology.hpp"

namespace geminga::summary {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::seconds;

base::Instant at(base::Duration time) { return base::Instant(hours(1) + time); }

Identity of(const std::string& name) { return SemanticIdentity{"https://geminga.example/soccer#" + name, {}}; }

/// A site with the small ontology of a soccer team.
struct Site {
  vocabulary::Vocabulary vocabulary = sim::small_ontology("soccer");
  Offerings offerings{SiteId{1}, vocabulary};
  base::Random random{3};

  [[nodiscard]] Topic rank(const std::string& iri) const {
    return {.digest = vocabulary.digest(), .rank = std::to_underlying(*vocabulary.find_iri(iri))};
  }
  void ask(const Topic& topic, std::uint64_t digest, base::Instant now) {
    offerings.hear({.kind = Kind::question, .site = SiteId{9}, .topic = topic, .digest = digest}, now, random);
  }
  /// The magnitudes that are said until then.
  std::vector<unsigned> said(base::Instant until) {
    std::vector<unsigned> magnitudes;
    for (const Message& one : offerings.take_answers(until)) magnitudes.push_back(one.magnitude);
    return magnitudes;
  }
};

using Magnitudes = std::vector<unsigned>;

/// A class of the small ontology with one above it, by their IRIs.
std::pair<std::string, std::string> class_and_superclass(const vocabulary::Vocabulary& vocabulary) {
  for (std::uint32_t number = 0; number < vocabulary.class_count(); ++number) {
    const vocabulary::ClassNumber one{number};
    if (!vocabulary.is_satisfiable(one)) continue;
    for (const auto above : vocabulary.subsumers(one)) {
      if (above != one && above != vocabulary.thing() && !vocabulary.is_subsumed(above, one))
        return {std::string(vocabulary.iri(one)), std::string(vocabulary.iri(above))};
    }
  }
  return {};
}

TEST(Offerings, CountServicesUnderEverySuperclassOfTheirConcept) {
  Site site;
  const auto [narrow, wide] = class_and_superclass(site.vocabulary);
  ASSERT_FALSE(narrow.empty());
  site.offerings.add(SemanticIdentity{narrow, {}}, at(seconds(0)));
  site.offerings.add(SemanticIdentity{wide, {}}, at(seconds(0)));
  EXPECT_EQ(site.offerings.count(site.rank(narrow)), 1U);
  EXPECT_EQ(site.offerings.count(site.rank(wide)), 2U);
  EXPECT_EQ(site.offerings.count({.digest = 0, .rank = 0, .iri = wide}), 2U);
  EXPECT_EQ(site.offerings.count({.digest = 12345, .rank = 1}), 0U) << "a number of another ontology";
  site.offerings.remove(SemanticIdentity{narrow, {}}, at(seconds(0)));
  EXPECT_EQ(site.offerings.count(site.rank(narrow)), 0U);
  EXPECT_EQ(site.offerings.count(site.rank(wide)), 1U);
}

TEST(Offerings, SayNothingOfWhatNobodyAskedForAndAnswerWithinTheSpread) {
  Site site;
  const auto [narrow, wide] = class_and_superclass(site.vocabulary);
  for (int i = 0; i < 5; ++i) site.offerings.add(SemanticIdentity{narrow, {}}, at(seconds(0)));
  EXPECT_EQ(site.offerings.next_due(), base::never);
  site.ask(site.rank(wide), site.vocabulary.digest(), at(seconds(1)));
  EXPECT_GE(site.offerings.next_due(), at(seconds(1)));
  EXPECT_LE(site.offerings.next_due(), at(seconds(1)) + answer_spread);
  EXPECT_EQ(site.said(at(seconds(1)) + answer_spread), Magnitudes{3});
  EXPECT_EQ(site.offerings.next_due(), base::never);
}

TEST(Offerings, SayAChangeOfMagnitudeToThoseWhoAskedWithinTheLastHour) {
  Site site;
  const auto [narrow, wide] = class_and_superclass(site.vocabulary);
  site.ask(site.rank(wide), site.vocabulary.digest(), at(seconds(0)));
  EXPECT_EQ(site.offerings.next_due(), base::never) << "nothing is offered";
  site.offerings.add(SemanticIdentity{narrow, {}}, at(seconds(5)));
  EXPECT_EQ(site.said(at(seconds(5))), Magnitudes{1});
  site.offerings.add(SemanticIdentity{narrow, {}}, at(seconds(6)));
  EXPECT_EQ(site.said(at(seconds(5)) + change_spacing - milliseconds(1)), Magnitudes{}) << "too soon";
  EXPECT_EQ(site.said(at(seconds(5)) + change_spacing), Magnitudes{2});
  site.offerings.remove(SemanticIdentity{narrow, {}}, at(seconds(30)));
  EXPECT_EQ(site.said(at(seconds(60))), Magnitudes{}) << "one less may be more again";
  site.offerings.remove(SemanticIdentity{narrow, {}}, at(seconds(61)));
  EXPECT_EQ(site.said(at(seconds(61))), Magnitudes{0}) << "none any more";
  site.offerings.add(SemanticIdentity{narrow, {}}, at(asked_for));
  EXPECT_EQ(site.said(at(asked_for + seconds(60))), Magnitudes{}) << "nobody has asked for an hour";
}

TEST(Offerings, AnswerByRankWhereTheOntologyIsTheSameAndByIriOtherwise) {
  Site site;
  const auto [narrow, wide] = class_and_superclass(site.vocabulary);
  site.offerings.add(SemanticIdentity{narrow, {}}, at(seconds(0)));
  const Topic iri{.digest = 0, .rank = 0, .iri = wide};
  site.ask(iri, site.vocabulary.digest(), at(seconds(1)));
  EXPECT_EQ(site.said(at(seconds(9))), Magnitudes{}) << "it asks for the rank, too";
  site.ask(iri, 777, at(seconds(10)));
  EXPECT_EQ(site.said(at(seconds(19))), Magnitudes{1});
  site.ask({.digest = 777, .rank = 1}, 777, at(seconds(20)));
  EXPECT_EQ(site.said(at(seconds(29))), Magnitudes{}) << "a rank in another ontology";
  site.offerings.add(of("NotInThisOntology"), at(seconds(30)));
  site.ask({.digest = 0, .rank = 0, .iri = std::get<SemanticIdentity>(of("NotInThisOntology")).concept_iri},
           site.vocabulary.digest(), at(seconds(31)));
  EXPECT_EQ(site.said(at(seconds(40))), Magnitudes{1}) << "a concept that is no class here has no rank";
  site.offerings.add(TextIdentity{"text"}, at(seconds(41)));
  site.offerings.add(NumericIdentity{4}, at(seconds(41)));
  EXPECT_EQ(site.offerings.next_due(), base::never);
}

TEST(Offerings, RememberSoManyTopicsAndNoMore) {
  Offerings offerings(SiteId{1}, {});
  base::Random random(1);
  const auto ask = [&](std::size_t number, base::Instant now) {
    offerings.hear({.kind = Kind::question,
                    .site = SiteId{9},
                    .topic = {.digest = 0, .rank = 0, .iri = "x" + std::to_string(number)}},
                   now, random);
  };
  for (std::size_t i = 0; i < max_asked; ++i) ask(i, at(seconds(0)));
  EXPECT_EQ(offerings.refused(), 0U);
  ask(max_asked, at(seconds(1)));
  EXPECT_EQ(offerings.refused(), 1U);
  ask(0, at(seconds(2)));
  EXPECT_EQ(offerings.refused(), 1U) << "one that is known";
  ask(max_asked, at(asked_for));
  EXPECT_EQ(offerings.refused(), 1U) << "the others have run out";
  EXPECT_EQ(offerings.asked(), 2U);
}

}  // namespace
}  // namespace geminga::summary
