// Names, subsumption, distance, explanations and digests of an ontology as the daemon asks for them.
#include "reasoning/compiled/ontology.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/owl/canonical.hpp"
#include "support/written.hpp"

namespace geminga::compiled {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> short_names(const Ontology& ontology, const std::vector<taxonomy::ClassNumber>& classes) {
  std::vector<std::string> names;
  for (const taxonomy::ClassNumber number : classes) names.push_back(ontology.short_name(number));
  return names;
}

TEST(Ontology, FindsAClassByEveryFormOfItsName) {
  owl::Ontology source = owl::written(owl::robots);
  source.add_label("https://t.example/#BallInfo", "ball information", "en");
  source.add_label("https://t.example/#BallInfo", "Ballinformation", "de");
  const Ontology ontology = owl::loaded(source);
  const taxonomy::ClassNumber ball = *ontology.find_iri("https://t.example/#BallInfo");
  for (const char* name : {"t:BallInfo", "<https://t.example/#BallInfo>", "https://t.example/#BallInfo",
                           "ball information", "Ballinformation"}) {
    const auto found = ontology.find(name);
    ASSERT_TRUE(found) << name << ": " << found.error().text;
    EXPECT_EQ(*found, ball) << name;
  }
  EXPECT_EQ(ontology.label(ball), "ball information");
  EXPECT_EQ(ontology.label(owl::named(ontology, "Info")), "");
  EXPECT_EQ(ontology.iri(ball), "https://t.example/#BallInfo");
  EXPECT_EQ(ontology.short_name(ball), "t:BallInfo");
  EXPECT_EQ(ontology.short_name("https://other.example/x"), "<https://other.example/x>");
}

TEST(Ontology, SaysWhatIsWrongWithAName) {
  owl::Ontology source = owl::written(owl::robots);
  source.add_label("https://t.example/#BallInfo", "ball");
  source.add_label("https://t.example/#Shared", "ball");
  const Ontology ontology = owl::loaded(source);
  using Kind = NameError::Kind;
  const struct {
    const char* name;
    Kind kind;
    const char* text;
  } cases[] = {
      {"", Kind::malformed, "empty"},
      {"<https://t.example/#BallInfo", Kind::malformed, "does not end in >"},
      {"<>", Kind::malformed, "does not end in >"},
      {"<https://t.example/#Nobody>", Kind::unknown, "no class has the IRI"},
      {"t:Nobody", Kind::unknown, "neither a class nor a label"},
      {"u:BallInfo", Kind::unknown, "unknown prefix: known are owl: rdf: rdfs: t: xsd:"},
      {"https://t.example/#Nobody", Kind::unknown, "neither a class nor a label"},
      {"goal", Kind::unknown, "neither a class nor a label"},
      {"ball", Kind::ambiguous, "t:BallInfo or t:Shared"},
  };
  for (const auto& one : cases) {
    const auto found = ontology.find(one.name);
    ASSERT_FALSE(found) << one.name;
    EXPECT_EQ(found.error().kind, one.kind) << one.name;
    EXPECT_THAT(found.error().text, HasSubstr(one.text)) << one.name;
    EXPECT_EQ(found.error().text.find('\n'), std::string::npos) << one.name;
  }
}

TEST(Ontology, SaysThatAPrefixWithTwoMeaningsIsAmbiguousOnlyWhereBothNameAClass) {
  owl::Ontology source = owl::written("SubClassOf(A B)");
  const owl::FileId file = source.add_file("other");
  source.add_prefix("t", "https://u.example/#");
  source.add(owl::AxiomKind::sub_class_of,
             {source.named_class("https://u.example/#A"), source.named_class("https://u.example/#C")}, file, 1);
  const Ontology ontology = owl::loaded(source);
  EXPECT_EQ(ontology.find("t:A").error().kind, NameError::Kind::ambiguous);
  EXPECT_EQ(ontology.iri(*ontology.find("t:B")), "https://t.example/#B");
  EXPECT_EQ(ontology.iri(*ontology.find("t:C")), "https://u.example/#C");
  // A short name must lead back to its class.
  EXPECT_EQ(ontology.short_name(*ontology.find("t:B")), "<https://t.example/#B>");
}

TEST(Ontology, FindsAClassByItsLocalNameWhereNothingElseFits) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("team.ttl");
  for (const char* one : {"capability#Robot", "soccer#Ball", "rescue/Ball", "soccer#Mast"}) {
    source.add(owl::AxiomKind::sub_class_of,
               {source.named_class("https://t.example/" + std::string(one)), source.named_class("urn:t:Thing")}, file,
               1);
  }
  source.add_label("urn:t:Thing", "Mast");
  const Ontology ontology = owl::loaded(source);
  const auto robot = ontology.find("Robot");
  ASSERT_TRUE(robot);
  EXPECT_EQ(ontology.iri(*robot), "https://t.example/capability#Robot");
  EXPECT_EQ(ontology.iri(*ontology.find("Mast")), "urn:t:Thing") << "a label comes first";
  EXPECT_EQ(ontology.find("Ball").error().kind, NameError::Kind::ambiguous);
  for (const char* none : {"Rob", "robot", "t#Robot", "other:Robot", "capability Robot", "https", ""}) {
    EXPECT_FALSE(ontology.find(none)) << none;
  }
}

TEST(Ontology, HasThingAndNothing) {
  const Ontology ontology = owl::loaded(owl::robots);
  const auto thing = ontology.find("owl:Thing");
  const auto nothing = ontology.find("owl:Nothing");
  ASSERT_TRUE(thing && nothing);
  for (std::uint32_t number = 0; number < ontology.class_count(); ++number) {
    EXPECT_TRUE(ontology.is_subsumed(taxonomy::ClassNumber{number}, *thing));
    EXPECT_TRUE(ontology.is_subsumed(*nothing, taxonomy::ClassNumber{number}));
  }
  EXPECT_FALSE(ontology.is_satisfiable(*nothing));
  EXPECT_TRUE(ontology.is_satisfiable(*thing));
  EXPECT_FALSE(ontology.is_subsumed(*thing, *nothing));
}

TEST(Ontology, NumbersClassesByIri) {
  const Ontology ontology = owl::loaded(owl::robots);
  for (std::uint32_t number = 1; number < ontology.class_count(); ++number) {
    EXPECT_LT(ontology.iri(taxonomy::ClassNumber{number - 1}), ontology.iri(taxonomy::ClassNumber{number}));
  }
}

TEST(Ontology, KnowsTheTaxonomy) {
  const Ontology ontology = owl::loaded(owl::robots);
  const auto shared_ball = owl::named(ontology, "SharedBallInfo");
  EXPECT_THAT(
      short_names(ontology, ontology.subsumers(shared_ball)),
      ElementsAre("owl:Thing", "t:Ball", "t:BallInfo", "t:Info", "t:Shared", "t:SharedBallInfo", "t:TrackedObject"));
  EXPECT_THAT(short_names(ontology, ontology.parents(shared_ball)), ElementsAre("t:Ball", "t:Shared"));
  EXPECT_THAT(short_names(ontology, ontology.parents(owl::named(ontology, "BallInfo"))),
              ElementsAre("t:TrackedObject"));
  EXPECT_THAT(short_names(ontology, ontology.children(owl::named(ontology, "Info"))),
              ElementsAre("t:Shared", "t:TrackedObject"));
  EXPECT_THAT(short_names(ontology, ontology.parents(owl::named(ontology, "Info"))), ElementsAre("owl:Thing"));
  EXPECT_THAT(ontology.parents(*ontology.find("owl:Thing")), IsEmpty());
  EXPECT_TRUE(ontology.is_equivalent(owl::named(ontology, "Ball"), owl::named(ontology, "BallInfo")));
  EXPECT_FALSE(ontology.is_satisfiable(owl::named(ontology, "Impossible")));
  EXPECT_EQ(ontology.subsumers(owl::named(ontology, "Impossible")).size(), ontology.class_count());
  EXPECT_THAT(ontology.parents(owl::named(ontology, "Impossible")), IsEmpty());
}

TEST(Ontology, MeasuresTheShortestWayUp) {
  const Ontology ontology = owl::loaded(owl::robots);
  const auto distance = [&](const char* sub, const char* super) {
    return ontology.distance(owl::named(ontology, sub), owl::named(ontology, super));
  };
  EXPECT_EQ(distance("BallInfo", "BallInfo"), 0);
  EXPECT_EQ(distance("BallInfo", "Ball"), 0);
  EXPECT_EQ(distance("SharedBallInfo", "BallInfo"), 1);
  EXPECT_EQ(distance("SharedBallInfo", "Info"), 2);  // by Shared, not by TrackedObject
  EXPECT_EQ(ontology.distance(owl::named(ontology, "SharedBallInfo"), *ontology.find("owl:Thing")), 3);
  EXPECT_EQ(distance("Info", "BallInfo"), std::nullopt);
  EXPECT_EQ(distance("Impossible", "SharedBallInfo"), 1);
  EXPECT_EQ(distance("Impossible", "Info"), 3);  // it lies below every leaf, here SharedBallInfo
}

TEST(Digest, DependsOnAxiomsAndClassesOnly) {
  const auto of = [](std::string_view text, const std::string& path = "a.ofn") {
    return digest(owl::written(text, path));
  };
  const std::uint64_t one = of("SubClassOf(A B)\nEquivalentClasses(C D)");
  EXPECT_EQ(owl::loaded("SubClassOf(A B)\nEquivalentClasses(C D)").digest(), one);
  EXPECT_EQ(of("EquivalentClasses(D C)\n\nSubClassOf(A B)", "b.ofn"), one);
  EXPECT_EQ(of("EquivalentClasses(D C)\nSubClassOf(A B)\nSubClassOf(A B)"), one);
  EXPECT_NE(of("SubClassOf(B A)\nEquivalentClasses(C D)"), one);
  EXPECT_NE(of("SubClassOf(A B)"), one);
  EXPECT_NE(of("SubClassOf(A B)\nEquivalentClasses(C D)\nDeclaration(E)"), one);
  EXPECT_EQ(of("SubClassOf(A ObjectIntersectionOf(B C))"), of("SubClassOf(A ObjectIntersectionOf(C B))"));
  EXPECT_NE(of("SubObjectPropertyOf(ObjectPropertyChain(r s) t)"),
            of("SubObjectPropertyOf(ObjectPropertyChain(s r) t)"));
  EXPECT_NE(of("SubClassOf(A ObjectMinCardinality(2 r B))"), of("SubClassOf(A ObjectMinCardinality(3 r B))"));
  EXPECT_EQ(of("ClassAssertion(A _:x)"), of("ClassAssertion(A _:y)"));
}

TEST(Digest, IsTheSameInAnyOrderOfFiles) {
  owl::Ontology first;
  owl::write_into(first, "SubClassOf(A B)", "a");
  owl::write_into(first, "SubClassOf(B C)", "b");
  owl::Ontology second;
  owl::write_into(second, "SubClassOf(B C)", "b");
  owl::write_into(second, "SubClassOf(A B)", "a");
  EXPECT_EQ(digest(first), digest(second));
  EXPECT_EQ(compile(first, owl::classified(first)), compile(second, owl::classified(second)));
}

TEST(Ontology, MayBeMoved) {
  Ontology first = owl::loaded(owl::robots);
  Ontology second = std::move(first);
  EXPECT_TRUE(second.find("t:Ball"));
  first = owl::loaded("SubClassOf(A B)");
  std::swap(first, second);
  EXPECT_TRUE(second.find("t:A"));
  EXPECT_TRUE(first.find("t:Ball"));
}

}  // namespace
}  // namespace geminga::compiled
