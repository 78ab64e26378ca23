// The findings of check that only a limit shows.
#include "ontology/findings/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "base/budget.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;

/// A contradiction of facts, and so many classes beside an unsatisfiable one.
std::string contradicting(std::size_t classes) {
  std::string text = ":A owl:disjointWith :B . :E rdfs:subClassOf :A , :B . :i a :E .\n";
  for (std::size_t number = 0; number < classes; ++number) {
    const std::string name = ":C" + std::to_string(number);
    text +=
        name + " rdfs:subClassOf :A , [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom " + name + " ] .\n";
  }
  return text + ":p a owl:ObjectProperty .\n";
}

/// The findings of a file as JSON, where so many steps are left for what classification does not find.
std::string found(const Program& program, std::uint64_t steps) {
  auto classified = classify_files({program.folder() / "in" / "a.ttl"}, {.as_json = true});
  if (!classified) return classified.error().text;
  const auto ontology = compile_or_say(*classified);
  if (!ontology) return "not compiled";
  base::Budget budget(steps);
  return as_json(find(*classified, *ontology, budget));
}

TEST(Findings, SayWhetherTheSearchWithoutFactsEndedEarly) {
  const Program program;
  program.turtle("a.ttl", contradicting(2'000));
  const std::string whole = found(program, base::Budget::unlimited);
  EXPECT_THAT(whole, HasSubstr(R"("unsatisfiable_is_whole":true)"));
  EXPECT_THAT(whole, HasSubstr(R"({"class":"e:E")"));
  EXPECT_THAT(found(program, 1), HasSubstr(R"("unsatisfiable_is_whole":false)"));
}

TEST(Findings, OfACompiledContradictionAreNotWhole) {
  const Program program;
  program.turtle("a.ttl", contradicting(1));
  ASSERT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga"}).status, 0);
  EXPECT_THAT(program.run({"check", "--json", "a.geminga"}).out, HasSubstr(R"("unsatisfiable_is_whole":false)"));
  EXPECT_THAT(program.run({"check", "a.geminga"}).out,
              HasSubstr("There may be more classes that can have no instance"));
  EXPECT_THAT(program.run({"check", "--json", "a.ttl"}).out, HasSubstr(R"("unsatisfiable_is_whole":true)"));
}

TEST(Findings, WithoutAContradictionAreWhole) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B . :i a :A .\n");
  const std::string document = program.run({"check", "--json", "a.ttl"}).out;
  EXPECT_THAT(document, HasSubstr(R"("unsatisfiable_is_whole":true)"));
  EXPECT_THAT(document, HasSubstr(R"("collisions_is_whole":true)"));
}

}  // namespace
}  // namespace geminga::ontology
