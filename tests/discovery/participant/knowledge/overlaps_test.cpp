// How many questions to the reasoner are decided, and when those that wait may be asked again.
#include "discovery/participant/knowledge/overlaps.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::participant {
namespace {

using vocabulary::ClassNumber;

/// So many classes that nothing relates.
vocabulary::Vocabulary flat(std::uint32_t count, const std::string& space = "http://example.org/") {
  owl::Ontology source;
  const owl::FileId file = source.add_file("flat.ttl", space);
  for (std::uint32_t at = 0; at < count; ++at) {
    source.add(owl::AxiomKind::sub_class_of,
               {source.named_class(space + "C" + std::to_string(at)), source.named_class(owl::owl_thing)}, file,
               at + 1);
  }
  const auto classification = el::classify(source);
  return vocabulary::Vocabulary(
      std::move(compiled::Ontology::from_bytes(compiled::compile(source, classification.value()))).value());
}

class OverlapsTest : public testing::Test {
 protected:
  /// Whether an offer of the class with this number gets an answer.
  bool asks(std::uint32_t offered, const std::string& requested = "C0",
            std::optional<ParticipantId> from = std::nullopt) {
    return ask(offered, requested, from) != nullptr;
  }
  matching::OverlapAnswer ask(std::uint32_t offered, const std::string& requested, std::optional<ParticipantId> from) {
    const SemanticIdentity identity{"http://example.org/" + requested, ""};
    matching::Classes classes;
    classes.concept_class = ontology.find_iri(identity.concept_iri);
    const SemanticIdentity offer{"http://example.org/C" + std::to_string(offered), ""};
    const matching::Classes of_offer{.concept_class = ontology.find_iri(offer.concept_iri),
                                     .representation_class = std::nullopt};
    return overlaps.answer(ontology, {offer, of_offer}, {identity, classes}, from, now);
  }

  vocabulary::Vocabulary ontology = flat(400);
  Overlaps overlaps;
  base::Instant now{std::chrono::seconds(10)};
};

TEST_F(OverlapsTest, DecidesAFewInAStepAndRemembersThem) {
  for (std::uint32_t at = 1; at <= max_overlaps_in_step; ++at) EXPECT_TRUE(asks(at));
  EXPECT_FALSE(overlaps.take_waiting(now));
  EXPECT_FALSE(asks(100));
  EXPECT_TRUE(asks(1)) << "it is known";
  EXPECT_TRUE(overlaps.take_waiting(now));
  EXPECT_FALSE(overlaps.take_waiting(now)) << "once";
  overlaps.begin_step();
  EXPECT_TRUE(asks(100));
  EXPECT_EQ(overlaps.counts().decided, max_overlaps_in_step + 1);
  EXPECT_EQ(overlaps.counts().postponed, 1U);
  EXPECT_EQ(overlaps.counts().undecided, 0U);
}

TEST_F(OverlapsTest, DecidesSoManyForOneParticipantInASecond) {
  const ParticipantId other{7};
  std::uint32_t decided = 0;
  for (std::uint32_t at = 1; at <= max_overlaps_of_participant + 1; ++at) {
    overlaps.begin_step();
    decided += asks(at, "C0", other) ? 1 : 0;
  }
  EXPECT_EQ(decided, max_overlaps_of_participant);
  EXPECT_TRUE(asks(200, "C0", ParticipantId{8})) << "others are not held up";
  EXPECT_TRUE(asks(201)) << "neither are our own";
  EXPECT_FALSE(overlaps.take_waiting(now + RemoteQuota::second - base::Duration(1)));
  EXPECT_TRUE(overlaps.take_waiting(now + RemoteQuota::second));
  now += RemoteQuota::second;
  EXPECT_TRUE(asks(static_cast<std::uint32_t>(max_overlaps_of_participant + 1), "C0", other));
}

TEST_F(OverlapsTest, DecidesSoManyFromTheAirInASecond) {
  std::size_t decided = 0;
  for (std::uint32_t at = 0; at <= max_overlaps_from_air; ++at) {
    overlaps.begin_step();
    decided += asks(1 + at % 300, "C0", ParticipantId{100 + at / 8}) ? 1 : 0;
  }
  EXPECT_EQ(decided, max_overlaps_from_air);
}

TEST_F(OverlapsTest, RemembersTwoOntologiesAndNoMore) {
  EXPECT_TRUE(asks(1));
  const auto first = ontology;
  ontology = flat(3);
  EXPECT_TRUE(asks(1));
  ontology = first;
  EXPECT_TRUE(asks(1));
  EXPECT_EQ(overlaps.counts().decided, 2U);
  ontology = flat(4);
  EXPECT_TRUE(asks(1));
  EXPECT_EQ(overlaps.counts().decided, 3U);
}

TEST(Overlaps, AreLimitedForOneRequestAndInAll) {
  const auto most = static_cast<std::uint32_t>(max_overlaps_of_request);
  const auto ontology = flat(most + 2);
  Overlaps overlaps;
  const base::Instant now{};
  const auto answer = [&](std::uint32_t offered, const std::string& requested) {
    const SemanticIdentity identity{"http://example.org/C" + requested, ""};
    matching::Classes classes;
    classes.concept_class = ontology.find_iri(identity.concept_iri);
    overlaps.begin_step();
    const matching::Classes of_offer{.concept_class = ClassNumber{offered}, .representation_class = std::nullopt};
    return overlaps.answer(ontology, {SemanticIdentity(), of_offer}, {identity, classes}, std::nullopt, now);
  };
  using enum vocabulary::Overlap::Verdict;
  for (std::uint32_t at = 0; at < most; ++at) ASSERT_EQ(answer(at, "0")->verdict, possible) << at;
  EXPECT_EQ(answer(most, "0")->verdict, undecided);
  EXPECT_NE(answer(most, "0")->reason.find("8192"), std::string::npos);
  EXPECT_EQ(answer(0, "0")->verdict, possible);
  // Others fill the rest; then the eldest request is forgotten as a whole.
  for (std::size_t others = 1; others < max_remembered_overlaps / max_overlaps_of_request; ++others) {
    for (std::uint32_t at = 0; at < most; ++at) static_cast<void>(answer(at, std::to_string(others)));
  }
  const auto decided = overlaps.counts().decided;
  EXPECT_EQ(decided, max_remembered_overlaps);
  static_cast<void>(answer(1, "1"));
  EXPECT_EQ(overlaps.counts().decided, decided) << "all are known";
  static_cast<void>(answer(1, "5"));
  static_cast<void>(answer(1, "2"));
  static_cast<void>(answer(1, "1"));
  EXPECT_EQ(overlaps.counts().decided, decided + 1);
  static_cast<void>(answer(1, "0"));
  EXPECT_EQ(overlaps.counts().decided, decided + 2) << "forgotten";
}

}  // namespace
}  // namespace geminga::participant
