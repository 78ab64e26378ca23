// A compiled file instead of its sources: the same answers, changed sources, and damage.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <filesystem>

#include "reasoning/compiled/ontology.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The output without the first line, which counts triples only of sources, and with paths relative to the folder.
std::string findings(const Program& program, std::string text) {
  text.erase(0, text.find('\n') + 1);
  const std::string folder = (program.folder() / "in").lexically_normal().string() + '/';
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  return text;
}

TEST(CompiledFile, IsCheckedWithTheSameFindingsAsItsSources) {
  const Program program;
  program.turtle("a.ttl",
                 ":r a owl:TransitiveProperty .\n:A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :r ; "
                 "owl:maxCardinality 2 ] , :B .\n:A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :r ; "
                 "owl:someValuesFrom :E ] , "
                 "[ a owl:Restriction ; owl:onProperty :r ; owl:someValuesFrom :F ] , "
                 "[ a owl:Restriction ; owl:onProperty :r ; owl:someValuesFrom :G ] .\n"
                 ":E owl:disjointWith :F , :G . :F owl:disjointWith :G .\n:B owl:newInOwl3 :C .\n:D "
                 "rdfs:subClassOf :B , [ owl:complementOf :B ] .\n");
  ASSERT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga"}).status, 0);
  const Outcome of_sources = program.run({"check", "a.ttl"});
  const Outcome of_compiled = program.run({"check", "a.geminga"});
  EXPECT_EQ(of_sources.status, 1);
  EXPECT_EQ(of_compiled.status, 1) << of_compiled.err;
  EXPECT_THAT(of_compiled.out, AllOf(HasSubstr("1 file, 6 classes, 11 axioms\n"), HasSubstr("Incomplete: "),
                                     HasSubstr("e:A SubClassOf e:r max 2"), HasSubstr("owl:newInOwl3: 1, first at ")));
  EXPECT_EQ(findings(program, of_compiled.out), findings(program, of_sources.out));
}

TEST(CompiledFile, IsCompleteWhereItsSourcesAre) {
  const Program program;
  ASSERT_EQ(program.run({"compile", shipped(), "-o", "team.geminga"}).status, 0);
  const Outcome outcome = program.run({"check", "--json", "team.geminga"});
  EXPECT_EQ(outcome.status, 0) << outcome.out;
  const auto found = boost::json::parse(outcome.out).as_object();
  EXPECT_EQ(found.at("complete"), true);
  EXPECT_EQ(found.at("problem"), false);
  EXPECT_FALSE(found.contains("triples"));
}

TEST(CompiledFile, IsExplained) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n:B rdfs:subClassOf :C .\n");
  ASSERT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga"}).status, 0);
  const Outcome outcome = program.run({"explain", "a.geminga", "--sub", "e:A", "--super", "e:C"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("e:A SubClassOf e:B"), HasSubstr("a.ttl:3")));
}

TEST(CompiledFile, KnowsItsSourcesWhereverBothAreMoved) {
  const Program program;
  const fs::path in = program.folder() / "in";
  fs::create_directories(in / "robot" / "team");
  program.turtle("robot/team/a.ttl", ":A rdfs:subClassOf :B .\n");
  ASSERT_EQ(program.run({"compile", "robot/team/a.ttl", "-o", "robot/a.geminga"}).status, 0);
  ASSERT_EQ(program.run({"compile", (in / "robot" / "team" / "a.ttl").string(), "-o", "robot/b.geminga"}).status, 0);
  EXPECT_EQ(program.read("robot/a.geminga"), program.read("robot/b.geminga")) << "however the source was named";
  fs::rename(in / "robot", in / "other");
  EXPECT_EQ(program.run({"check", "other/a.geminga"}).status, 0);
  program.turtle("other/team/a.ttl", ":A rdfs:subClassOf :C .\n");
  const Outcome outgrown = program.run({"check", "other/a.geminga"});
  EXPECT_EQ(outgrown.status, 1);
  EXPECT_THAT(outgrown.out, AllOf(HasSubstr("Older than its sources: "), HasSubstr("other/team/a.ttl has changed")));
  const Outcome unexplained = program.run({"explain", "other/a.geminga", "--sub", "e:A", "--super", "e:B"});
  EXPECT_EQ(unexplained.status, 2);
  EXPECT_THAT(unexplained.err, HasSubstr("a.ttl has changed since this was compiled: compile it again"));
}

TEST(CompiledFile, IsRefusedWhereAnySectionIsDamaged) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B ; rdfs:label \"a\" .\n");
  ASSERT_EQ(program.run({"compile", "a.ttl", "-o", "a.geminga"}).status, 0);
  const std::string whole = program.read("a.geminga");
  for (const std::size_t at : {std::size_t{8}, std::size_t{100}, whole.size() - 1}) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    program.write("damaged.geminga", damaged);
    const Outcome checked = program.run({"check", "damaged.geminga"});
    EXPECT_EQ(checked.status, 1) << at;
    EXPECT_THAT(checked.err, AllOf(HasSubstr("damaged.geminga: "), HasSubstr("compile it again"))) << at;
    const Outcome explained = program.run({"explain", "damaged.geminga", "--sub", "e:A", "--super", "e:B"});
    EXPECT_EQ(explained.status, 2) << at;
    EXPECT_THAT(explained.err, HasSubstr("compile it again")) << at;
    EXPECT_THAT(explained.out, Not(HasSubstr("SubClassOf"))) << at;
  }
}

}  // namespace
}  // namespace geminga::ontology
