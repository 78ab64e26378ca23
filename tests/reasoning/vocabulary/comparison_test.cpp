// Two expressions compared: random ones must relate as the reasoner of all of OWL says.
#include "reasoning/vocabulary/comparison.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "base/random.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::vocabulary {
namespace {

using Relation = Comparison::Relation;

/// One expression in the Manchester syntax and in the functional one.
using Written = std::pair<std::string, std::string>;

/// Random expressions over the names of owl::random_ontology(). `is_beyond`: with unions, complements and universals.
class Writing {
 public:
  Writing(base::Random& random, std::uint64_t classes, bool is_beyond)
      : random_(random), classes_(classes), is_beyond_(is_beyond) {}

  Written write(int depth) {
    if (depth == 0 || random_.chance(0.25)) {
      const std::string name = "C" + std::to_string(random_.below(classes_));
      return {"t:" + name, name};
    }
    const std::uint64_t choice = random_.below(is_beyond_ ? 7 : 4);
    const Written one = write(depth - 1);
    const std::string role = "r" + std::to_string(random_.below(4));
    if (choice < 2) return both(" and ", "ObjectIntersectionOf", one, write(depth - 1));
    if (choice < 4) return {"(t:" + role + " some " + one.first + ")", restricted("Some", role, one)};
    if (choice == 4) return both(" or ", "ObjectUnionOf", one, write(depth - 1));
    if (choice == 5) return {"(not " + one.first + ")", "ObjectComplementOf(" + one.second + ")"};
    return {"(t:" + role + " only " + one.first + ")", restricted("All", role, one)};
  }

 private:
  static Written both(const std::string& word, const std::string& kind, const Written& one, const Written& other) {
    return {"(" + one.first + word + other.first + ")", kind + "(" + one.second + " " + other.second + ")"};
  }
  static std::string restricted(const std::string& kind, const std::string& role, const Written& one) {
    return "Object" + kind + "ValuesFrom(" + role + " " + one.second + ")";
  }

  base::Random& random_;
  std::uint64_t classes_;
  bool is_beyond_;
};

/// All names are declared, so that every expression can be read.
std::string with_all_names(std::string text, std::uint64_t classes) {
  for (std::uint64_t at = 0; at < classes; ++at) text += "Declaration(C" + std::to_string(at) + ")\n";
  for (int at = 0; at < 4; ++at) {
    text += "SubObjectPropertyOf(r" + std::to_string(at) + " r" + std::to_string(at) + ")\n";
  }
  return text;
}

/// How two expressions relate by the reasoner of all of OWL; nothing where it cannot tell.
std::optional<Relation> from_scratch(const std::string& text, const Written& one, const Written& other) {
  owl::Ontology source = owl::written(text);
  const owl::Ontology pair = owl::written("SubClassOf(" + one.second + " " + other.second + ")\n");
  const owl::TermId offered = source.copy(pair, pair.axiom(0).arguments[0]);
  const owl::TermId requested = source.copy(pair, pair.axiom(0).arguments[1]);
  using reasoner::Verdict;
  const Verdict below = reasoner::entails(source, std::nullopt, offered, requested).verdict;
  const Verdict above = reasoner::entails(source, std::nullopt, requested, offered).verdict;
  if (below == Verdict::unknown || above == Verdict::unknown) return std::nullopt;
  if (below == Verdict::yes) return above == Verdict::yes ? Relation::equivalent : Relation::narrower;
  return above == Verdict::yes ? Relation::broader : Relation::apart;
}

/// Whether all that is found follows.
bool is_sound(Relation found, Relation expected) {
  return found == expected || found == Relation::apart ||
         (expected == Relation::equivalent && (found == Relation::narrower || found == Relation::broader));
}

void compare_at_random(std::uint64_t rounds, bool is_beyond) {
  int related = 0;
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    base::Random random(seed);
    const std::uint64_t size = 4 + random.below(14);
    const std::uint64_t classes = size / 2 + 3;
    const std::string text = with_all_names(owl::random_ontology(random, size), classes);
    const compiled::Ontology loaded = owl::loaded(text);
    if (!loaded.is_consistent()) continue;
    const Vocabulary vocabulary = Vocabulary(owl::loaded(text)).with_expressions();
    Writing writing(random, classes, is_beyond);
    for (int turn = 0; turn < 8; ++turn) {
      const Written one = writing.write(2);
      const Written other = random.chance(0.3)
                                ? Written{"(" + one.first + " and t:C0)", "ObjectIntersectionOf(" + one.second + " C0)"}
                                : writing.write(2);
      SCOPED_TRACE("seed " + std::to_string(seed) + " " + one.first + " against " + other.first + "\n" + text);
      const auto read_one = vocabulary.read(one.first, max_expression_bytes);
      const auto read_other = vocabulary.read(other.first, max_expression_bytes);
      ASSERT_TRUE(read_one && read_other);
      const Place place = vocabulary.place(*read_one);
      const Place place_of_other = vocabulary.place(*read_other);
      if (!place.is_satisfiable || !place_of_other.is_satisfiable) continue;
      const Comparison found = vocabulary.compare(*read_one, place, *read_other, place_of_other);
      const auto expected = from_scratch(text, one, other);
      if (!expected) continue;
      const bool is_complete = place.gaps.empty() && place_of_other.gaps.empty() && found.gaps.empty();
      ASSERT_TRUE(is_sound(found.relation, *expected));
      if (is_complete && !is_beyond) {
        ASSERT_EQ(found.relation, *expected);
      }
      // The other way round it is the same.
      const Comparison turned = vocabulary.compare(*read_other, place_of_other, *read_one, place);
      ASSERT_EQ(turned.distance, found.distance);
      ASSERT_EQ(turned.relation == Relation::narrower, found.relation == Relation::broader);
      if (found.relation != Relation::apart) ++related;
    }
  }
  EXPECT_GT(related, static_cast<int>(rounds / 4));
}

TEST(Comparison, OfRandomExpressionsIsWhatTheReasonerOfAllOfOwlSays) { compare_at_random(test::rounds(40U), false); }

TEST(Comparison, BeyondElSaysNothingThatDoesNotFollow) { compare_at_random(test::rounds(40U), true); }

TEST(Comparison, CountsTheEdgesOverTheClassesBetween) {
  const Vocabulary robots =
      Vocabulary(owl::loaded("SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(A ObjectSomeValuesFrom(r D))"
                             "\nSubClassOf(E A)\nSubClassOf(D F)\n"))
          .with_expressions();
  const auto compared = [&](const char* one, const char* other) {
    const auto read = robots.read(one, max_expression_bytes);
    const auto read_other = robots.read(other, max_expression_bytes);
    return robots.compare(*read, robots.place(*read), *read_other, robots.place(*read_other));
  };
  EXPECT_EQ(compared("t:B and (t:r some t:D)", "t:C and (t:r some t:F)").relation, Relation::narrower);
  EXPECT_EQ(compared("t:B and (t:r some t:D)", "t:C and (t:r some t:F)").distance, 1U) << "no class is between";
  EXPECT_EQ(compared("t:E and t:F", "t:r some t:D"), (Comparison{.relation = Relation::narrower, .distance = 3}))
      << "over E and A";
  EXPECT_EQ(compared("t:r some t:D", "t:E and t:F"), (Comparison{.relation = Relation::broader, .distance = 3}));
  EXPECT_EQ(compared("t:F and t:E", "t:E and t:F").relation, Relation::equivalent);
  EXPECT_EQ(compared("t:F and t:E", "t:F and t:C and (t:r some t:E)").relation, Relation::apart);
}

}  // namespace
}  // namespace geminga::vocabulary
