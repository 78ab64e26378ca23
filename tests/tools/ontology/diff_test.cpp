// The changes between two ontologies, and their consequences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "base/random.hpp"
#include "support/rounds.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Diff : public testing::Test {
 protected:
  [[nodiscard]] boost::json::object json(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"diff", "old.ttl", "new.ttl", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return boost::json::parse(program_.run(arguments).out).as_object();
  }
  const Program program_;
};

TEST_F(Diff, NamesAxiomsAnnotationsAndConsequencesWithTheirReasons) {
  program_.turtle("old.ttl",
                  ":A rdfs:subClassOf :B .\n:B rdfs:subClassOf :C .\n:C rdfs:label \"c\" .\n:D rdfs:subClassOf :A .\n");
  program_.turtle("new.ttl",
                  ":A rdfs:subClassOf :B .\n:B rdfs:subClassOf :E .\n:C rdfs:label \"see\" .\n:D rdfs:subClassOf :A "
                  ".\n:C rdfs:subClassOf :D .");
  const Outcome outcome = program_.run({"diff", "old.ttl", "new.ttl"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.out,
            "Axioms: 1 removed, 2 added\n"
            "  - e:B SubClassOf e:C   [old.ttl:3]\n"
            "  + e:B SubClassOf e:E   [new.ttl:3]\n"
            "  + e:C SubClassOf e:D   [new.ttl:6]\n"
            "Annotations: 1 removed, 1 added\n"
            "  - e:C rdfs:label \"c\"\n"
            "  + e:C rdfs:label \"see\"\n"
            "Names: 0 removed, 1 added\n"
            "  + http://e/E\n"
            "Subsumptions of classes that both have: 3 removed, 3 added\n"
            "  - e:B is subsumed by e:C\n"
            "      because e:B SubClassOf e:C   [old.ttl:3]  (-)\n"
            "  - and 2 that follow from these: --all\n"
            "  + e:C is subsumed by e:D\n"
            "      because e:C SubClassOf e:D   [new.ttl:6]  (+)\n"
            "  + and 2 that follow from these: --all\n");
  const boost::json::object found = json();
  EXPECT_EQ(found.at("subsumptions").at("lost").as_array().size(), 3U);
  EXPECT_EQ(found.at("subsumptions").at("gained").at(0).at("axioms").at(0).at("different"), true);
  EXPECT_EQ(found.at("names").at("added").at(0), "http://e/E");
  EXPECT_EQ(found.at("annotations").at("added").at(0), "e:C rdfs:label \"see\"");
}

TEST_F(Diff, SeesNoDifferenceInOrderSyntaxAndLabels) {
  program_.turtle(
      "old.ttl",
      ":A rdfs:subClassOf [ owl:intersectionOf ( :B :C ) ] . :i :p _:x . _:x a :A . :p a owl:ObjectProperty .");
  program_.write("new.ofn",
                 "Prefix(:=<http://e/>) Ontology(Declaration(ObjectProperty(:p)) ClassAssertion(:A _:other) "
                 "ObjectPropertyAssertion(:p :i _:other) SubClassOf(:A ObjectIntersectionOf(:C :B)))");
  const Outcome outcome = program_.run({"diff", "old.ttl", "new.ofn"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "Both say the same.\n");
}

TEST_F(Diff, SeesNoDifferenceBetweenFormsOfOneLiteral) {
  program_.turtle(
      "old.ttl",
      "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> . :d a owl:DatatypeProperty . :i :d \"x\"^^xsd:string , "
      "\"y\"@EN ; rdfs:label \"x\"^^xsd:string , \"y\"@EN , \"z\" .");
  program_.write(
      "new.ofn",
      "Prefix(:=<http://e/>) Ontology(Declaration(DataProperty(:d)) DataPropertyAssertion(:d :i \"x\") "
      "DataPropertyAssertion(:d :i \"y@en\"^^rdf:PlainLiteral) AnnotationAssertion(rdfs:label :i \"x\") "
      "AnnotationAssertion(rdfs:label :i \"y\"@En) AnnotationAssertion(rdfs:label :i \"z@\"^^rdf:PlainLiteral))");
  EXPECT_EQ(program_.run({"diff", "old.ttl", "new.ofn"}).out, "Both say the same.\n");
}

TEST_F(Diff, SeesNoDifferenceBetweenFormsOfOneAxiom) {
  program_.write("old.ofn",
                 "Prefix(:=<http://e/>) Ontology(EquivalentClasses(:A :B ObjectSomeValuesFrom(:p :C)) "
                 "SameIndividual(:i :j :k) EquivalentObjectProperties(:p :q :r) "
                 "ObjectPropertyAssertion(ObjectInverseOf(:p) :i :j) "
                 "InverseObjectProperties(ObjectInverseOf(:p) ObjectInverseOf(:s)))");
  EXPECT_EQ(program_.run({"convert", "old.ofn", "-o", "new.ttl"}).status, 0);
  EXPECT_EQ(program_.run({"diff", "old.ofn", "new.ttl"}).out, "Both say the same.\n");
}

TEST_F(Diff, SeesWhichOfSeveralEquivalencesIsLost) {
  const auto differences = [&](std::string_view before, std::string_view after) {
    const std::string head = "Prefix(:=<http://e/>) Ontology(Declaration(Class(:A)) ";
    program_.write("old.ofn", head + std::string(before) + ")");
    program_.write("new.ofn", head + std::string(after) + ")");
    const std::string text = program_.run({"diff", "old.ofn", "new.ofn"}).out;
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(differences("EquivalentClasses(:A :B :C)", "EquivalentClasses(:B :A)"), "Axioms: 1 removed, 0 added");
  EXPECT_EQ(differences("EquivalentClasses(:A :B :C)", "EquivalentClasses(:B :C) EquivalentClasses(:A :C)"),
            "Both say the same.");
  EXPECT_EQ(differences("EquivalentClasses(:A :B) EquivalentClasses(:B :C)",
                        "EquivalentClasses(:A :B) EquivalentClasses(:B :C) EquivalentClasses(:A :C)"),
            "Axioms: 0 removed, 1 added")
      << "what is stated, and not what follows";
  EXPECT_EQ(differences("SameIndividual(:i _:x) SameIndividual(:j _:y)", "SameIndividual(:i :j :k)"),
            "Axioms: 2 removed, 1 added");
  EXPECT_EQ(
      differences("SameIndividual(:i _:x) SameIndividual(:j _:y) SameIndividual(:k _:z)",
                  "SameIndividual(:i _:x) SameIndividual(:j _:y) SameIndividual(:k _:z) SameIndividual(:i :j :k)"),
      "Axioms: 0 removed, 1 added")
      << "anonymous individuals are alike and not the same";
}

TEST_F(Diff, TellsWhichClassesCanHaveNoInstanceAndWhereAnOntologyContradictsItself) {
  program_.turtle("old.ttl", ":A rdfs:subClassOf :B . :B owl:disjointWith :C .");
  program_.turtle("new.ttl", ":A rdfs:subClassOf :B, :C .\n:B owl:disjointWith :C .");
  EXPECT_THAT(program_.run({"diff", "old.ttl", "new.ttl"}).out,
              HasSubstr("Classes that can have no instance: 0 removed, 1 added\n  + e:A can have no instance\n"));
  EXPECT_THAT(program_.run({"diff", "new.ttl", "old.ttl"}).out,
              HasSubstr("Classes that can have no instance: 1 removed, 0 added\n  - e:A can have no instance\n"));
  program_.turtle("new.ttl", ":i a :B, :C . :B owl:disjointWith :C .");
  EXPECT_THAT(program_.run({"diff", "old.ttl", "new.ttl"}).out, HasSubstr("new.ttl contradicts itself"));
}

TEST_F(Diff, ReadsWhatBothImportWithBoth) {
  program_.turtle("old.ttl", ":A rdfs:subClassOf :B .");
  program_.turtle("new.ttl", ":A rdfs:subClassOf :B . :B rdfs:subClassOf :D .");
  program_.turtle("core.ttl", ":D rdfs:subClassOf :E . :A rdfs:subClassOf :D .");
  const Outcome outcome = program_.run({"diff", "old.ttl", "new.ttl", "--with", "core.ttl", "--all"});
  EXPECT_THAT(outcome.out, HasSubstr("+ e:B is subsumed by e:E\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("e:A is subsumed")));
}

TEST_F(Diff, EndsWithTwoWhereAFileCannotBeRead) {
  program_.turtle("old.ttl", ":A rdfs:subClassOf :B .");
  program_.write("new.ttl", "@prefix : <http://e/> .\n:A :p");
  const Outcome broken = program_.run({"diff", "old.ttl", "new.ttl"});
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.err, HasSubstr("new.ttl:2"));
  EXPECT_THAT(broken.out, IsEmpty());
  EXPECT_EQ(program_.run({"diff", "old.ttl", "nowhere.ttl"}).status, 2);
}

const std::string nothing = "http://www.w3.org/2002/07/owl#Nothing";

std::set<std::string> closure_lines(const Program& program, const std::string& file) {
  std::istringstream out(program.run({"classify", "--closure", file}).out);
  std::set<std::string> lines;
  for (std::string line; std::getline(out, line);) lines.insert(line);
  return lines;
}

/// Random inclusions among few classes, so that some follow from others.
std::string random_lines(base::Random& random, std::size_t count) {
  const auto name = [&] { return ":C" + std::to_string(random.below(12)); };
  std::string lines;
  for (std::size_t at = 0; at < count; ++at) {
    const std::string sub = name();
    const std::string some = "[ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom " + name() + " ]";
    lines += random.chance(0.1) ? sub + " owl:disjointWith " + name() + " .\n"
                                : sub + " rdfs:subClassOf " + (random.chance(0.3) ? some : name()) + " .\n";
    if (random.chance(0.2))
      lines += sub + " owl:equivalentClass [ owl:intersectionOf ( " + name() + ' ' + some + " ) ] .\n";
  }
  return lines;
}

TEST_F(Diff, OfRandomOntologiesHasWhatTheirClosuresDifferIn) {
  std::size_t differences = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed) {
    base::Random random(seed);
    const std::string common = ":p a owl:ObjectProperty .\n" + random_lines(random, 12);
    program_.turtle("old.ttl", common + random_lines(random, 3));
    program_.turtle("new.ttl", common + random_lines(random, 3));
    const auto before = closure_lines(program_, "old.ttl");
    const auto after = closure_lines(program_, "new.ttl");
    const auto found = json();
    for (const auto& [key, in, other, names] :
         {std::tuple("gained", &after, &before, "added"), std::tuple("lost", &before, &after, "removed")}) {
      std::set<std::string> told;
      for (const char* list : {"subsumptions", "unsatisfiable"}) {
        for (const auto& one : found.at(list).at(key).as_array())
          told.insert(std::string(one.at("sub").as_string()) + '\t' + std::string(one.at("super").as_string()));
      }
      std::set<std::string> unknown;
      for (const auto& name : found.at("names").at(names).as_array()) unknown.insert(std::string(name.as_string()));
      std::set<std::string> expected;
      for (const std::string& line : *in) {
        const std::string sub = line.substr(0, line.find('\t'));
        const std::string super = line.substr(line.find('\t') + 1);
        const bool is_new = unknown.contains(sub) && (super != nothing || key == std::string("lost"));
        const bool was_empty = other->contains(sub + '\t' + nothing);
        if (!other->contains(line) && !is_new && !unknown.contains(super) && !was_empty) expected.insert(line);
      }
      EXPECT_EQ(told, expected) << "seed " << seed << ' ' << key;
      differences += told.size();
    }
  }
  EXPECT_GT(differences, test::rounds(20U));
}

}  // namespace
}  // namespace geminga::ontology
