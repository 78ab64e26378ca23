// Pictures in the languages of Graphviz and Mermaid.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Draw : public testing::Test {
 protected:
  Draw() {
    program_.turtle("a.ttl",
                    ":B rdfs:subClassOf :A . :C owl:equivalentClass :B . :D rdfs:subClassOf :C . :Z a owl:Class .\n");
  }
  const Program program_;
};

TEST_F(Draw, DotHasOneBoxForEquivalentsAndAnEdgeToEachParent) {
  const Outcome outcome = program_.run({"draw", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("digraph taxonomy {\n"));
  EXPECT_THAT(outcome.out, HasSubstr("c0 [label=\"e:A\"];\n"));
  EXPECT_THAT(outcome.out, HasSubstr("c1 [label=\"e:B\\n= e:C\""));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("c1 -> c0;\n"), HasSubstr("c3 -> c1;\n"), HasSubstr("\"e:Z\"")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("owl:")));
}

TEST_F(Draw, RootLeavesOnlyWhatIsBelowIt) {
  const Outcome outcome = program_.run({"draw", "--root", "e:C", "a.ttl"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("e:B"), HasSubstr("e:D"), Not(HasSubstr("e:A")), Not(HasSubstr("e:Z"))));
}

TEST_F(Draw, DepthHidesWhatIsDeeperAndSaysHowMuch) {
  const Outcome outcome = program_.run({"draw", "a.ttl", "--depth", "1"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("e:A"), HasSubstr("e:Z"), Not(HasSubstr("e:B")), Not(HasSubstr("e:D"))));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("below_c0 [label=\"\xe2\x80\xa6 3 more\""), HasSubstr("below_c0 -> c0 [")));
  EXPECT_THAT(program_.run({"draw", "a.ttl", "--depth", "2", "--root", "e:A"}).out, Not(HasSubstr("more")));
}

TEST_F(Draw, UnsatisfiableClassesStandInTheirOwnColourWhereTheirAxiomsPutThem) {
  program_.turtle("b.ttl",
                  ":B rdfs:subClassOf :A . :N rdfs:subClassOf :B, [ owl:complementOf :B ] . :M rdfs:subClassOf :N .\n");
  const Outcome outcome = program_.run({"draw", "b.ttl", "--root", "e:B"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("[label=\"e:N\", fillcolor=\"#f9dcd6\""), HasSubstr("[label=\"e:M\", fill"),
                                 HasSubstr("c3 -> c1;\n"), HasSubstr("c2 -> c3;\n"), Not(HasSubstr("e:A"))));
  EXPECT_THAT(program_.run({"draw", "b.ttl", "--format", "mermaid"}).out, HasSubstr("  class c2,c3 unsatisfiable\n"));
}

TEST_F(Draw, LongNamesAreBrokenAndKeptWholeBeside) {
  program_.turtle("b.ttl", ":AVeryLongNameForAClassThatNeedsTwoLines a owl:Class .\n");
  EXPECT_THAT(program_.run({"draw", "b.ttl"}).out,
              HasSubstr("[label=\"e:AVeryLongNameFor\\nAClassThatNeedsTwo\\nLines\", "
                        "tooltip=\"e:AVeryLongNameForAClassThatNeedsTwoLines\"]"));
}

TEST_F(Draw, CompactListsLeavesOfOneParent) {
  program_.turtle("b.ttl", ":B rdfs:subClassOf :A . :C rdfs:subClassOf :A . :D rdfs:subClassOf :A .\n");
  const Outcome outcome = program_.run({"draw", "b.ttl", "--compact"});
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("leaves_c0 [label=\"e:B,  e:C,  e:D\\l\""), HasSubstr("leaves_c0 -> c0;")));
}

TEST_F(Draw, CompactListsALeafBelowEachOfItsParents) {
  program_.turtle("b.ttl",
                  ":B rdfs:subClassOf :A , :Z . :C rdfs:subClassOf :A . :D rdfs:subClassOf :A .\n"
                  ":X rdfs:subClassOf :Z . :Y rdfs:subClassOf :Z , :W .\n");
  // :Y is also below :W, which has no list. So the list below :Z would have two leaves, which are too few.
  const Outcome without = program_.run({"draw", "b.ttl", "--compact"});
  EXPECT_THAT(without.out, Not(HasSubstr("leaves_")));
  program_.turtle("c.ttl",
                  ":B rdfs:subClassOf :A , :Z . :C rdfs:subClassOf :A . :D rdfs:subClassOf :A .\n"
                  ":X rdfs:subClassOf :Z . :Y rdfs:subClassOf :Z .\n");
  const Outcome with = program_.run({"draw", "c.ttl", "--compact"});
  EXPECT_THAT(with.out, AllOf(HasSubstr("[label=\"e:B,  e:C,  e:D\\l\""), HasSubstr("[label=\"e:B,  e:X,  e:Y\\l\"")));
}

TEST_F(Draw, MermaidIsAGraphOfTheSameBoxes) {
  const Outcome outcome = program_.run({"draw", "a.ttl", "--format", "mermaid"});
  EXPECT_THAT(outcome.out, StartsWith("graph RL\n"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("c1[\"e:B<br/>= e:C\"]\n"), HasSubstr("c1 --> c0\n")));
}

TEST_F(Draw, NamesCannotBreakOutOfTheirBoxes) {
  program_.turtle("b.ttl", "<http://f/a\\\"];x[\\\"> rdfs:subClassOf <http://f/b> .\n");
  program_.write("c.owl",
                 "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
                 "xmlns:owl=\"http://www.w3.org/2002/07/owl#\"><owl:Class rdf:about='http://f/a\"];b[\"'/></rdf:RDF>");
  EXPECT_THAT(program_.run({"draw", "c.owl"}).out, HasSubstr("[label=\"<http://f/a\\\"];b[\\\">\"];\n"));
  EXPECT_THAT(program_.run({"draw", "c.owl", "--format", "mermaid"}).out,
              HasSubstr("[\"#60;http://f/a#34;]#59;b[#34;#62;\"]\n"));
}

TEST_F(Draw, SvgComesFromGraphvizOrSaysThatItIsMissing) {
  const Outcome outcome = program_.run({"draw", "a.ttl", "--format", "svg"});
  if (outcome.status == 0) {
    EXPECT_THAT(outcome.out, HasSubstr("<svg"));
    EXPECT_THAT(outcome.out, HasSubstr("e:D"));
  } else {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("install graphviz, or ask for --format dot"));
  }
}

TEST(DrawOfContradiction, SaysThatThePictureIsEmptyBecauseOfAContradiction) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class ; owl:disjointWith :B . :B a owl:Class . :i a :A , :B .");
  const Outcome outcome = program.run({"draw", "a.ttl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("the ontology contradicts itself"));
  EXPECT_THAT(program.run({"consistent", "a.ttl"}).out, HasSubstr("explain --inconsistent shows why"));
}

}  // namespace
}  // namespace geminga::ontology
