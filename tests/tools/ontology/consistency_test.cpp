// Consistency in the output of all commands: one answer, which is yes, no or unknown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The documents of all commands that tell of the consistency of `file`.
std::vector<std::vector<std::string>> commands_about(const std::string& file) {
  return {{"consistent", file, "--json"}, {"check", file, "--json"},          {"classify", file, "--json"},
          {"realize", file, "--json"},    {"instances", file, "A", "--json"}, {"repair", file, "--json"}};
}

void expect_consistency(const Program& program, const std::string& file, const boost::json::value& expected) {
  for (const std::vector<std::string>& command : commands_about(file)) {
    const Outcome outcome = program.run(command);
    const boost::json::value document = boost::json::parse(outcome.out);
    EXPECT_EQ(document.at("consistent"), expected) << file << ' ' << command.front() << ' ' << outcome.out;
    EXPECT_EQ(document.as_object().contains("reason"), expected.is_null()) << file << ' ' << command.front();
  }
  const Outcome diff = program.run({"diff", file, file, "--json"});
  EXPECT_EQ(boost::json::parse(diff.out).at("consistent").at("after"), expected) << file;
}

std::string functional(const std::string& axioms) {
  return "Prefix(:=<http://e/>)\nOntology(<http://e/o>\nDeclaration(Class(:A)) Declaration(ObjectProperty(:p))\n"
         "Declaration(DataProperty(:d)) ClassAssertion(:A :i)\n" +
         axioms + "\n)\n";
}

TEST(Consistency, IsUnknownInEveryDocumentWhereSomethingWasLeftOutThatCanContradict) {
  const Program program;
  program.write("unused.ofn", functional("TransitiveObjectProperty(:p) AsymmetricObjectProperty(:p)\n"
                                         "DLSafeRule(Body(ObjectPropertyAtom(:p Variable(:x) Variable(:y))) Head())"));
  program.write("unread.ofn", functional("SubClassOf(:A ObjectSomeOddFrom(:p :A))"));
  program.write("rule.ofn", functional("DataPropertyAssertion(:d :i \"1\")\nDLSafeRule(Body(DataPropertyAtom(:d "
                                       "Variable(:x) Variable(:v)) BuiltInAtom(:odd Variable(:v))) Head())"));
  for (const std::string file : {"unused.ofn", "unread.ofn", "rule.ofn"}) {
    expect_consistency(program, file, nullptr);
    EXPECT_THAT(program.run({"check", file}).out, HasSubstr("Not decided: whether the files contradict themselves.\n"));
  }
  EXPECT_EQ(program.run({"compile", "unused.ofn", "-o", "unused.geminga"}).status, 0);
  const Outcome compiled = program.run({"check", "unused.geminga", "--json"});
  EXPECT_TRUE(boost::json::parse(compiled.out).at("consistent").is_null()) << compiled.out;
}

TEST(Consistency, IsKnownInEveryDocumentWhereItIs) {
  const Program program;
  program.write("yes.ofn", functional("ObjectPropertyDomain(:p :A)"));
  program.write("no.ofn", functional("SubClassOf(:A owl:Nothing)"));
  // Any value of the datatype has a model.
  program.write("repaired.ofn", functional("DataPropertyAssertion(:d :i \"x\"^^xsd:integer)"));
  expect_consistency(program, "yes.ofn", true);
  expect_consistency(program, "no.ofn", false);
  expect_consistency(program, "repaired.ofn", true);
  EXPECT_THAT(program.run({"check", "yes.ofn"}).out, Not(HasSubstr("Not decided")));
  EXPECT_EQ(program.run({"compile", "yes.ofn", "-o", "yes.geminga"}).status, 0);
  const Outcome compiled = program.run({"check", "yes.geminga", "--json"});
  EXPECT_EQ(boost::json::parse(compiled.out).at("consistent"), true) << compiled.out;
}

TEST(Consistency, IsUnknownWhereALimitWasReached) {
  const Program program;
  program.write("a.ofn", functional("SubClassOf(:A ObjectUnionOf(:B ObjectSomeValuesFrom(:p :A)))"));
  for (const std::string command : {"consistent", "check", "classify"}) {
    const Outcome outcome = program.run({command, "a.ofn", "--json", "--steps", "1"});
    EXPECT_EQ(outcome.status, 4) << command;
    EXPECT_TRUE(boost::json::parse(outcome.out).at("consistent").is_null()) << command << outcome.out;
  }
}

}  // namespace
}  // namespace geminga::ontology
