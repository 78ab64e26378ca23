// Answers to "is A subsumed by B", and why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

class Explain : public testing::Test {
 protected:
  Explain() {
    program_.turtle("a.ttl",
                    ":A rdfs:subClassOf :B ,\n :X .\n:B rdfs:subClassOf :C .\n:C rdfs:label \"the third\" .\n"
                    ":N rdfs:subClassOf :B, [ owl:complementOf :B ] .\n");
  }
  const Program program_;
};

TEST_F(Explain, SubsumesSaysYesAndNo) {
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "<http://e/C>"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "the third"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "e:A"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:A", "--super", "owl:Thing"}).status, 0);
  EXPECT_EQ(program_.run({"subsumes", "a.ttl", "--sub", "e:N", "--super", "e:X"}).status, 0);
  const Outcome no = program_.run({"subsumes", "a.ttl", "--sub", "http://e/C", "--super", "e:A"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(no.out, "e:C is not subsumed by e:A\n");
}

TEST_F(Explain, PrintsExactlyTheAxiomsThatAreNeeded) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "e:A is subsumed by e:C, because:\ne:A SubClassOf e:B   [a.ttl:2]\ne:B SubClassOf e:C   [a.ttl:4]\n");
}

TEST_F(Explain, SaysWhenNothingEntailsIt) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:C", "--super", "e:A"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "e:C is not subsumed by e:A\n");
}

TEST_F(Explain, JsonNamesAxiomsWithTheirPlaces) {
  const Outcome outcome = program_.run({"explain", "a.ttl", "--sub", "e:A", "--super", "e:C", "--json"});
  const boost::json::value found = boost::json::parse(outcome.out);
  EXPECT_EQ(found.at("entailed"), true);
  EXPECT_EQ(found.at("sub"), "http://e/A");
  EXPECT_EQ(found.at("axioms").at(1).at("file"), "a.ttl");
  EXPECT_EQ(found.at("axioms").at(1).at("line"), 4);
  const Outcome no = program_.run({"explain", "a.ttl", "--sub", "e:C", "--super", "e:A", "--json"});
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(boost::json::parse(no.out).at("entailed"), false);
}

}  // namespace
}  // namespace geminga::ontology
