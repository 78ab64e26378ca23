// Tasks and their roles in files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;

constexpr const char* head =
    "@prefix c: <https://geminga.example/capability#> . @prefix : <http://e/> . @prefix owl: "
    "<http://www.w3.org/2002/07/owl#> .\n";

class TaskFile : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& name) const {
    return program_.run({"task", name, shipped() + "/capability.ttl"});
  }
  const Program program_;
};

TEST_F(TaskFile, HasRolesWithAClassOrATextInAnySyntax) {
  program_.write("task.ttl", std::string(head) + R"(
:t a c:Task ; c:prefer "battery desc" ; c:hasRole :one , [ c:expression "hasPart some Arm" ] .
:one a c:Role ; c:count 2 ; c:shared true ; c:where "battery >= 30 %" ;
  c:heldBy [ a c:Robot , [ a owl:Restriction ; owl:onProperty c:hasPart ; owl:someValuesFrom c:Gripper ] ] .
)");
  const Outcome turtle = run("task.ttl");
  EXPECT_EQ(turtle.status, 0) << turtle.err;
  const std::string words = "<https://geminga.example/capability#";
  EXPECT_THAT(turtle.out, HasSubstr(R"("name":":t","prefer":"battery desc")"));
  EXPECT_THAT(turtle.out, HasSubstr("\"expression\":\"" + words + "Robot> and (" + words + "hasPart> some " + words +
                                    "Gripper>)\",\"where\":\"battery >= 30 %\",\"count\":2,\"shared\":true"));
  EXPECT_THAT(turtle.out, HasSubstr(R"("expression":"hasPart some Arm","where":"","count":1,"shared":false)"));
  for (const std::string name : {"task.omn", "task.owx", "task.rdf", "task.ofn"}) {
    ASSERT_EQ(program_.run({"merge", "task.ttl", shipped() + "/capability.ttl", "-o", name}).status, 0);
    const Outcome other = program_.run({"task", name});
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_THAT(other.out, HasSubstr("hasPart some Arm")) << name;
  }
}

TEST_F(TaskFile, ThatIsWrongIsRefusedWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {":t a c:Task .", "task.ttl:2: the task has no role"},
      {":t a c:Task ;\n c:hasRole :r .\n:r a c:Role .", "task.ttl:4: the role ':r' does not say who may hold it"},
      {":t a c:Task ; c:hasRole :r .\n:r c:expression \"A\" ; c:heldBy [ a c:Robot ] .",
       "task.ttl:3: the role ':r' says twice who may hold it"},
      {":t a c:Task ; c:hasRole :r .\n:r c:expression \"A\" ;\n c:count 0 .",
       "task.ttl:4: capability:count is '0': write a whole number from 1"},
      {":t a c:Task ; c:hasRole :r .\n:r c:expression \"A\" ;\n c:shared \"perhaps\" .",
       "task.ttl:4: capability:shared is 'perhaps': write true or false"},
      {":t a c:Task ; c:hasRole :r .\n:r c:expression \"A\" , \"B\" .",
       "task.ttl:3: capability:expression is stated twice"},
      {":t a c:Task ; c:hasRole :r .\n:r c:heldBy [ a c:Robot ; c:hasPart [ a c:Arm ] ] .",
       "task.ttl:3: a holder is described by its classes alone"},
      {":t a c:Task ; c:hasRole :r .\n:r c:heldBy [ ] .", "task.ttl:3: "},
      {":t a c:Task ;\n c:hazRole :r .", "task.ttl:3: c:hazRole is declared in no file"},
      {":r a c:Role .", "task.ttl: has no task: state an individual"},
      {":t a c:Task ; ;; .", "task.ttl:2"},
  };
  for (const auto& [text, error] : cases) {
    program_.write("task.ttl", head + text + "\n");
    const Outcome outcome = run("task.ttl");
    EXPECT_EQ(outcome.status, 2) << text;
    EXPECT_THAT(outcome.err, HasSubstr(error)) << text;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(run("nowhere.ttl").status, 2);
}

}  // namespace
}  // namespace geminga::ontology
