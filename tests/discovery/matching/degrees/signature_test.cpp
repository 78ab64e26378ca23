// The effect of inputs and outputs on a match, by a table of pairs.
#include "discovery/matching/degrees/signature.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "discovery/matching/meeting/explained.hpp"
#include "discovery/matching/taxonomy.hpp"

namespace geminga::matching {
namespace {

using enum Degree;

std::string word(std::string_view name) { return "<" + iri(name) + ">"; }

struct Stated {
  std::optional<std::string> inputs;
  std::optional<std::string> outputs;

  [[nodiscard]] Attributes attributes() const {
    Attributes all;
    if (inputs) all.emplace(inputs_attribute, *inputs);
    if (outputs) all.emplace(outputs_attribute, *outputs);
    return all;
  }
};

struct Case {
  Stated offered;
  Stated asked;
  Degree weakest = narrower;
  std::optional<Match> wanted;
};

TEST(Signature, TakesOutputsCovariantAndInputsContravariant) {
  const auto ontology = soccer();
  const std::vector<Case> cases{
      // Outputs: an offered one must be of the kind of the requested one.
      {{{}, word("Ball")}, {{}, word("Ball")}, narrower, Match{exact, 0}},
      {{{}, word("OwnBall")}, {{}, word("Ball")}, narrower, Match{narrower, 1}},
      {{{}, word("Tracked")}, {{}, word("Ball")}, narrower, {}},
      {{{}, word("Tracked")}, {{}, word("Ball")}, broader, Match{broader, 1}},
      {{{}, word("OwnBall")}, {{}, word("Ball")}, equivalent, {}},
      {{{}, word("Sphere")}, {{}, word("Ball")}, equivalent, Match{equivalent, 0}},
      {{{}, word("Sphere")}, {{}, word("Ball")}, exact, {}},
      // Inputs: a given one must be of the kind of the needed one.
      {{word("Tracked"), {}}, {word("Ball"), {}}, narrower, Match{narrower, 1}},
      {{word("OwnBall"), {}}, {word("Ball"), {}}, narrower, {}},
      {{word("OwnBall"), {}}, {word("Ball"), {}}, broader, Match{broader, 1}},
      // All of them count, in any order: the weakest degree, and the sum of the distances.
      {{word("Tracked") + ' ' + word("Frame"), word("OwnBall")},
       {"  " + word("FieldFrame") + "  " + word("Ball") + ' ', word("Tracked")},
       narrower,
       Match{narrower, 4}},
      {{{}, word("Ball")}, {{}, word("Ball") + ' ' + word("Robot")}, broader, {}},
      {{word("Ball") + ' ' + word("Robot"), {}}, {word("Ball"), {}}, broader, {}},
      // The best parameter counts, and one that nobody asked for does not.
      {{{}, word("OwnBall") + ' ' + word("Ball") + ' ' + word("Robot")}, {{}, word("Ball")}, broader, Match{exact, 0}},
      {{{}, word("Ball")}, {word("Robot"), word("Ball")}, narrower, Match{exact, 0}},
      // A request that states no inputs is not compared by them; one that states an empty list is.
      {{word("Ball"), word("Ball")}, {{}, word("Ball")}, narrower, Match{exact, 0}},
      {{word("Ball"), word("Ball")}, {"", word("Ball")}, broader, {}},
      {{{}, {}}, {{}, word("Ball")}, broader, {}},
      // An unknown or unsatisfiable name matches only itself.
      {{{}, "pixels"}, {{}, "pixels"}, narrower, Match{exact, 0}},
      {{{}, "pixels"}, {{}, word("Ball")}, broader, {}},
      {{{}, word("Ghost")}, {{}, word("Ball")}, broader, {}},
      {{{}, word("Ghost")}, {{}, word("Ghost")}, narrower, Match{exact, 0}},
      {{{}, iri("Ball")}, {{}, word("Ball")}, narrower, Match{exact, 0}},
      // Blanks and commas stand between names; between angle brackets they belong to the name.
      {{{}, word("OwnBall") + ',' + word("Robot")},
       {{}, word("Robot") + ",\t" + word("Ball") + ","},
       narrower,
       Match{narrower, 1}},
      {{{}, "<a,b>,c"}, {{}, "c <a,b>"}, narrower, Match{exact, 0}},
      {{{}, "<a,b>"}, {{}, "b>"}, broader, {}},
  };
  for (std::size_t at = 0; at < cases.size(); ++at) {
    const auto& [offered, asked, weakest, wanted] = cases[at];
    const Signature offer = signature_of(offered.attributes(), ontology);
    const Signature request = signature_of(asked.attributes(), ontology);
    EXPECT_EQ(degree_of_signature(offer, request, weakest, ontology), wanted) << "case " << at;
    EXPECT_EQ(signature_misfit(offer, request, weakest, ontology).empty(), wanted.has_value()) << "case " << at;
  }
}

TEST(Signature, ComparesTextsWhereThereIsNoOntology) {
  const vocabulary::Vocabulary none;
  const Stated ball{word("Ball"), "a b"};
  const Signature same = signature_of(ball.attributes(), none);
  EXPECT_EQ(degree_of_signature(same, same, narrower, none), (Match{exact, 0}));
  EXPECT_FALSE(degree_of_signature(same, signature_of(Stated{{}, "c"}.attributes(), none), broader, none));
}

TEST(Signature, WeakensTheMatchOfAPairAndIsExplained) {
  const auto ontology = soccer();
  registry::SubscriptionEntry entry;
  Subscription& asked = entry.subscription;
  asked.identity = semantic("Ball");
  asked.attributes = Stated{word("Ball"), word("Frame")}.attributes();
  registry::PublicationEntry offer;
  offer.publication.identity = semantic("OwnBall");
  const auto explain = [&] {
    return explained(entry, prepared(asked, ontology), Imagined(offer, ontology).offer, ontology);
  };
  offer.publication.attributes = Stated{word("Tracked"), word("FieldFrame")}.attributes();
  ASSERT_TRUE(explain());
  EXPECT_EQ(*explain(), (Match{narrower, 3}));
  offer.publication.attributes = Stated{word("Robot"), {}}.attributes();
  ASSERT_FALSE(explain());
  EXPECT_EQ(explain().error(),
            "signature: output :Frame is asked for and not offered, input :Robot is needed and not given");
  asked.attributes.clear();
  EXPECT_TRUE(explain());
}

}  // namespace
}  // namespace geminga::matching
