// The compiled file: whole or not there at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "reasoning/compiled/ontology.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> files_in(const Program& program) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(program.folder() / "in"))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

TEST(Compile, WritesWhatTheDaemonMaps) {
  const Program program;
  const Outcome outcome = program.run({"compile", shipped(), "-o", "team.gmo"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, testing::ContainsRegex("^geminga-ontology: read [0-9]+ files in 1 folder: [0-9]+ Turtle"));
  EXPECT_THAT(files_in(program), testing::ElementsAre("team.gmo"));
  const auto ontology = compiled::Ontology::map((program.folder() / "in" / "team.gmo").string());
  ASSERT_TRUE(ontology) << ontology.error().text;
  const auto ball = ontology->find("soccer:BallInfo");
  const auto top = ontology->find("geminga:Concept");
  ASSERT_TRUE(ball && top);
  EXPECT_TRUE(ontology->is_subsumed(*ball, *top));
}

TEST(Compile, GivesTheSameBytesForTheSameInputAndReplacesTheOldFile) {
  const Program program;
  program.write("a.gmo", "something old");
  EXPECT_EQ(program.run({"compile", shipped(), "-o", "a.gmo"}).status, 0);
  EXPECT_EQ(program.run({"compile", "--output", "b.gmo", shipped()}).status, 0);
  EXPECT_FALSE(program.read("a.gmo").empty());
  EXPECT_EQ(program.read("a.gmo"), program.read("b.gmo"));
}

TEST(Compile, LeavesTheOldFileWhereTheNewOntologyIsBroken) {
  const Program program;
  program.write("out.gmo", "something old");
  program.turtle("bad.ttl", ":A rdfs:subClassOf\n");
  const Outcome outcome = program.run({"compile", "bad.ttl", "-o", "out.gmo"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, StartsWith("geminga-ontology: bad.ttl:3: "));
  EXPECT_EQ(program.read("out.gmo"), "something old");
  EXPECT_THAT(files_in(program), testing::ElementsAre("bad.ttl", "out.gmo"));
}

TEST(Compile, NeverReplacesItsSources) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  const std::string before = program.read("a.ttl");
  std::filesystem::create_directory(program.folder() / "in" / "team");
  for (const std::string source : {"a.ttl", "."}) {
    const Outcome outcome = program.run({"compile", source, "-o", "team/../a.ttl"});
    EXPECT_EQ(outcome.status, 2) << source;
    EXPECT_THAT(
        outcome.err,
        testing::EndsWith("geminga-ontology: team/../a.ttl is one of the sources: name another file behind -o\n"));
    EXPECT_EQ(program.read("a.ttl"), before) << source;
  }
}

TEST(Compile, SaysWhereItCannotWrite) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  const Outcome nowhere = program.run({"compile", "a.ttl", "-o", "nowhere/out.gmo"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_EQ(nowhere.err, "geminga-ontology: nowhere/out.gmo cannot be written: No such file or directory\n");
  const Outcome device = program.run({"compile", "a.ttl", "-o", "/dev/null"});
  EXPECT_EQ(device.status, 2);
  EXPECT_THAT(device.err, HasSubstr("/dev/null is not a regular file"));
  EXPECT_THAT(files_in(program), testing::ElementsAre("a.ttl"));
}

TEST(Compile, KeepsASymbolicLinkAndReplacesTheFileBehindIt) {
  const Program program;
  const std::filesystem::path folder = program.folder() / "in";
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  program.write("releases/first.gmo", "");
  std::filesystem::create_symlink("releases/first.gmo", folder / "current.gmo");
  std::filesystem::create_symlink("current.gmo", folder / "robot.gmo");
  std::filesystem::create_symlink("releases/next.gmo", folder / "dangling.gmo");
  std::filesystem::create_symlink("circle.gmo", folder / "circle.gmo");
  for (const auto& [link, file] :
       {std::pair("robot.gmo", "releases/first.gmo"), {"dangling.gmo", "releases/next.gmo"}}) {
    const Outcome outcome = program.run({"compile", "a.ttl", "-o", link});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_symlink(folder / link)) << link;
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "current.gmo"));
    EXPECT_FALSE(std::filesystem::is_symlink(folder / file));
    EXPECT_TRUE(compiled::Ontology::map((folder / file).string())) << file;
  }
  const Outcome circle = program.run({"compile", "a.ttl", "-o", "circle.gmo"});
  EXPECT_EQ(circle.status, 2);
  EXPECT_THAT(circle.err, HasSubstr("circle.gmo cannot be written: Too many levels of symbolic links"));
}

TEST(Compile, RemarksOnWhatAStarterShouldKnow) {
  const Program program;
  program.turtle("a.ttl",
                 "<http://e/o> a owl:Ontology ; owl:imports <http://e/nowhere> .\n:A rdfs:subClassOf :B, [ "
                 "owl:complementOf :B ] .\n");
  const Outcome outcome = program.run({"compile", "a.ttl", "-o", "out.gmo"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "geminga-ontology: a.ttl:2: imports <http://e/nowhere>, which no given file answers: name its file, too\n"
            "geminga-ontology: e:A can have no instance\n");
}

TEST(Compile, WithTooLittleMemoryFailsAsAWhole) {
  const Program program;
  std::string triples;
  for (int i = 0; i < 200'000; ++i)
    triples += "<http://e/C" + std::to_string(i) + "> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/C" +
               std::to_string(i / 3) + "> .\n";
  program.write("large.nt", triples);
  const Outcome outcome = program.run({"compile", "large.nt", "-o", "out.gmo", "--memory-limit", "96"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(files_in(program), testing::ElementsAre("large.nt"));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose shadow memory is beyond any such limit
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("memory"));
#endif
}

}  // namespace
}  // namespace geminga::ontology
