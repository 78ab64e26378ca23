// The lint of ontologies, rule by rule.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

/// An ontology without any finding: `more` is added to it.
constexpr std::string_view faultless =
    "<http://e/o> a owl:Ontology . "
    ":A a owl:Class ; rdfs:label \"a\" ; rdfs:comment \"the first\" . "
    ":B a owl:Class ; rdfs:label \"b\" ; rdfs:comment \"the second\" ; rdfs:subClassOf :A . "
    ":p a owl:ObjectProperty ; rdfs:label \"p\" ; rdfs:comment \"relates\" ; rdfs:domain :A .\n";

class Report : public testing::Test {
 protected:
  /// "LINE LEVEL CODE" of each finding.
  [[nodiscard]] std::vector<std::string> found_in(const std::string& more) const {
    program_.turtle("a.ttl", std::string(faultless) + more);
    const Outcome outcome = program_.run({"report", "a.ttl", "--json"});
    std::vector<std::string> found;
    const boost::json::object document = boost::json::parse(outcome.out).as_object();
    for (const auto& one : document.at("findings").as_array())
      found.push_back(std::to_string(one.at("line").to_number<int>()) + ' ' + std::string(one.at("level").as_string()) +
                      ' ' + std::string(one.at("code").as_string()));
    return found;
  }
  const Program program_;
};

TEST_F(Report, FindsNothingInAFaultlessOntology) {
  EXPECT_THAT(found_in(""), IsEmpty());
  EXPECT_EQ(program_.run({"report", "a.ttl"}).out, "0 errors, 0 warnings, 0 remarks\n");
  EXPECT_EQ(program_.run({"report", "a.ttl", "--fail-on", "info"}).status, 0);
}

struct RuleCase {
  std::string more;
  std::string finding;
};

class ReportRule : public Report, public testing::WithParamInterface<RuleCase> {};

TEST_P(ReportRule, FindsItsFaultAtItsPlace) {
  EXPECT_THAT(found_in(GetParam().more), IsSupersetOf({GetParam().finding}));
}

const std::string described = "rdfs:label \"of its own\" ; rdfs:comment \"told\" ";

INSTANTIATE_TEST_SUITE_P(
    Rules, ReportRule,
    testing::Values(RuleCase{":i a :A, [ owl:complementOf :A ] .", "0 error contradiction"},
                    RuleCase{"\n:X a owl:Class ; " + described + "; rdfs:subClassOf :A, [ owl:complementOf :A ] .",
                             "4 error unsatisfiable"},
                    RuleCase{":B owl:disjointWhit :A .", "3 error unknown-word"},
                    RuleCase{":B rdfs:subClassOf :Aa .", "3 error undeclared"},
                    RuleCase{":p a owl:DatatypeProperty .", "3 error two-kinds"},
                    RuleCase{":A rdfs:subClassOf :B .", "3 warning cycle"},
                    RuleCase{":A rdfs:subClassOf :A .", "3 warning cycle"},
                    RuleCase{":X a owl:Class ; rdfs:comment \"told\" ; rdfs:subClassOf :A .", "3 warning no-label"},
                    RuleCase{":X a owl:Class ; rdfs:label \"a\" ; rdfs:comment \"told\" ; rdfs:subClassOf :A .",
                             "3 warning same-label"},
                    RuleCase{":X a owl:Class ; rdfs:label \"x  y\" ; rdfs:comment \"told\" ; rdfs:subClassOf :A .",
                             "3 warning odd-label"},
                    RuleCase{":A owl:deprecated true .", "2 warning deprecated"},
                    RuleCase{":X a owl:Class ; " + described + ".", "3 warning unused"},
                    RuleCase{":X a owl:Class ; " + described + ". :Y rdfs:subClassOf :X .", "0 info several-roots"},
                    RuleCase{":C a owl:Class ; " + described + "; rdfs:subClassOf :B .\n:C rdfs:subClassOf :A .",
                             "4 info superfluous"},
                    RuleCase{":X a owl:Class ; " + described + "; owl:equivalentClass :B .", "3 info synonyms"},
                    RuleCase{":X a owl:Class ; rdfs:label \"x\" ; rdfs:subClassOf :A .", "3 info no-definition"},
                    RuleCase{":q a owl:ObjectProperty ; " + described +
                                 ". :B rdfs:subClassOf [ owl:onProperty :q ; "
                                 "owl:someValuesFrom :A ] .",
                             "3 info no-domain-or-range"}));

TEST_F(Report, NamesFilesWithoutAnOntologyName) {
  program_.turtle("n.ttl", ":A rdfs:subClassOf :B .");
  EXPECT_THAT(program_.run({"report", "n.ttl"}).out,
              HasSubstr("n.ttl:1: warning: the ontology of this file has no name"));
}

TEST_F(Report, FailsOnTheLevelThatIsWanted) {
  program_.turtle("a.ttl", std::string(faultless) + ":X a owl:Class ; rdfs:label \"x\" ; rdfs:subClassOf :A .");
  EXPECT_EQ(program_.run({"report", "a.ttl"}).status, 0);
  EXPECT_EQ(program_.run({"report", "a.ttl", "--fail-on", "warning"}).status, 0);
  const Outcome failing = program_.run({"report", "a.ttl", "--fail-on", "info"});
  EXPECT_EQ(failing.status, 1);
  EXPECT_EQ(failing.out,
            "a.ttl:3: info: class e:X has no comment or definition [no-definition]\n0 errors, 0 warnings, 1 remark\n");
  EXPECT_EQ(program_.run({"report", "a.ttl", "--fail-on", "info", "--ignore", "no-definition"}).status, 0);
  EXPECT_EQ(program_.run({"report", "a.ttl", "--fail-on", "info", "--level", "warning"}).status, 0);
}

TEST_F(Report, LeavesNamesOfOtherOntologiesAlone) {
  const auto found = found_in(":B rdfs:subClassOf <http://other/C> ; <http://purl.org/dc/terms/creator> \"me\" .");
  EXPECT_THAT(found, testing::ElementsAre("0 info several-roots"));
}

TEST_F(Report, RefusesRulesThatItDoesNotHave) {
  program_.turtle("a.ttl", faultless);
  const Outcome outcome = program_.run({"report", "a.ttl", "--ignore", "no-lable"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no-lable is no rule"));
  EXPECT_EQ(program_.run({"report"}).status, 2);
  EXPECT_EQ(program_.run({"report", "nowhere.ttl"}).status, 2);
  const Outcome rules = program_.run({"report", "--rules"});
  EXPECT_EQ(rules.status, 0);
  EXPECT_THAT(rules.out, AllOf(HasSubstr("no-label\twarning\t"), Not(HasSubstr("  "))));
}

}  // namespace
}  // namespace geminga::ontology
