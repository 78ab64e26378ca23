// Packed files, folders of folders, and names without their prefixes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"
#include "reasoning/syntax/rdf/packed.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::string_view prefixes =
    "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . ";

/// A folder with folders: Ball below Object, and Object below Thing of another file, which is packed.
void write_team(const Program& program) {
  std::filesystem::create_directories(program.folder() / "in" / "team" / "below" / "deep");
  program.turtle("team/soccer.ttl", ":Ball a owl:Class ; rdfs:subClassOf :Object .");
  program.write("team/below/core.ttl.gz",
                rdf::packed(std::string(prefixes) + ":Object a owl:Class ; rdfs:subClassOf :Tracked ."));
  program.write("team/below/deep/more.ofn", "Ontology(Declaration(Class(<http://e/Other>)))");
  program.write("team/README.md", "hello");
}

TEST(Folders, AreWalkedAndSayWhatWasReadAndWhatWasSkipped) {
  const Program program;
  write_team(program);
  const Outcome outcome = program.run({"classify", "--closure", "team"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out,
            "http://e/Ball\thttp://e/Object\nhttp://e/Ball\thttp://e/Tracked\nhttp://e/Object\thttp://e/Tracked\n");
  EXPECT_EQ(outcome.err,
            "geminga-ontology: read 3 files in 3 folders: 1 OWL functional syntax, 2 Turtle; skipped 1 other: "
            "team/README.md\n");
  EXPECT_THAT(program.run({"classify", "team/soccer.ttl"}).err, IsEmpty());
}

TEST(Folders, AreCompiledWithTheirPackedFilesWithoutAWordToTheDaemon) {
  const Program program;
  write_team(program);
  const Outcome outcome = program.run({"compile", "team", "-o", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, Not(HasSubstr("read 3 files")));
  EXPECT_EQ(program.run({"compile", "team", "-o", "team.geminga"}).status, 0);
  EXPECT_EQ(program.run({"explain", "team.geminga", "--sub", "Ball", "--super", "Tracked"}).status, 0)
      << "the packed file has not changed since";
}

TEST(Names, NeedNoPrefixWhereTheyAreUnique) {
  const Program program;
  write_team(program);
  EXPECT_EQ(program.run({"subsumes", "team", "--sub", "Ball", "--super", "Tracked"}).status, 0);
  EXPECT_EQ(program.run({"subsumes", "team", "--sub", "Tracked", "--super", "Ball"}).status, 1);
  EXPECT_EQ(program.run({"explain", "team", "--sub", "Ball", "--super", "Tracked"}).status, 0);
}

TEST(Names, ThatSeveralClassesHaveAreRefusedWithAllOfThem) {
  const Program program;
  program.turtle("a.ttl",
                 "@prefix f: <http://f/> . @prefix g: <http://g#> . :Ball a owl:Class . f:Ball a owl:Class . "
                 "g:Ball a owl:Class . :A a owl:Class ; rdfs:label \"the ball\" . :B a owl:Class ; rdfs:label \"the "
                 "ball\" .");
  const Outcome outcome = program.run({"subsumes", "a.ttl", "--sub", "Ball", "--super", "A"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "geminga-ontology: 'Ball' may be e:Ball, f:Ball or g:Ball: say which\n");
  EXPECT_EQ(program.run({"subsumes", "a.ttl", "--sub", "the ball", "--super", "A"}).err,
            "geminga-ontology: 'the ball' may be e:A or e:B: say which\n");
  EXPECT_EQ(program.run({"subsumes", "a.ttl", "--sub", "f:Ball", "--super", "A"}).status, 1);
}

}  // namespace
}  // namespace geminga::ontology
