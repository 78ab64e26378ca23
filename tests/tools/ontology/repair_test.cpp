// The least sets of axioms to take out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Repair : public testing::Test {
 protected:
  [[nodiscard]] boost::json::object json(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"repair", "a.ttl", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return boost::json::parse(program_.run(arguments).out).as_object();
  }
  const Program program_;
};

TEST_F(Repair, NamesEachChoiceWithItsPlaceAndItsLoss) {
  program_.turtle("a.ttl", ":A rdfs:subClassOf :B ,\n  :C .\n:B owl:disjointWith :C .\n:D rdfs:subClassOf :A .\n");
  const Outcome outcome = program_.run({"repair", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "2 classes can have no instance.\n"
            "Any of these choices, taken out, mends it; the best is first:\n"
            "  1. e:B DisjointWith e:C   [a.ttl:4]\n"
            "     loses no other subsumption of named classes\n"
            "  2. e:A SubClassOf e:B   [a.ttl:2]\n"
            "     loses 2 subsumptions, such as\n"
            "       e:A SubClassOf e:B\n"
            "  3. e:A SubClassOf e:C   [a.ttl:3]\n"
            "     loses 2 subsumptions, such as\n"
            "       e:A SubClassOf e:C\n"
            "No file was changed.\n");
  EXPECT_THAT(program_.read("a.ttl"), HasSubstr(":D rdfs:subClassOf :A"));
}

TEST_F(Repair, WhatSharesNoReasonIsAGroupOfItsOwn) {
  program_.turtle("a.ttl",
                  ":A rdfs:subClassOf :B, :C . :B owl:disjointWith :C .\n"
                  ":X rdfs:subClassOf :Y, [ owl:complementOf :Y ] .\n");
  const boost::json::object found = json();
  ASSERT_EQ(found.at("groups").as_array().size(), 2U);
  EXPECT_EQ(found.at("groups").at(0).at("choices").as_array().size(), 3U);
  EXPECT_EQ(found.at("groups").at(1).at("choices").as_array().size(), 2U);
  EXPECT_EQ(found.at("groups").at(1).at("subs").at(0), "http://e/X");
  EXPECT_EQ(found.at("certain"), true);
}

TEST_F(Repair, AChoiceHasAnAxiomOfEachReason) {
  program_.turtle("a.ttl", ":A rdfs:subClassOf :B, :C, :D .\n:B owl:disjointWith :C .\n:B owl:disjointWith :D .\n");
  const boost::json::object found = json();
  const boost::json::array& choices = found.at("groups").at(0).at("choices").as_array();
  ASSERT_EQ(choices.size(), 5U);
  EXPECT_EQ(choices.at(0).at("axioms").as_array().size(), 1U);
  EXPECT_EQ(choices.at(0).at("axioms").at(0).at("axiom"), "e:A SubClassOf e:B");
  EXPECT_EQ(choices.at(1).at("axioms").as_array().size(), 2U);
}

TEST_F(Repair, UndoesAContradictionFirst) {
  program_.turtle("a.ttl", ":i a :A ,\n  :B .\n:A owl:disjointWith :B .\n:C rdfs:subClassOf :A, :B .\n");
  const Outcome outcome = program_.run({"repair", "a.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("The ontology contradicts itself.\n"),
                                 HasSubstr("e:i Type e:A   [a.ttl:2]"), HasSubstr("e:A DisjointWith e:B   [a.ttl:4]")));
}

TEST_F(Repair, UndoesASubsumptionThatIsNotWanted) {
  program_.turtle("a.ttl", ":A rdfs:subClassOf :B .\n:B rdfs:subClassOf :C .\n:A rdfs:subClassOf :C .\n");
  const boost::json::object found = json({"--sub", "e:A", "--super", "e:C"});
  // It follows in two ways, which share no axiom.
  ASSERT_EQ(found.at("groups").as_array().size(), 2U);
  EXPECT_EQ(found.at("groups").at(0).at("choices").as_array().size(), 1U);
  EXPECT_EQ(found.at("groups").at(0).at("choices").at(0).at("loses"), 0);
  EXPECT_EQ(found.at("groups").at(1).at("choices").as_array().size(), 2U);
  EXPECT_EQ(found.at("groups").at(1).at("choices").at(0).at("loses"), 1);
  EXPECT_EQ(program_.run({"repair", "a.ttl", "--sub", "e:C", "--super", "e:A"}).status, 1);
  EXPECT_EQ(program_.run({"repair", "a.ttl", "--sub", "e:C"}).status, 2);
}

TEST_F(Repair, AnAxiomThatStandsInTwoFilesIsNamedInBoth) {
  const std::string head = "Prefix(:=<http://e/>) Ontology(\n";
  program_.write("a.ofn", head + "SubClassOf(:A :B)\nSubClassOf(:A :C)\nDisjointClasses(:B :C))\n");
  program_.write("b.ofn", head + "\nSubClassOf(:A :B))\n");
  const Outcome outcome = program_.run({"repair", "a.ofn", "b.ofn"});
  EXPECT_THAT(outcome.out, HasSubstr("SubClassOf :B   [a.ofn:2]\n     :A SubClassOf :B   [b.ofn:3]\n"));
}

TEST_F(Repair, SaysWhenNothingIsToBeMended) {
  program_.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  const Outcome outcome = program_.run({"repair", "a.ttl"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("nothing to take out"));
}

TEST_F(Repair, ShowsAsManyChoicesAsAreAskedFor) {
  program_.turtle("a.ttl", ":A rdfs:subClassOf :B, :C . :B owl:disjointWith :C .\n");
  for (const std::size_t limit : {2U, 3U, 4U}) {
    const boost::json::object found = json({"--limit", std::to_string(limit)});
    const boost::json::value& group = found.at("groups").at(0);
    EXPECT_EQ(group.at("choices").as_array().size(), std::min<std::size_t>(limit, 3));
    EXPECT_EQ(group.at("may_have_more"), limit < 3);
  }
}

}  // namespace
}  // namespace geminga::ontology
