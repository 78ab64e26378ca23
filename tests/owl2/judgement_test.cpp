// The judge of the published cases is judged: on answers, on the table, and on a small file of the same form.
#include "owl2/judgement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "owl2/published_cases.hpp"
#include "owl2/question.hpp"

namespace geminga::owl2 {
namespace {

const Outside with_reason{{"a.consistency", "too hard"}};

TEST(Judgement, NeverPassesAWrongAnswer) {
  for (const Outside& outside : {Outside{}, with_reason}) {
    EXPECT_FALSE(judge("a.consistency", true, 1, outside).is_passed);
    EXPECT_FALSE(judge("a.consistency", false, 0, outside).is_passed);
  }
}

TEST(Judgement, PassesARightAnswerOnlyWhereTheTableDoesNotDenyIt) {
  EXPECT_TRUE(judge("a.consistency", true, 0, {}).is_passed);
  EXPECT_TRUE(judge("a.consistency", false, 1, {}).is_passed);
  EXPECT_FALSE(judge("a.consistency", true, 0, with_reason).is_passed);
  EXPECT_FALSE(judge("a.consistency", false, 1, with_reason).is_passed);
}

TEST(Judgement, PassesNoAnswerOnlyWithAReason) {
  for (const int status : {2, -1, 4, 139}) {
    EXPECT_FALSE(judge("a.consistency", true, status, {}).is_passed) << status;
    EXPECT_TRUE(judge("a.consistency", true, status, with_reason).is_passed) << status;
    EXPECT_FALSE(judge("b.consistency", true, status, with_reason).is_passed) << status;
  }
}

TEST(TableOfThoseOutside, IsReadLineByLine) {
  EXPECT_EQ(read_outside("# name\treason\n\na.consistency\ttoo hard\n").value(), with_reason);
  EXPECT_EQ(read_outside("a\tx\nb\n").error(), "line 2: not NAME<TAB>REASON");
  EXPECT_EQ(read_outside("a\tx\na\ty\n").error(), "line 2: a second time the same name");
}

class Scratch {
 public:
  Scratch() {
    std::string name = std::filesystem::temp_directory_path() / "geminga-owl2-XXXXXX";
    path = ::mkdtemp(name.data());
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

std::string case_named(const std::string& name, const std::string& status, const std::string& type) {
  return "<t:TestCase><rdf:type rdf:resource='http://www.w3.org/2007/OWL/testOntology#" + type + "'/><t:identifier>" +
         name + "</t:identifier><t:status rdf:resource='http://www.w3.org/2007/OWL/testOntology#" + status +
         "'/><t:semantics rdf:resource='http://www.w3.org/2007/OWL/testOntology#DIRECT'/>"
         "<t:rdfXmlPremiseOntology>&lt;premise/&gt;</t:rdfXmlPremiseOntology>"
         "<t:fsPremiseOntology>Ontology()</t:fsPremiseOntology>"
         "<t:rdfXmlConclusionOntology>&lt;conclusion/&gt;</t:rdfXmlConclusionOntology></t:TestCase>";
}

std::filesystem::path written(const Scratch& scratch, const std::string& cases) {
  const auto path = scratch.path / "all.rdf";
  std::ofstream(path) << "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
                         "xmlns:t='http://www.w3.org/2007/OWL/testOntology#'>"
                      << cases << "</rdf:RDF>";
  return path;
}

TEST(PublishedCases, BecomeOneQuestionForEachTypeAndSyntax) {
  const Scratch scratch;
  const auto cases = read_published_cases(written(scratch, case_named("a b", "Approved", "PositiveEntailmentTest") +
                                                               case_named("c", "Approved", "ConsistencyTest") +
                                                               case_named("d", "Proposed", "ConsistencyTest") +
                                                               case_named("e", "Approved", "InconsistencyTest")));
  ASSERT_TRUE(cases) << cases.error();
  std::vector<std::string> asked;
  for (const Question& question : write_questions(*cases, scratch.path)) {
    asked.push_back(question.name + (question.is_yes ? " yes" : " no"));
    for (const std::string& file : question.files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  }
  EXPECT_THAT(asked, testing::ElementsAre("a-b.entailment yes", "c.consistency yes", "c.consistency.functional yes",
                                          "e.inconsistency no", "e.inconsistency.functional no"));
}

TEST(PublishedCases, OfNoXmlAreAnError) {
  const Scratch scratch;
  EXPECT_FALSE(read_published_cases(scratch.path / "none"));
  EXPECT_FALSE(read_published_cases(written(scratch, case_named("d", "Proposed", "ConsistencyTest"))));
}

}  // namespace
}  // namespace geminga::owl2
