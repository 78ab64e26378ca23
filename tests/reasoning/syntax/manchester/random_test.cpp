// Random ontologies and expressions: the overlay must agree with a classification from scratch of the ontology with a
// class that is equivalent to the expression.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "place.hpp"
#include "reasoning/placement/expression.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::manchester {
namespace {

using taxonomy::ClassNumber;

/// Random expressions in Manchester syntax over the names of el::random_ontology().
class Expressions {
 public:
  Expressions(base::Random& random, std::uint64_t classes) : random_(random), classes_(classes) {}

  /// Constructs beyond EL as well: unions, complements, universal restrictions, numbers, inverses.
  std::string write_any(int depth) {
    const std::string role = "t:r" + std::to_string(random_.below(4));
    switch (depth == 0 ? 12 : random_.below(13)) {
      case 0:
      case 1:
        return "(" + write_any(depth - 1) + " or " + write_any(depth - 1) + ")";
      case 2:
      case 3:
        return "(" + write_any(depth - 1) + " and not " + write_any(depth - 1) + ")";
      case 4:
        return "(not " + write_any(depth - 1) + ")";
      case 5:
        return "(" + role + " only " + write_any(depth - 1) + ")";
      case 6:
        return "(" + role + (random_.chance(0.5) ? " min 2 " : " max 1 ") + write_any(depth - 1) + ")";
      case 7:
        return "(" + role + " max 0 " + write_any(depth - 1) + ")";
      case 8:
        return "(inverse " + role + " some " + write_any(depth - 1) + ")";
      case 9:
        return "(" + write_any(depth - 1) + " and " + write_any(depth - 1) + ")";
      case 10:
        return "(" + role + " some " + write_any(depth - 1) + ")";
      default:
        return write(0);
    }
  }

  std::string write(int depth) {
    const std::uint64_t choice = random_.below(depth == 0 ? 5 : 12);
    if (choice < 5) return random_.chance(0.04) ? "owl:Thing" : "t:C" + std::to_string(random_.below(classes_));
    if (choice < 8) return "(" + write(depth - 1) + " and " + write(depth - 1) + ")";
    if (choice == 8 && random_.chance(0.3)) return "t:r" + std::to_string(random_.below(4)) + " Self";
    return "(t:r" + std::to_string(random_.below(4)) + " some " + write(depth - 1) + ")";
  }

 private:
  base::Random& random_;
  std::uint64_t classes_;
};

/// Names that every random ontology uses, so that every expression can be read.
std::string with_all_names(const std::string& text, std::uint64_t classes) {
  std::string all = text;
  for (std::uint64_t at = 0; at < classes; ++at) all += "Declaration(C" + std::to_string(at) + ")\n";
  for (std::uint64_t at = 0; at < 4; ++at) {
    all += "SubObjectPropertyOf(r" + std::to_string(at) + " r" + std::to_string(at) + ")\n";
  }
  return all;
}

/// The names above and below a class in an ontology, itself left out: `above A`, `below B`.
std::set<std::string> from_scratch(const std::string& text, const Expression& expression) {
  owl::Ontology source = owl::written(text);
  const owl::TermId own = source.named_class("https://t.example/#TheExpression");
  source.add(owl::AxiomKind::equivalent_classes, {own, source.copy(expression.source, expression.term)}, owl::FileId{0},
             0);
  const compiled::Ontology ontology = owl::loaded(source);
  const ClassNumber number = *ontology.find_iri("https://t.example/#TheExpression");
  std::set<std::string> found;
  if (!ontology.is_consistent()) return {"inconsistent"};
  if (!ontology.is_satisfiable(number)) return {"nothing"};
  for (std::uint32_t other = 0; other < ontology.class_count(); ++other) {
    if (ClassNumber{other} == number) continue;
    const std::string iri(ontology.iri(ClassNumber{other}));
    if (ontology.is_subsumed(number, ClassNumber{other})) found.insert("above " + iri);
    if (ontology.is_subsumed(ClassNumber{other}, number)) found.insert("below " + iri);
  }
  return found;
}

std::set<std::string> by_overlay(const Asked& asked, const Expression& expression) {
  const placement::ExpressionPlace place = asked.classifier().classify(expression.source, expression.term);
  if (!place.is_satisfiable) return {"nothing"};
  std::set<std::string> found;
  for (std::uint32_t other = 0; other < asked.ontology().class_count(); ++other) {
    const std::string iri(asked.ontology().iri(ClassNumber{other}));
    if (placement::is_below(place, ClassNumber{other}, asked.ontology())) found.insert("above " + iri);
    if (placement::is_above(place, ClassNumber{other}, asked.ontology())) found.insert("below " + iri);
  }
  return found;
}

TEST(RandomExpressions, StandWhereAClassOfTheirOwnWouldStand) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(120U); ++seed) {
    base::Random random(seed);
    const std::uint64_t size = 4 + random.below(16);
    const std::uint64_t classes = size / 2 + 3;
    const std::string text = with_all_names(owl::random_ontology(random, size), classes);
    if (!owl::loaded(text).is_consistent()) continue;
    const Asked asked(text);
    // Expressions are placed without the universals that ranges of chains need, and say so.
    const owl::Ontology source = owl::written(text);
    const bool is_complete = owl::classified(source).unused.empty() && !owl::has_range_over_chain(source);
    Expressions expressions(random, classes);
    for (int turn = 0; turn < 12; ++turn) {
      const std::string written = expressions.write(3);
      SCOPED_TRACE("seed " + std::to_string(seed) + " " + written + "\n" + text);
      const auto expression = parse(written, asked.names());
      ASSERT_TRUE(expression) << to_string(expression.error());
      const std::set<std::string> found = by_overlay(asked, *expression);
      const std::set<std::string> expected = from_scratch(text, *expression);
      if (is_complete) {
        ASSERT_EQ(found, expected);
        ++compared;
      } else if (expected != std::set<std::string>{"nothing"}) {
        ASSERT_TRUE(std::ranges::includes(expected, found));
      }
      // Both at once as well: what is found for one expression holds of the two.
      ASSERT_EQ(asked.is_subsumed(written, written), "yes");
    }
  }
  EXPECT_GT(compared, test::rounds(500));
}

TEST(RandomExpressions, BeyondElAreWhereTheReasonerOfAllOfOwlPutsThem) {
  int complete = 0;
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(30U); ++seed) {
    base::Random random(seed);
    const std::uint64_t size = 3 + random.below(8);
    const std::uint64_t classes = size / 2 + 3;
    const std::string text = with_all_names(owl::random_ontology(random, size), classes);
    if (!owl::loaded(text).is_consistent() || !owl::classified(owl::written(text)).unused.empty()) continue;
    const Asked asked(text);
    Expressions expressions(random, classes);
    for (int turn = 0; turn < 6; ++turn) {
      const std::string written = expressions.write_any(2);
      SCOPED_TRACE("seed " + std::to_string(seed) + " " + written + "\n" + text);
      const auto expression = parse(written, asked.names());
      ASSERT_TRUE(expression) << to_string(expression.error());
      const placement::ExpressionPlace place = asked.classifier().classify(expression->source, expression->term);
      owl::Ontology source = owl::written(text);
      const owl::TermId term = source.copy(expression->source, expression->term);
      const auto check = [&](owl::TermId sub, owl::TermId super, bool is_found) {
        const reasoner::Answer answer = reasoner::entails(source, std::nullopt, sub, super);
        if (answer.verdict == reasoner::Verdict::unknown) return;
        if (is_found) {
          EXPECT_EQ(answer.verdict, reasoner::Verdict::yes);
        } else if (place.gaps.empty()) {
          EXPECT_EQ(answer.verdict, reasoner::Verdict::no);
          ++refused;
        }
      };
      check(term, owl::nothing_term, !place.is_satisfiable);
      for (std::uint32_t at = 0; at < asked.ontology().class_count() && place.is_satisfiable; ++at) {
        const taxonomy::ClassNumber number{at};
        const owl::TermId name = source.named_class(asked.ontology().iri(number));
        SCOPED_TRACE(asked.ontology().short_name(number));
        check(term, name, placement::is_below(place, number, asked.ontology()));
        check(name, term, placement::is_above(place, number, asked.ontology()));
      }
      if (place.gaps.empty()) ++complete;
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(complete, test::rounds(20));
  EXPECT_GT(refused, test::rounds(100));
}

TEST(RandomWalk, OfQuestionsGivesTheAnswersOfAFreshStart) {
  for (std::uint64_t seed = 1; seed <= test::rounds(10U); ++seed) {
    base::Random random(seed);
    const std::string text = with_all_names(owl::random_ontology(random, 12), 9);
    if (!owl::loaded(text).is_consistent()) continue;
    const Asked asked(text);
    Expressions expressions(random, 9);
    std::vector<std::string> known;
    for (int turn = 0; turn < 40; ++turn) {
      const bool is_new = known.empty() || random.chance(0.5);
      if (is_new) known.push_back(random.chance(0.5) ? expressions.write(3) : expressions.write_any(2));
      const std::string& written = known[random.below(known.size())];
      ASSERT_EQ(asked.place_of(written), Asked(text).place_of(written)) << "seed " << seed << " " << written;
    }
  }
}

}  // namespace
}  // namespace geminga::manchester
