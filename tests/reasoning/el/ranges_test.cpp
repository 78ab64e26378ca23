// Ranges over chains: tested on a closure that has no rules for them, and by the rules.
#include "reasoning/el/closure/ranges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "base/sorted.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/el/closure/inheritance.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/rule_normaliser.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

enum class Outcome : std::uint8_t {
  no_open_range,  ///< the test is not for this ontology
  passed,
  needs_rules
};

/// The outcome of the range test on all named classes.
Outcome tested(const owl::Ontology& source, unsigned threads = 1) {
  IndexBuilder builder;
  RuleNormaliser normaliser(source, builder);
  for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom) (void)normaliser.add(axiom);
  std::vector<ExprId> asked;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    if (source.kind(owl::TermId{id}) == owl::TermKind::named_class)
      asked.push_back(normaliser.expression(owl::TermId{id}));
  }
  (void)normaliser.finish(Universals::tested);
  const IndexedOntology index = *builder.finish(1'000'000);
  if (normaliser.open().ranges.empty() || !Inheritance::is_for(index)) return Outcome::no_open_range;
  for (ExprId& expr : asked) expr = index.representative(expr);
  base::sort_unique(asked);
  Inheritance inheritance(index, {}, asked);
  EXPECT_TRUE(inheritance.run(threads));
  if (!inheritance.is_consistent()) return Outcome::no_open_range;
  return inheritance.has_ranges(normaliser.open().ranges) ? Outcome::passed : Outcome::needs_rules;
}

/// A leads over B to C, which the chain makes an end of t; the range of t is R.
const std::string over_a_chain =
    "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B ObjectSomeValuesFrom(s C))\n"
    "SubObjectPropertyOf(ObjectPropertyChain(r s) t)\nObjectPropertyRange(t R)\n";

bool is_derived(const std::string& axioms, const std::string& line) {
  return std::ranges::binary_search(owl::closure(over_a_chain + axioms), line);
}

TEST(ARangeOverAChain, NeedsNoRulesWhereTheEndIsInIt) {
  EXPECT_EQ(tested(owl::written(over_a_chain + "SubClassOf(C R)\n")), Outcome::passed);
  EXPECT_EQ(tested(owl::written(over_a_chain + "SubClassOf(R0 R)\nEquivalentClasses(C ObjectIntersectionOf(R0 D))\n")),
            Outcome::passed);
  EXPECT_EQ(tested(owl::written(over_a_chain + "SubClassOf(Thing R)\n")), Outcome::passed);
}

TEST(ARangeOverAChain, NeedsNoRulesWhereTheEndIsOutsideItAndNobodyHears) {
  const std::string unheard[] = {
      "",
      "SubClassOf(R S)\nSubClassOf(R ObjectSomeValuesFrom(r D))\n",
      "SubClassOf(ObjectSomeValuesFrom(u R) D)\n",
      "SubClassOf(ObjectIntersectionOf(C R) D)\n",
      "DisjointClasses(R D)\n",
  };
  for (const std::string& axioms : unheard) {
    EXPECT_EQ(tested(owl::written(over_a_chain + axioms)), Outcome::passed) << axioms;
    EXPECT_TRUE(classify(owl::written(over_a_chain + axioms))->unused.empty()) << axioms;
  }
}

TEST(ARangeOverAChain, NeedsRulesWhereSomethingMayFollow) {
  const struct {
    std::string axioms;
    std::string line;  ///< follows
  } heard[] = {
      {"SubClassOf(ObjectSomeValuesFrom(t R) D)\n", "A < D"},
      {"SubClassOf(ObjectSomeValuesFrom(r ObjectSomeValuesFrom(s R)) D)\n", "A < D"},
      {"SubClassOf(ObjectSomeValuesFrom(t ObjectIntersectionOf(C R)) D)\n", "A < D"},
      {"DisjointClasses(R C)\n", "A < Nothing"},
      {"SubClassOf(R ObjectSomeValuesFrom(u D))\nSubObjectPropertyOf(ObjectPropertyChain(t u) v)\n"
       "SubClassOf(ObjectSomeValuesFrom(v D) E)\n",
       "A < E"},
      // The range leads on, and the next range is needed to find it.
      {"SubClassOf(R ObjectSomeValuesFrom(s D))\nSubObjectPropertyOf(ObjectPropertyChain(t s) v)\n"
       "ObjectPropertyRange(v Q)\nSubClassOf(ObjectSomeValuesFrom(v Q) E)\n",
       "A < E"},
  };
  for (const auto& [axioms, line] : heard) {
    EXPECT_EQ(tested(owl::written(over_a_chain + axioms)), Outcome::needs_rules) << axioms;
    EXPECT_TRUE(is_derived(axioms, line)) << axioms;
  }
}

TEST(ARangeOverAChain, IsNotTakenForOneOfTheClassThatLiesAtItsEnd) {
  // B leads to what is in R only as a part of A: no s of C alone is in R.
  const std::string axioms = "SubClassOf(ObjectSomeValuesFrom(s R) D)\n";
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms)), Outcome::needs_rules);
  EXPECT_FALSE(is_derived(axioms, "B < D"));
  EXPECT_FALSE(is_derived(axioms, "C < R"));
}

TEST(NewsOfARange, IsHarmlessUnlessAConjunctionIsNear) {
  // B hears of R, being below `s some C`; a conjunction with something that is not above B has no instance.
  const std::string axioms = "SubClassOf(ObjectIntersectionOf(P ObjectSomeValuesFrom(s R)) D)\n";
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms)), Outcome::passed);
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms + "SubClassOf(B P)\n")), Outcome::needs_rules);
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms + "SubClassOf(B0 B)\nSubClassOf(B0 P)\n")), Outcome::needs_rules);
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms + "SubClassOf(B0 B)\nSubClassOf(P0 P)\n")), Outcome::passed);
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms + "SubClassOf(ObjectSomeValuesFrom(s Thing) P)\n")),
            Outcome::needs_rules);
  EXPECT_EQ(tested(owl::written(over_a_chain + axioms + "SubClassOf(Thing P)\n")), Outcome::needs_rules);
  EXPECT_EQ(
      tested(owl::written(over_a_chain + axioms + "SubClassOf(Thing ObjectSomeValuesFrom(s C))\nSubClassOf(P0 P)\n")),
      Outcome::needs_rules);
}

TEST(NewsOfARange, IsNotLookedIntoWhereConjunctionsAreTooMany) {
  const auto with_partners = [](std::size_t count) {
    std::string axioms = over_a_chain;
    for (std::size_t at = 0; at < count; ++at)
      axioms += "SubClassOf(ObjectIntersectionOf(P" + std::to_string(at) + " ObjectSomeValuesFrom(s R)) D)\n";
    return owl::written(axioms);
  };
  constexpr std::size_t most = 64;
  EXPECT_EQ(tested(with_partners(most - 1)), Outcome::passed);
  EXPECT_EQ(tested(with_partners(most)), Outcome::passed);
  EXPECT_EQ(tested(with_partners(most + 1)), Outcome::needs_rules);
}

TEST(NewsOfARange, CountsAtTheSecondNodeOfAnEnd) {
  // B leads over t and u to what is a B, an A and, by the range of v, an E: that leads on to another one, and is a D.
  const owl::Ontology source = owl::written(
      "SubObjectPropertyOf(ObjectPropertyChain(t u) v)\nObjectPropertyRange(u A)\nObjectPropertyRange(v E)\n"
      "SubClassOf(B ObjectSomeValuesFrom(t A))\nSubClassOf(A ObjectSomeValuesFrom(u B))\n"
      "SubClassOf(ObjectIntersectionOf(A E) C)\nSubClassOf(ObjectIntersectionOf(C ObjectSomeValuesFrom(v C)) D)\n"
      "SubClassOf(ObjectSomeValuesFrom(v D) F)\n");
  EXPECT_EQ(tested(source), Outcome::needs_rules);
  EXPECT_TRUE(std::ranges::binary_search(owl::closure(owl::loaded(source)), "B < F"));
}

/// Few classes and properties with many chains and ranges, so that ranges often meet what they change.
std::string ontology_with_ranges(base::Random& random) {
  const auto name = [&] { return std::string(1, static_cast<char>('A' + random.below(7))); };
  const auto role = [&] { return std::string(1, static_cast<char>('r' + random.below(5))); };
  const auto some = [&](const std::string& filler) { return "ObjectSomeValuesFrom(" + role() + " " + filler + ")"; };
  const auto both = [&](const std::string& one, const std::string& other) {
    return "ObjectIntersectionOf(" + one + " " + other + ")";
  };
  std::string text;
  // A chain or property is below one that is not before it, so that all hierarchies are regular.
  for (std::uint64_t left = 1 + random.below(3); left > 0; --left) {
    const std::string first = role();
    const std::string second = role();
    text += "SubObjectPropertyOf(ObjectPropertyChain(" + first + " " + second + ") " +
            std::max({first, second, role()}) + ")\n";
  }
  for (std::uint64_t left = random.below(3); left > 0; --left) {
    const std::string one = role();
    text += "SubObjectPropertyOf(" + one + " " + std::max(one, role()) + ")\n";
  }
  for (std::uint64_t left = 1 + random.below(3); left > 0; --left)
    text += "ObjectPropertyRange(" + role() + " " + name() + ")\n";
  for (std::uint64_t left = 5 + random.below(9); left > 0; --left) {
    const auto subclass = [&](const std::string& sub, const std::string& super) {
      text += "SubClassOf(" + sub + " " + super + ")\n";
    };
    switch (random.below(11)) {
      case 0:
        subclass(name(), name());
        break;
      case 1:
        subclass(some(name()), name());
        break;
      case 2:
        subclass(both(name(), some(name())), name());
        break;
      case 3:
        subclass(both(name(), name()), name());
        break;
      case 4:
        subclass(some(some(name())), name());
        break;
      case 5:
        subclass(name(), some(both(name(), name())));
        break;
      case 6:
        if (random.chance(0.3)) subclass(name(), "ObjectHasSelf(" + role() + ")");
        if (random.chance(0.3)) text += "DisjointClasses(" + name() + " " + name() + ")\n";
        if (random.chance(0.1)) subclass("Thing", some(name()));
        break;
      default:
        subclass(name(), some(name()));
    }
  }
  return text;
}

TEST(RandomRanges, FollowAsByTheRules) {
  int passed = 0;
  int with_rules = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(1500U); ++seed) {
    base::Random random(seed);
    const std::string text = ontology_with_ranges(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const owl::Ontology source = owl::written(text);
    const auto by_rules = classify(source, {.inherits = false});
    const Outcome outcome = tested(source);
    if (!by_rules || !by_rules->unused.empty() || outcome == Outcome::no_open_range) continue;
    ++(outcome == Outcome::passed ? passed : with_rules);
    ASSERT_EQ(tested(source, 2), outcome);
    const auto found = classify(source);
    ASSERT_TRUE(found && found->unused.empty());
    ASSERT_EQ(found->is_consistent, by_rules->is_consistent);
    ASSERT_EQ(found->representative, by_rules->representative);
    ASSERT_EQ(found->parent_begin, by_rules->parent_begin);
    ASSERT_EQ(found->parents, by_rules->parents);
  }
  EXPECT_GT(passed, test::rounds(400));
  EXPECT_GT(with_rules, 0);  // one ontology in fifty has a range that changes something
}

}  // namespace
}  // namespace geminga::el
