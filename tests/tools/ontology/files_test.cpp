// Packed files, folders of folders, and names without their prefixes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <iterator>
#include <string>

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

/// A folder of two good files and one with an entity that nothing declares.
void write_broken_team(const Program& program) {
  std::filesystem::create_directories(program.folder() / "team");
  program.turtle("team/a.ttl", ":A a owl:Class ; rdfs:subClassOf :B . :x a :A .");
  program.turtle("yes.ttl", ":A rdfs:subClassOf :C .");
  program.turtle("no.ttl", ":C rdfs:subClassOf :A .");
  program.turtle("all.ttl", ":A a owl:Class ; rdfs:subClassOf :B . :x a :A . :B rdfs:subClassOf :C .");
  program.turtle("team/c.ttl", ":B a owl:Class ; rdfs:subClassOf :C . :C a owl:Class .");
  program.write("team/b.owl",
                "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
                "<rdf:Description rdf:about=\"&nothing;A\"/></rdf:RDF>");
}

TEST(Folders, LoseABrokenFileAndNothingElse) {
  const Program program;
  write_broken_team(program);
  const Outcome classified = program.run({"classify", "--closure", "team"});
  EXPECT_EQ(classified.status, 1);
  EXPECT_EQ(classified.out, "http://e/A\thttp://e/B\nhttp://e/A\thttp://e/C\nhttp://e/B\thttp://e/C\n");
  EXPECT_THAT(classified.err, HasSubstr("left out: team/b.owl:2: Entity 'nothing' not defined"));
  const Outcome checked = program.run({"check", "team"});
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.out,
              HasSubstr("Files that cannot be read (the rest is checked without them):\n  team/b.owl:2: "));
  EXPECT_THAT(program.run({"check", "team", "--json"}).out,
              HasSubstr("\"refused\":[{\"file\":\"team/b.owl\",\"line\":2,"));
}

/// A command that only reads, its exit status and a part of its output where a file of the folder is broken.
struct Tolerant {
  std::vector<std::string> command;
  int status;
  std::string out;
};

std::vector<Tolerant> tolerant_commands() {
  return {
      {{"classify", "team"}, 1, "e:A\n"},
      {{"check", "team"}, 1, "3 classes"},
      {{"realize", "team"}, 1, "e:x: e:A\n"},
      {{"draw", "team", "--format", "dot"}, 1, "e:A"},
      {{"report", "team", "--fail-on", "none"}, 1, ""},
      {{"consistent", "team"}, 2, ""},
      {{"consistent", "team", "--json"}, 2, "{\"consistent\":null,\"reason\":\"a file cannot be read: team/b.owl:2"},
      {{"instances", "team", "C"}, 0, "e:x\n"},
      {{"instances", "team", "not C"}, 2, ""},
      {{"query", "team", "SELECT ?x { ?x a :C }"}, 0, "e:x\n"},
      {{"query", "team", "ASK { :A rdfs:subClassOf :C }"}, 0, "yes\n"},
      {{"query", "team", "ASK { :C rdfs:subClassOf :A }"}, 2, "no\n"},
      {{"subsumes", "team", "--sub", "A", "--super", "C"}, 0, "is subsumed by"},
      {{"subsumes", "team", "--sub", "C", "--super", "A"}, 1, "is not known to be subsumed by"},
      {{"explain", "team", "--sub", "A", "--super", "C"}, 0, "because"},
      {{"explain", "team", "--sub", "C", "--super", "A"}, 1, "is not known to be subsumed by"},
      {{"explain", "team", "--inconsistent"}, 1, "is not known to contradict itself: a file cannot be read"},
      {{"repair", "team"}, 2, "nothing to take out"},
      {{"repair", "team", "--sub", "A", "--super", "C"}, 0, "SubClassOf"},
      {{"entails", "team", "yes.ttl"}, 0, "The axiom follows"},
      {{"entails", "team", "no.ttl"}, 2, "is not decided"},
      {{"entails", "yes.ttl", "team"}, 1, "does not follow"},
      {{"entails", "all.ttl", "team"}, 2, "follows: "}};
}

TEST(Folders, LoseABrokenFileInEveryCommandThatOnlyReads) {
  const Program program;
  write_broken_team(program);
  for (const Tolerant& one : tolerant_commands()) {
    const Outcome outcome = program.run(one.command);
    const std::string name = testing::PrintToString(one.command);
    EXPECT_EQ(outcome.status, one.status) << name << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(one.out)) << name;
    EXPECT_THAT(outcome.err, HasSubstr("left out: team/b.owl:2: Entity 'nothing' not defined")) << name;
  }
  program.turtle("team/d.ttl", ":x a owl:Nothing .");
  EXPECT_EQ(program.run({"consistent", "team"}).status, 1) << "no other file can undo a contradiction";
}

TEST(Folders, AreRefusedWithABrokenFileByCommandsThatWriteOrCompare) {
  const Program program;
  write_broken_team(program);
  const std::vector<std::string> commands[] = {
      {"compile", "team", "-o", "out.geminga"},  {"infer", "team", "-o", "out.ttl"}, {"merge", "team", "-o", "out.ttl"},
      {"extract", "team", "A", "-o", "out.ttl"}, {"diff", "team", "yes.ttl"},        {"align", "team", "yes.ttl"},
      {"id", "A", "--ontology", "team"}};
  for (const std::vector<std::string>& command : commands) {
    const Outcome outcome = program.run(command);
    EXPECT_EQ(outcome.status, 2) << command.front();
    EXPECT_THAT(outcome.err, HasSubstr("team/b.owl:2: ")) << command.front();
    EXPECT_THAT(outcome.out, IsEmpty()) << command.front();
  }
}

TEST(Folders, AreRefusedWithABrokenFileWhereThatIsAskedFor) {
  const Program program;
  write_broken_team(program);
  for (Tolerant& one : tolerant_commands()) {
    one.command.emplace_back("--strict");
    const Outcome outcome = program.run(one.command);
    const std::string& command = one.command.front();
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_THAT(outcome.out, testing::AnyOf(IsEmpty(), HasSubstr("{\"error\":"))) << command;
    EXPECT_THAT(outcome.err, HasSubstr("team/b.owl:2: ")) << command;
  }
  EXPECT_EQ(program.run({"classify", "team/b.owl"}).status, 2) << "named itself";
  EXPECT_EQ(program.run({"check", "team/b.owl"}).status, 1) << "named itself";
}

TEST(Check, RemarksWhatCostsNoAxiom) {
  const Program program;
  program.write("a.ofn",
                "Ontology(SubClassOf(<http://e/A> ObjectIntersectionOf(<http://e/B>))\n"
                "Declaration(Class(<http://e/A>)) Declaration(Class(<http://e/B>)))");
  const Outcome outcome = program.run({"check", "a.ofn"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("Read otherwise than written:\n"
                        "  ObjectIntersectionOf of one operand, read as that operand: 1, first at a.ofn:1"));
  EXPECT_THAT(outcome.out, HasSubstr("Complete: "));
}

TEST(Graphs, OfSeveralFilesAreReadAsOne) {
  const Program program;
  std::filesystem::create_directories(program.folder() / "in" / "team");
  const std::string sub = " <http://www.w3.org/2000/01/rdf-schema#subClassOf> ";
  program.turtle("team/a.trig", ":g { :A rdfs:subClassOf :B }");
  program.write("team/b.nq", "<http://e/B>" + sub + "<http://e/C> <http://e/g> .\n");
  EXPECT_THAT(program.run({"classify", "--closure", "team"}).out, HasSubstr("http://e/A\thttp://e/C\n"));
  const Outcome checked = program.run({"check", "team"});
  EXPECT_THAT(checked.out, HasSubstr("graphs of TriG or N-Quads, read as one graph"));
  EXPECT_EQ(program.run({"query", "team", "ASK { :A rdfs:subClassOf :C }"}).out, "yes\n");
  EXPECT_EQ(program.run({"query", "--asserted", "team", "ASK { :A rdfs:subClassOf :B }"}).out, "yes\n");
}

TEST(Careless, OutputsSpareTheSources) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class .");
  const std::string before = program.read("a.ttl");
  const Outcome outcome = program.run({"classify", "a.ttl", "--stats", "a.ttl"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "geminga-ontology: a.ttl is one of the sources: name another file behind --stats\n");
  EXPECT_EQ(program.read("a.ttl"), before);
}

TEST(Careless, AFileThatIsNotThereIsNamedAndNoNameOfTheOntology) {
  const Program program;
  program.turtle("a.ttl", ":A a owl:Class .");
  EXPECT_EQ(program.run({"extract", "nowhere.ttl", ":A", "-o", "o.ttl"}).err,
            "geminga-ontology: nowhere.ttl: cannot be opened: No such file or directory\n");
  EXPECT_THAT(program.run({"extract", "a.ttl", "nowhere.ttl", ":A", "-o", "o.ttl"}).err,
              HasSubstr("nowhere.ttl: cannot be opened"));
}

TEST(Careless, AFileThatWouldBeTooLongIsNotWritten) {
  const Program program;
  std::string classes;
  for (int number = 0; number < 100; ++number) classes += ":A" + std::to_string(number) + " a owl:Class .\n";
  program.turtle("a.ttl", classes);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const Outcome outcome = program.run({"convert", "a.ttl", "-o", "b.ttl"});
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "geminga-ontology: b.ttl cannot be written: File too large\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(program.folder() / "in"), {}), 1) << "nothing is left";
}

TEST(Hostile, ANameWithTheEndOfALineStaysInItsLine) {
  const Program program;
  program.turtle("a\nb.ttl", ":A a owl:Class .");
  EXPECT_THAT(program.run({"check", "a\nb.ttl"}).out, HasSubstr("\n  a?b.ttl\n"));
}

TEST(Hostile, AFileOfAMarkAloneIsEmpty) {
  const Program program;
  program.write("a.ttl", "\xff\xfe");
  program.write("a.owl", "\xff\xfe");
  EXPECT_EQ(program.run({"check", "a.ttl"}).status, 0);
  EXPECT_EQ(program.run({"check", "a.owl"}).err, "geminga-ontology: a.owl: is empty\n");
}

}  // namespace
}  // namespace geminga::ontology
