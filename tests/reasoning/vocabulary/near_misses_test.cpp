// Near misses: each way is sound and smallest, by the reasoner of all of OWL; and what users are told.
#include "reasoning/explanation/abduction/near_misses.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga {
namespace {

using abduction::Answer;
using abduction::Conjuncts;
using abduction::Members;
using abduction::numbers_of;
using abduction::only;
using owl::TermId;
using owl::TermKind;

Answer answer(reasoner::Verdict verdict) {
  if (verdict == reasoner::Verdict::unknown) return Answer::unknown;
  return verdict == reasoner::Verdict::yes ? Answer::yes : Answer::no;
}

abduction::Reasoner exact_reasoner() {
  abduction::Reasoner exact;
  exact.is_subsumed = [](const owl::Ontology& source, TermId sub, TermId super) {
    return answer(reasoner::entails(source, std::nullopt, sub, super).verdict);
  };
  exact.is_satisfiable = [](const owl::Ontology& source, TermId expression) {
    const Answer is_empty = answer(reasoner::entails(source, std::nullopt, expression, owl::nothing_term).verdict);
    if (is_empty == Answer::unknown) return Answer::unknown;
    return is_empty == Answer::yes ? Answer::no : Answer::yes;
  };
  return exact;
}

/// The class expression of a text in functional-style syntax, as a term of the source.
TermId expression(owl::Ontology& source, const std::string& text) {
  const owl::Ontology one = owl::written("SubClassOf(" + text + " Thing)\n");
  return source.copy(one, one.axiom(0).arguments[0]);
}

TermId both(owl::Ontology& source, TermId one, TermId other) {
  return one == other ? one : source.term(TermKind::object_intersection_of, {one, other});
}

/// Random requests with nested conjuncts over C0 to C(n-1), r0 to r3.
class Asking {
 public:
  Asking(base::Random& random, std::uint64_t classes) : random_(random), classes_(classes) {}

  std::string conjunction(int depth) {
    const std::uint64_t count = 2 + random_.below(2);
    std::string text = "ObjectIntersectionOf(";
    for (std::uint64_t at = 0; at < count; ++at) text += (at == 0 ? "" : " ") + conjunct(depth);
    return text + ")";
  }

 private:
  std::string conjunct(int depth) {
    const std::uint64_t choice = random_.below(10);
    const std::string role = "r" + std::to_string(random_.below(4));
    if (choice < 3 && depth > 0) return "ObjectSomeValuesFrom(" + role + " " + conjunction(depth - 1) + ")";
    if (choice == 3) return "ObjectSomeValuesFrom(" + role + " " + name() + ")";
    if (choice == 4) return "ObjectAllValuesFrom(" + role + " " + name() + ")";
    if (choice == 5) return "ObjectComplementOf(" + name() + ")";
    return name();
  }
  std::string name() { return "C" + std::to_string(random_.below(classes_)); }

  base::Random& random_;
  std::uint64_t classes_;
};

/// Checks one way by its definition (near_misses.hpp), and minimality by taking each member away.
void check(owl::Ontology& source, const Conjuncts& request, TermId candidate, const abduction::NearMiss& found) {
  const abduction::Reasoner exact = exact_reasoner();
  const Members left = request.all() & ~found.retracted;
  const TermId goal = request.term(source, left);
  ASSERT_TRUE(found.is_possible);
  ASSERT_EQ(found.known & found.lacking, 0U);
  ASSERT_EQ((found.known | found.lacking) & ~left, 0U);
  ASSERT_EQ(exact.is_subsumed(source, candidate, request.term(source, found.known)), Answer::yes);
  const TermId more = both(source, candidate, abduction::added(source, request, found));
  ASSERT_EQ(exact.is_subsumed(source, more, goal), Answer::yes) << "added and retracted, it matches";
  ASSERT_EQ(exact.is_satisfiable(source, both(source, more, goal)), Answer::yes);
  for (const std::size_t one : numbers_of(found.lacking)) {
    if (!std::has_single_bit(request.inside(one) & found.lacking)) continue;  // one within goes first
    abduction::NearMiss less = found;
    less.lacking &= ~only(one);
    const TermId too_little = both(source, candidate, request.term(source, less.known | less.lacking));
    ASSERT_EQ(exact.is_subsumed(source, too_little, goal), Answer::no) << "not needed: " << one;
  }
  for (const std::size_t one : numbers_of(request.outermost(found.retracted))) {
    const TermId too_much = both(source, candidate, request.term(source, left | only(one)));
    ASSERT_EQ(exact.is_satisfiable(source, too_much), Answer::no) << "need not be retracted: " << one;
  }
}

TEST(NearMisses, AreSoundAndMinimalByTheReasonerOfAllOfOwl) {
  std::size_t lacking = 0;
  std::size_t contradicting = 0;
  const std::uint64_t rounds = test::rounds(60U);
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    base::Random random(seed);
    const std::uint64_t size = 4 + random.below(10);
    const std::uint64_t classes = size / 2 + 3;
    std::string text = owl::random_ontology(random, size);
    for (std::uint64_t at = 0; at + 1 < classes; at += 2) {
      text += "DisjointClasses(C" + std::to_string(at) + " C" + std::to_string(at + 1) + ")\n";
    }
    owl::Ontology source = owl::written(text);
    if (reasoner::is_consistent(source).verdict != reasoner::Verdict::yes) continue;
    Asking asking(random, classes);
    const std::string asked = asking.conjunction(2);
    const std::string offered = asking.conjunction(1);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + asked + "\nagainst " + offered + "\n" + text);
    const Conjuncts request(source, expression(source, asked), {});
    const TermId candidate = expression(source, offered);
    const auto found = abduction::find_near_misses(source, request, candidate, exact_reasoner());
    for (const auto& one : found.ranked) {
      lacking += static_cast<std::size_t>(std::popcount(one.lacking));
      contradicting += static_cast<std::size_t>(std::popcount(one.retracted));
      if (found.reservation.empty()) {
        ASSERT_NO_FATAL_FAILURE(check(source, request, candidate, one));
      }
    }
    const bool is_empty = exact_reasoner().is_satisfiable(source, candidate) == Answer::no;
    ASSERT_EQ(found.ranked.empty(), is_empty);
  }
  EXPECT_GT(lacking, rounds / 2);
  EXPECT_GT(contradicting, rounds / 8);
}

TEST(NearMisses, TellApartNoMoreThanSixtyFourConjuncts) {
  for (const std::size_t count :
       {abduction::max_conjuncts - 1, abduction::max_conjuncts, abduction::max_conjuncts + 1}) {
    std::string text = "ObjectIntersectionOf(";
    for (std::size_t at = 0; at < count; ++at) text += " C" + std::to_string(at);
    owl::Ontology source = owl::written("SubClassOf(A B)\n");
    const TermId whole = expression(source, text + ")");
    const Conjuncts request(source, whole, {});
    EXPECT_EQ(request.size(), std::min(count, abduction::max_conjuncts));
    EXPECT_EQ(request.is_whole(), count <= abduction::max_conjuncts);
    const auto found = abduction::find_near_misses(source, request, owl::thing_term, exact_reasoner());
    ASSERT_EQ(found.ranked.size(), 1U);
    EXPECT_EQ(request.count(found.ranked[0].lacking), request.size());
    EXPECT_EQ(found.reservation.empty(), request.is_whole());
  }
}

TEST(NearMisses, StopWhereTheQuestionsAreUsedUpAndSaySo) {
  owl::Ontology source = owl::written("SubClassOf(A B)\nSubClassOf(B C)\n");
  const Conjuncts request(source, expression(source, "ObjectIntersectionOf(A B C D E)"), {});
  const TermId candidate = expression(source, "D");
  bool was_whole = false;
  for (std::size_t questions = 1; questions < 20; ++questions) {
    const auto found =
        abduction::find_near_misses(source, request, candidate, exact_reasoner(), {.questions = questions});
    if (found.reservation.empty()) {
      ASSERT_EQ(found.ranked.size(), 1U);
      EXPECT_EQ(request.count(found.ranked[0].lacking), 2U) << "A gives B and C";
      was_whole = true;
      continue;
    }
    EXPECT_FALSE(was_whole);
    for (const auto& one : found.ranked) {
      const TermId goal = request.term(source, request.all() & ~one.retracted);
      const TermId more = both(source, candidate, abduction::added(source, request, one));
      EXPECT_EQ(exact_reasoner().is_subsumed(source, more, goal), Answer::yes);
    }
  }
  EXPECT_TRUE(was_whole);
}

// The words that users are told.

constexpr const char* robots =
    "SubClassOf(Rover Robot)\nSubClassOf(Drone Robot)\nDisjointClasses(Rover Drone)\n"
    "SubClassOf(Gripper Part)\nSubClassOf(Camera Part)\nDisjointClasses(Gripper Camera)\n"
    "EquivalentClasses(Lifter ObjectIntersectionOf(Robot ObjectSomeValuesFrom(hasPart "
    "ObjectIntersectionOf(Gripper DataHasValue(d:payload \"5\"^^x:integer)))))\n"
    "EquivalentClasses(Watcher ObjectIntersectionOf(Robot ObjectSomeValuesFrom(hasPart Camera)))\n"
    "SubClassOf(Handless ObjectAllValuesFrom(hasPart ObjectComplementOf(Gripper)))\nSubClassOf(Handless Robot)\n";

vocabulary::NearMisses told(const char* request, const char* candidate, std::size_t questions = 200) {
  const auto vocabulary = vocabulary::Vocabulary(owl::loaded(robots)).with_expressions();
  const auto asked = vocabulary.read(request, vocabulary::max_expression_bytes);
  const auto offered = vocabulary.read(candidate, vocabulary::max_expression_bytes);
  if (!asked || !offered) {
    ADD_FAILURE() << (asked ? offered : asked).error().text;
    return {};
  }
  return vocabulary.near_misses(*asked, *offered, questions);
}

using Texts = std::vector<std::string>;

TEST(NearMisses, NameWhatIsLackingWithinThePartThatIsKnown) {
  const auto found =
      told("t:Robot and t:hasPart some (t:Gripper and t:payload value 5)", "t:Rover and t:hasPart some t:Gripper");
  ASSERT_EQ(found.ranked.size(), 1U);
  EXPECT_EQ(found.ranked[0].lacking, (Texts{"t:payload value \"5\"^^xsd:integer within "
                                            "t:hasPart some (t:Gripper and (t:payload value \"5\"^^xsd:integer))"}));
  EXPECT_EQ(found.ranked[0].lacking_count, 1U);
  EXPECT_EQ(found.ranked[0].contradicting, Texts());
  EXPECT_TRUE(found.ranked[0].is_possible);
  EXPECT_EQ(found.reservation, "");
}

TEST(NearMisses, TakeAClassApartThatHasADefinition) {
  const auto found = told("t:Lifter", "t:Rover");
  ASSERT_EQ(found.ranked.size(), 1U);
  EXPECT_EQ(found.ranked[0].lacking_count, 2U) << "a gripper, and its payload";
  EXPECT_EQ(told("t:Rover and t:Watcher", "t:Rover and t:hasPart some t:Camera").ranked[0].lacking, Texts());
}

TEST(NearMisses, NameWhatContradictsAndWhatIsLackingOfTheRest) {
  const auto found = told("t:Rover and t:hasPart some t:Gripper and t:hasPart some t:Camera", "t:Handless and t:Drone");
  ASSERT_EQ(found.ranked.size(), 1U);
  EXPECT_EQ(found.ranked[0].contradicting, (Texts{"t:Rover", "t:hasPart some t:Gripper"}));
  EXPECT_EQ(found.ranked[0].contradicting_count, 2U);
  EXPECT_EQ(found.ranked[0].lacking, (Texts{"t:hasPart some t:Camera"}));
  EXPECT_EQ(found.ranked[0].added, "t:hasPart some t:Camera");
  EXPECT_EQ(found.ranked[0].request, "t:hasPart some t:Camera");
}

TEST(NearMisses, AreEmptyWhereItMatchesAndNoneWhereTheCandidateIsImpossible) {
  const auto met = told("t:Robot and t:hasPart some t:Part", "t:Lifter");
  ASSERT_EQ(met.ranked.size(), 1U);
  EXPECT_EQ(met.ranked[0].lacking_count + met.ranked[0].contradicting_count, 0U);
  const auto none = told("t:Robot", "t:Rover and t:Drone");
  EXPECT_TRUE(none.ranked.empty());
  EXPECT_EQ(none.reservation, "the candidate can have no instance");
}

}  // namespace
}  // namespace geminga
