// Overlap of two classes: disjoint pairs, pairs with a common instance, and pairs that no engine decides.
#include "reasoning/explanation/overlap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

using compiled::Ontology;
using owl::loaded;
using owl::named;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Common common(const Ontology& ontology, std::string_view one, std::string_view other) {
  return find_overlap(ontology, named(ontology, one), named(ontology, other)).common;
}

std::vector<std::string> exclusion(const Ontology& ontology, std::string_view one, std::string_view other) {
  std::vector<std::string> texts;
  for (const auto& axiom : explain_exclusion(ontology, named(ontology, one), named(ontology, other))) {
    texts.push_back(axiom.text);
  }
  return texts;
}

TEST(Overlap, IsPossibleUnlessAnAxiomForbidsIt) {
  const Ontology ontology = loaded(owl::robots);
  EXPECT_EQ(common(ontology, "BallInfo", "Shared"), Common::possible);
  EXPECT_EQ(common(ontology, "BallInfo", "Secret"), Common::possible);
  EXPECT_EQ(common(ontology, "SharedBallInfo", "Secret"), Common::impossible);
  EXPECT_EQ(common(ontology, "Secret", "SharedBallInfo"), Common::impossible);
  EXPECT_EQ(common(ontology, "Secret", "Secret"), Common::possible);
  EXPECT_EQ(common(ontology, "Impossible", "Ball"), Common::impossible);
  EXPECT_THAT(exclusion(ontology, "SharedBallInfo", "Secret"),
              ElementsAre("t:SharedBallInfo SubClassOf t:Shared", "t:Secret DisjointWith t:Shared"));
  EXPECT_THAT(exclusion(ontology, "BallInfo", "Secret"), IsEmpty());
}

TEST(Overlap, IsDecidedBeyondTheRulesOfEl) {
  const struct {
    const char* axioms;
    Common common;
  } cases[] = {
      {"SubClassOf(A ObjectMaxCardinality(1 r Thing))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
       "SubClassOf(B ObjectSomeValuesFrom(r D))\nDisjointClasses(C D)",
       Common::impossible},
      {"SubClassOf(A ObjectMaxCardinality(2 r Thing))\nSubClassOf(A ObjectSomeValuesFrom(r C))\n"
       "SubClassOf(B ObjectSomeValuesFrom(r D))\nDisjointClasses(C D)",
       Common::possible},
      {"SubClassOf(A ObjectUnionOf(C D))\nDisjointClasses(B C)\nDisjointClasses(B D)", Common::impossible},
      {"SubClassOf(A ObjectUnionOf(C D))\nDisjointClasses(B C)", Common::possible},
      {"SubClassOf(A ObjectAllValuesFrom(r C))\nSubClassOf(B ObjectSomeValuesFrom(r ObjectComplementOf(C)))",
       Common::impossible},
      {"SubClassOf(A ObjectOneOf(i:x))\nClassAssertion(C i:x)\nDisjointClasses(B C)", Common::impossible},
      {"SubClassOf(A ObjectOneOf(i:x))\nClassAssertion(C i:x)\nSubClassOf(B Thing)", Common::possible},
  };
  for (const auto& one : cases) {
    EXPECT_EQ(common(loaded(one.axioms), "A", "B"), one.common) << one.axioms;
  }
}

/// Some values of a class written in another source.
TEST(Overlap, IsAskedOfExpressions) {
  const Ontology ontology = loaded(
      "SubClassOf(Camera ObjectAllValuesFrom(observes Visible))\nDisjointClasses(Visible Heat)\n"
      "SubClassOf(Ball Visible)\nSubClassOf(Lidar Sensor)");
  owl::Ontology query;
  const auto some = [&](const char* filler) {
    return query.term(owl::TermKind::object_some_values_from,
                      {query.object_property("https://t.example/#observes"),
                       query.named_class(std::string("https://t.example/#") + filler)});
  };
  const owl::TermId heat = some("Heat");
  const owl::TermId ball = some("Ball");
  const auto camera = named(ontology, "Camera");
  EXPECT_EQ(find_overlap(ontology, camera, WrittenClass{query, heat}).common, Common::impossible);
  EXPECT_EQ(find_overlap(ontology, camera, WrittenClass{query, ball}).common, Common::possible);
  EXPECT_EQ(find_overlap(ontology, named(ontology, "Lidar"), WrittenClass{query, heat}).common, Common::possible);
  const auto axioms = explain_exclusion(ontology, camera, WrittenClass{query, heat});
  ASSERT_EQ(axioms.size(), 2U);
  EXPECT_EQ(axioms[0].text, "t:Camera SubClassOf t:observes only t:Visible");
}

TEST(Overlap, IsUndecidedWhereAnAxiomWasNotRead) {
  owl::Ontology source = owl::written("SubClassOf(A C)\nSubClassOf(B C)\nDisjointClasses(A D)\nSubClassOf(D C)");
  source.leave_out("owl:imports", owl::FileId{0}, 1);
  const Ontology ontology = loaded(source);
  const Overlap overlap = find_overlap(ontology, named(ontology, "A"), named(ontology, "B"));
  EXPECT_EQ(overlap.common, Common::undecided);
  EXPECT_THAT(overlap.reason, HasSubstr("owl:imports"));
  source = owl::written("SubClassOf(A C)\nSubClassOf(B C)");
  source.leave_out("geminga:convertsTo of what is no class", owl::FileId{0}, 1);
  EXPECT_EQ(common(loaded(source), "A", "B"), Common::possible) << "that says nothing of classes";
  // An entailment of the other axioms still follows.
  EXPECT_EQ(common(ontology, "A", "D"), Common::impossible);
}

TEST(Overlap, IsUndecidedWhereTheSearchEnds) {
  // Eleven pigeons and ten holes, as classes: there is no model, but the search is too long to find that out.
  constexpr int holes = 10;
  const auto is_in = [](int pigeon, int hole) { return "P" + std::to_string(pigeon) + "H" + std::to_string(hole); };
  std::string axioms = "SubClassOf(B Thing)\n";
  for (int pigeon = 0; pigeon <= holes; ++pigeon) {
    std::string somewhere;
    for (int hole = 0; hole < holes; ++hole) {
      somewhere += ' ' + is_in(pigeon, hole);
      for (int other = 0; other < pigeon; ++other)
        axioms += "DisjointClasses(" + is_in(pigeon, hole) + ' ' + is_in(other, hole) + ")\n";
    }
    axioms += std::string("SubClassOf(") + (pigeon == 0 ? 'A' : 'B') + " ObjectUnionOf(" + somewhere + "))\n";
  }
  const Ontology ontology = loaded(axioms);
  const Overlap overlap = find_overlap(ontology, named(ontology, "A"), named(ontology, "B"), Patience::of_a_daemon);
  EXPECT_EQ(overlap.common, Common::undecided);
  EXPECT_FALSE(overlap.reason.empty());
}

TEST(Overlap, IsAskedAboutSoManyAxioms) {
  // The module has the chain, and nothing else.
  for (const std::size_t count : {max_overlap_axioms - 1, max_overlap_axioms, max_overlap_axioms + 1}) {
    std::string axioms = "SubClassOf(B C0)\n";
    for (std::size_t at = 0; at + 1 < count; ++at)
      axioms += "SubClassOf(C" + std::to_string(at) + " C" + std::to_string(at + 1) + ")\n";
    axioms += "SubClassOf(Elsewhere A)\n";
    const Ontology ontology = loaded(axioms);
    EXPECT_EQ(common(ontology, "A", "B"), count <= max_overlap_axioms ? Common::possible : Common::undecided) << count;
  }
}

/// Writes random axioms of most kinds that OWL 2 DL has.
class Axioms {
 public:
  explicit Axioms(std::uint64_t seed) : random_(seed) {}

  std::string some() {
    std::string axioms = "SubClassOf(A Thing)\nSubClassOf(B Thing)\n";
    for (std::uint64_t count = 6 + random_.below(12); count > 0; --count) axioms += one() + '\n';
    return axioms;
  }

 private:
  std::string name() { return std::string(1, static_cast<char>('A' + random_.below(8))); }
  std::string role() { return std::string(1, static_cast<char>('r' + random_.below(2))); }
  std::string individual() { return std::string("i:") + static_cast<char>('x' + random_.below(2)); }

  std::string one() {
    const auto sub = [&](const std::string& super) { return "SubClassOf(" + name() + ' ' + super + ')'; };
    switch (random_.below(16)) {
      case 0:
        return "DisjointClasses(" + name() + ' ' + name() + ')';
      case 1:
        return sub("ObjectUnionOf(" + name() + ' ' + name() + ')');
      case 2:
      case 3:
        return sub("ObjectSomeValuesFrom(" + role() + ' ' + name() + ')');
      case 4:
        return sub("ObjectAllValuesFrom(" + role() + ' ' + name() + ')');
      case 5:
        return sub("ObjectMaxCardinality(1 " + role() + " Thing)");
      case 6:
        return sub("ObjectComplementOf(" + name() + ')');
      case 7:
        return "InverseObjectProperties(r s)";
      case 8:
        return sub("ObjectOneOf(" + individual() + ')');
      case 9:
        return "ClassAssertion(" + name() + ' ' + individual() + ')';
      case 10:
        return "ObjectPropertyAssertion(" + role() + ' ' + individual() + ' ' + individual() + ')';
      case 11:
        return "ObjectPropertyDomain(" + role() + ' ' + name() + ')';
      case 12:
        return sub("DataSomeValuesFrom(d:p " + std::string(random_.chance(0.5) ? "x:integer" : "x:string") + ')');
      case 13:
        return "FunctionalDataProperty(d:p)";
      default:
        return sub(name());
    }
  }

  base::Random random_;
};

/// The module and the limits of a question lose nothing.
TEST(Overlap, IsWhatTheReasonerSaysOfTheWhole) {
  std::size_t excluded = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    const std::string axioms = Axioms(seed).some();
    owl::Ontology source = owl::written(axioms);
    const Ontology ontology = loaded(source);
    const owl::TermId both =
        source.term(owl::TermKind::object_intersection_of,
                    {source.named_class("https://t.example/#A"), source.named_class("https://t.example/#B")});
    const auto whole = reasoner::entails(source, std::nullopt, both, owl::nothing_term);
    if (whole.verdict == reasoner::Verdict::unknown) continue;
    const bool is_excluded = whole.verdict == reasoner::Verdict::yes;
    excluded += is_excluded ? 1 : 0;
    const Overlap overlap = find_overlap(ontology, named(ontology, "A"), named(ontology, "B"), Patience::of_a_daemon);
    EXPECT_EQ(overlap.common, is_excluded ? Common::impossible : Common::possible)
        << "seed " << seed << ' ' << overlap.reason << '\n'
        << axioms;
    EXPECT_TRUE(!is_excluded || !exclusion(ontology, "A", "B").empty()) << "seed " << seed << '\n' << axioms;
  }
  EXPECT_GT(excluded, test::rounds(40U));
  EXPECT_LT(excluded, test::rounds(260U));
}

}  // namespace
}  // namespace geminga::explanation
