// Answers of the commands where the engines cannot decide within their own limits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Nothing is left out, and the engines cannot decide within their limits whether :Hard has instances: 13 pigeons would
/// have to be in 12 holes.
class Undecided : public testing::Test {
 protected:
  Undecided() {
    constexpr int holes = 12;
    const auto in = [](int pigeon, int hole) { return " :p" + std::to_string(pigeon) + 'h' + std::to_string(hole); };
    std::string text = "Prefix(:=<http://e/>) Ontology(<http://e/>\n";
    for (int pigeon = 0; pigeon <= holes; ++pigeon) {
      text += "SubClassOf(:Hard ObjectUnionOf(";
      for (int hole = 0; hole < holes; ++hole) text += in(pigeon, hole);
      text += "))\n";
    }
    for (int hole = 0; hole < holes; ++hole) {
      text += "DisjointClasses(";
      for (int pigeon = 0; pigeon <= holes; ++pigeon) text += in(pigeon, hole);
      text += ")\n";
    }
    program_.write("a.ofn", text + "SubClassOf(:Easy :Above))");
  }
  [[nodiscard]] boost::json::object json(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    return boost::json::parse(program_.run(arguments).out).as_object();
  }
  const Program program_;
};

TEST_F(Undecided, ExplainSaysThatItIsNotKnownAndWhy) {
  const std::vector<std::string> question = {"explain", "a.ofn", "--sub", ":Hard", "--super", "owl:Nothing"};
  const Outcome outcome = program_.run(question);
  EXPECT_EQ(outcome.status, 1) << "as subsumes says";
  EXPECT_THAT(outcome.out, StartsWith(":Hard is not known to be subsumed by owl:Nothing: undecided: 1 class (:Hard)"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("; because "), Not(HasSubstr("left out"))));
  const boost::json::object found = json(question);
  EXPECT_TRUE(found.at("entailed").is_null());
  EXPECT_THAT(std::string(found.at("reason").as_string()), HasSubstr(":Hard"));
}

TEST_F(Undecided, ExplainAnswersWhatIsDecidedBesideIt) {
  const Outcome outcome = program_.run({"explain", "a.ofn", "--sub", ":Easy", "--super", ":Hard"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, AllOf(StartsWith(":Easy is not subsumed by :Hard\n"), Not(HasSubstr("left out"))));
  EXPECT_EQ(program_.run({"explain", "a.ofn", "--sub", ":Easy", "--super", ":Above"}).status, 0);
}

TEST_F(Undecided, ExplainSaysSoOfACompiledFile) {
  ASSERT_EQ(program_.run({"compile", "a.ofn", "-o", "a.geminga"}).status, 0);
  const auto ask = [&](const std::string& sub, const std::string& super) {
    return program_.run({"explain", "a.geminga", "--sub", sub, "--super", super}).out;
  };
  EXPECT_THAT(ask(":Hard", "owl:Nothing"), HasSubstr("is not known to be subsumed by"));
  EXPECT_THAT(ask(":Easy", ":Hard"), HasSubstr("is not subsumed by"));
}

TEST_F(Undecided, CheckNamesNoAxiomAsLeftOut) {
  const boost::json::object found = json({"check", "a.ofn"});
  EXPECT_EQ(found.at("left_out"), boost::json::array());
  EXPECT_EQ(found.at("complete"), false);
}

TEST_F(Undecided, RepairDoesNotSayThatNothingIsToBeTakenOut) {
  const Outcome any = program_.run({"repair", "a.ofn"});
  EXPECT_EQ(any.status, 2);
  EXPECT_EQ(any.out, "No class is known to have no instance.\n");
  EXPECT_THAT(any.err, HasSubstr("cannot be decided whether others have none: undecided: 1 class (:Hard)"));
  const Outcome one = program_.run({"repair", "a.ofn", "--sub", ":Hard", "--super", ":Easy"});
  EXPECT_EQ(one.status, 2);
  EXPECT_THAT(one.err, HasSubstr("cannot be decided whether it follows: undecided: 1 class (:Hard)"));
  EXPECT_EQ(program_.run({"repair", "a.ofn", "--sub", ":Easy", "--super", ":Hard"}).status, 1);
  EXPECT_EQ(json({"repair", "a.ofn"}).at("certain"), false);
}

TEST_F(Undecided, RepairOfAnotherClassSaysThatItMayNotBeAll) {
  program_.write("b.ofn", "Prefix(:=<http://e/>) Ontology(<http://b/> SubClassOf(:Easy owl:Nothing))");
  const Outcome outcome = program_.run({"repair", "a.ofn", "b.ofn"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Something unwanted may be left: undecided: 1 class (:Hard)"));
}

TEST_F(Undecided, ClassifyPrintsWhatIsKnownAndSaysWhatIsNot) {
  const Outcome outcome = program_.run({"classify", "a.ofn", "--stats", "stats.json"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(boost::json::parse(program_.read("stats.json")).at("left_out").as_int64(), testing::Gt(0));
  EXPECT_THAT(outcome.out, StartsWith("owl:Thing\n  :Above\n    :Easy\n  :Hard\n"));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("1 class (:Hard)"), HasSubstr("; because ")));
}

TEST_F(Undecided, ClassifyAndCheckNameItAlikeInJson) {
  const boost::json::object classified = json({"classify", "a.ofn"});
  const boost::json::object checked = json({"check", "a.ofn"});
  const boost::json::object& open = classified.at("undecided").as_object();
  EXPECT_EQ(open.at("classes"), boost::json::array{"http://e/Hard"});
  EXPECT_EQ(open.at("consistency"), false);
  EXPECT_EQ(open.at("held_up_by"), "http://e/Hard");
  for (const auto& member : checked.at("undecided").as_object()) EXPECT_TRUE(open.contains(member.key()));
  EXPECT_EQ(classified.at("gaps"), checked.at("gaps"));
}

TEST_F(Undecided, JsonOfClassifySaysThatNothingIs) {
  program_.write("b.ofn", "Prefix(:=<http://e/>) Ontology(SubClassOf(:Easy :Above))");
  const boost::json::object classified = json({"classify", "b.ofn"});
  EXPECT_EQ(classified.at("undecided").at("classes"), boost::json::array());
  EXPECT_EQ(classified.at("gaps"), boost::json::array());
}

}  // namespace
}  // namespace geminga::ontology
