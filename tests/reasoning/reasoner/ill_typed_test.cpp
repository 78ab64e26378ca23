// Only questions that depend on an ill-typed literal are undecided. A no is right whatever value was meant.
#include "reasoning/reasoner/ill_typed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/reasoner/argued.hpp"
#include "reasoning/reasoner/repairs.hpp"
#include "support/rounds.hpp"

namespace geminga::reasoner {
namespace {

using testing::HasSubstr;

/// The axioms of the premise that are ill-typed: the conclusion of these tests has none.
std::vector<std::size_t> ill_typed_of(const owl::Ontology& source) {
  std::vector<std::size_t> numbers(source.ill_typed_count());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// "yes", "no" or "open", of each line of the conclusion.
std::string asked(std::string_view premise, std::string_view conclusion) {
  Argued argued(premise, conclusion);
  std::string text;
  for (const Answer& answer :
       entails_each(argued.source, argued.premise, argued.conclusion, ill_typed_of(argued.source))) {
    if (!text.empty()) text += ' ';
    text += answer.verdict == Verdict::yes ? "yes" : answer.verdict == Verdict::no ? "no" : "open";
  }
  return text;
}

constexpr std::string_view person =
    "DataPropertyDomain(d:age Person)\nDataPropertyRange(d:age x:integer)\nFunctionalDataProperty(d:age)\n"
    "DataPropertyAssertion(d:age i:ann \"30\"^x:integer)\nDataPropertyAssertion(d:age i:bob \"twelve\"^x:integer)\n"
    "ClassAssertion(Person i:ann)\nSubClassOf(Dog Animal)\n";

TEST(DamagedLiteral, LeavesOpenWhatMayHangOnIt) {
  EXPECT_EQ(asked(person, "DataPropertyAssertion(d:age i:bob \"12\"^x:integer)"), "open");
  EXPECT_EQ(asked(person, "ClassAssertion(Person i:bob)"), "open") << "the property's domain, whatever the age";
  EXPECT_EQ(asked(person, "ClassAssertion(DataSomeValuesFrom(d:age x:integer) i:bob)"), "open");
}

TEST(DamagedLiteral, LeavesAllElseDecided) {
  EXPECT_EQ(asked(person, "SubClassOf(Animal Dog)"), "no");
  EXPECT_EQ(asked(person, "SubClassOf(Dog Animal)"), "yes");
  EXPECT_EQ(asked(person, "ClassAssertion(Dog i:bob)"), "no");
  EXPECT_EQ(asked(person, "ClassAssertion(Person i:ann)\nClassAssertion(Dog i:ann)"), "yes no");
  EXPECT_EQ(asked(person, "DataPropertyAssertion(d:weight i:bob \"12\"^x:integer)"), "no");
}

TEST(DamagedLiteral, SaysWhereItIs) {
  Argued argued(person, "ClassAssertion(Person i:bob)");
  const auto answers = entails_each(argued.source, argued.premise, argued.conclusion, ill_typed_of(argued.source));
  EXPECT_THAT(answers.at(0).reason, HasSubstr("a literal that is not of its datatype: premise.ofn:5"));
}

TEST(DamagedLiteral, MayBeOnEitherSideOfWhatTellsItsValuesApart) {
  const std::string grown = std::string(person) +
                            "EquivalentClasses(Child DataHasValue(d:age \"3\"^x:integer))\nSubClassOf(Child Small)\n"
                            "SubClassOf(DataSomeValuesFrom(d:age x:negativeInteger) Odd)\n";
  EXPECT_EQ(asked(grown, "ClassAssertion(Small i:bob)"), "open");
  EXPECT_EQ(asked(grown, "ClassAssertion(Odd i:bob)"), "open");
  EXPECT_EQ(asked(grown, "ClassAssertion(Small i:ann)"), "no");
  EXPECT_EQ(asked(grown, "DifferentIndividuals(i:ann i:bob)"), "open") << "their ages may differ";
}

TEST(DamagedLiteral, MayContradictWhatElseIsSaid) {
  const std::string range = "DataPropertyRange(d:on x:boolean)\nDataPropertyAssertion(d:on i:a \"yes\"^x:boolean)\n";
  EXPECT_EQ(asked(range, "SubClassOf(A B)"), "no");
  EXPECT_EQ(asked(range + "NegativeDataPropertyAssertion(d:on i:a \"true\"^x:boolean)\n", "SubClassOf(A B)"), "open");
}

TEST(DamagedLiteral, OfSeveralAnyMayBeEqual) {
  const std::string two =
      "FunctionalDataProperty(d:p)\nDataPropertyAssertion(d:p i:a \"x\"^x:integer)\n"
      "DataPropertyAssertion(d:p i:b \"x\"^x:integer)\nClassAssertion(A i:a)\n";
  EXPECT_EQ(asked(two, "DifferentIndividuals(i:a i:b)"), "open");
  EXPECT_EQ(asked(two, "SameIndividual(i:a i:b)"), "no");
  EXPECT_EQ(asked(two, "ClassAssertion(A i:b)"), "no");
  EXPECT_EQ(asked(two + "DataPropertyAssertion(d:p i:a \"y\"^x:integer)\n", "ClassAssertion(A i:b)"), "open")
      << "i:a has two values, or one";
}

TEST(DamagedLiteral, BeyondWhatCanBeToldApartLeavesEveryNoOpen) {
  const std::string fact = "DataPropertyAssertion(d:p i:a \"x\"^x:integer)\n";
  EXPECT_EQ(asked(fact + "DataPropertyRange(d:p x:date)\n", "SubClassOf(A B)"), "open") << "an unknown datatype";
  EXPECT_EQ(asked(fact + "DataPropertyRange(d:q x:date)\n", "SubClassOf(A B)"), "no") << "that of another property";
  EXPECT_EQ(asked("DatatypeDefinition(x:mine DataOneOf(\"x\"^x:integer))\n", "SubClassOf(A B)"), "open");
  EXPECT_EQ(
      asked("SubClassOf(A DataSomeValuesFrom(d:p DatatypeRestriction(x:integer x:minInclusive \"x\"^x:integer)))\n",
            "SubClassOf(A B)"),
      "open")
      << "a bound";
}

TEST(ForeignFacet, LeavesOpenWhatMayHangOnItsAxiom) {
  const std::string bound =
      "SubClassOf(A DataSomeValuesFrom(d:p DatatypeRestriction(x:double x:maxInclusive \"1\"^x:integer)))\n"
      "SubClassOf(A B)\n";
  EXPECT_EQ(asked(bound, "SubClassOf(A B)"), "yes");
  EXPECT_EQ(asked(bound, "SubClassOf(A Nothing)"), "open") << "no class is empty because of it";
  Argued argued(bound, "SubClassOf(A Nothing)");
  const auto answers = entails_each(argued.source, argued.premise, argued.conclusion, ill_typed_of(argued.source));
  EXPECT_THAT(answers.at(0).reason, HasSubstr("a facet or bound that its datatype does not have: premise.ofn:1"));
}

TEST(DamagedLiteral, HasAsManyReadingsAsTheLimitAllows) {
  // A number is one of these or in one of the gaps between them: 2 n + 1 repairs.
  for (const auto& [points, expected] : {std::pair{30, "no"}, {31, "no"}, {32, "open"}}) {
    std::string premise = "DataPropertyAssertion(d:p i:a \"x\"^x:decimal)\n";
    for (int point = 0; point < points; ++point)
      premise += "SubClassOf(C" + std::to_string(point) + " DataHasValue(d:p \"" + std::to_string(10 * point) +
                 "\"^x:integer))\n";
    static_assert(max_repairs == 64);
    EXPECT_EQ(asked(premise, "ClassAssertion(C0 i:a)"), expected) << points;
  }
}

TEST(DamagedLiteral, MayStandInManyFactsWhereNobodyCountsTheirValues) {
  const auto facts = [](int count) {
    std::string text = "DataPropertyRange(d:p x:integer)\n";
    for (int fact = 0; fact < count; ++fact)
      text += "DataPropertyAssertion(d:p i:a" + std::to_string(fact) + " \"x\"^x:integer)\n";
    return text;
  };
  EXPECT_EQ(asked(facts(500), "SubClassOf(A B)"), "no");
  const std::string counted = "FunctionalDataProperty(d:p)\n";
  EXPECT_EQ(asked(facts(3) + counted, "SubClassOf(A B)"), "no") << "27 readings";
  EXPECT_EQ(asked(facts(4) + counted, "SubClassOf(A B)"), "open") << "256 readings";
}

TEST(DamagedLiteral, LeavesConsistencyOpenOnlyWhereItMattersToIt) {
  const auto verdict = [](std::string_view text) {
    owl::Ontology source;
    owl::write_into(source, text, "written.ofn");
    return is_consistent_repaired(source).verdict;
  };
  EXPECT_EQ(verdict(person), Verdict::yes);
  EXPECT_EQ(verdict(std::string(person) + "SubClassOf(DataHasValue(d:age \"7\"^x:integer) Nothing)\n"),
            Verdict::unknown);
  EXPECT_EQ(verdict("SubClassOf(Thing Nothing)\nDataPropertyAssertion(d:p i:a \"x\"^x:integer)\n"), Verdict::no);
}

/// A premise in which ? stands for a literal, and questions.
struct Made {
  std::string premise;
  std::string conclusion;
};

Made make(base::Random& random) {
  const auto number = [&] { return "\"" + std::to_string(random.below(4)) + "\"^x:integer"; };
  const auto property = [&] { return random.chance(0.7) ? std::string("d:p") : std::string("d:q"); };
  const auto named = [&] { return std::string(1, static_cast<char>('A' + random.below(4))); };
  const auto one = [&] { return random.chance(0.6) ? std::string("i:a") : std::string("i:b"); };
  const auto range = [&]() -> std::string {
    switch (random.below(6)) {
      case 4:
        return "DatatypeRestriction(x:integer x:minInclusive " + number() + ")";
      case 0:
        return "x:nonNegativeInteger";
      case 1:
        return "DataOneOf(" + number() + ' ' + number() + ')';
      case 2:
        return "DataComplementOf(DataOneOf(" + number() + "))";
      case 3:
        return "x:positiveInteger";
      default:
        return "x:decimal";
    }
  };
  const auto axiom = [&]() -> std::string {
    switch (random.below(9)) {
      case 0:
        return "FunctionalDataProperty(" + property() + ")\n";
      case 1:
        return "SubDataPropertyOf(d:p d:q)\n";
      case 2:
        return "SubClassOf(DataSomeValuesFrom(" + property() + ' ' + range() + ") " + named() + ")\n";
      case 3:
        return "SubClassOf(" + named() + " DataAllValuesFrom(" + property() + ' ' + range() + "))\n";
      case 4:
        return "DataPropertyAssertion(" + property() + ' ' + one() + ' ' + number() + ")\n";
      case 5:
        return "SubClassOf(" + named() + ' ' + named() + ")\n";
      case 6:
        return "DisjointDataProperties(d:p d:q)\n";
      case 7:
        return "SubClassOf(" + named() + " DataMaxCardinality(1 " + property() + "))\n";
      default:
        return "ClassAssertion(" + named() + ' ' + one() + ")\n";
    }
  };
  Made made{"DataPropertyAssertion(" + property() + " i:a ?)\n", {}};
  if (random.chance(0.2)) made.premise = "SubClassOf(A DataHasValue(" + property() + " ?))\n";
  for (std::uint64_t count = 2 + random.below(5); count > 0; --count) made.premise += axiom();
  for (int count = 0; count < 4; ++count)
    made.conclusion += random.chance(0.5) ? "ClassAssertion(" + named() + ' ' + one() + ")\n"
                                          : "SubClassOf(" + named() + ' ' + named() + ")\n";
  made.conclusion += "DifferentIndividuals(i:a i:b)\nDataPropertyAssertion(d:q " + one() + ' ' + number() + ")\n";
  return made;
}

TEST(DamagedLiteral, LetsNoBeNoWhateverValueWasMeant) {
  std::size_t decided = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    base::Random random(seed);
    const Made made = make(random);
    const auto with = [&](const std::string& literal) {
      std::string text = made.premise;
      text.replace(text.find('?'), 1, literal);
      return text;
    };
    Argued ill_typed(with("\"x\"^x:integer"), made.conclusion);
    ASSERT_EQ(ill_typed.source.ill_typed_count(), 1U);
    const auto found =
        entails_each(ill_typed.source, ill_typed.premise, ill_typed.conclusion, ill_typed_of(ill_typed.source));
    for (int value = -2; value <= 5; ++value) {
      const auto meant = Argued(with('"' + std::to_string(value) + "\"^x:integer"), made.conclusion).answers();
      for (std::size_t at = 0; at < found.size(); ++at) {
        if (found[at].verdict == Verdict::no) {
          ++decided;
          EXPECT_EQ(meant[at].verdict, Verdict::no)
              << "seed " << seed << ", line " << at + 1 << ", value " << value << '\n'
              << made.premise << made.conclusion;
        }
        if (found[at].verdict == Verdict::yes) {
          EXPECT_EQ(meant[at].verdict, Verdict::yes) << "seed " << seed << '\n' << made.premise << made.conclusion;
        }
      }
    }
  }
  EXPECT_GT(decided, test::rounds(1000U));
}

}  // namespace
}  // namespace geminga::reasoner
