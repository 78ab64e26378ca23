// Help, versions, and wrong command lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(CommandLine, HelpShowsEveryCommandWithExamples) {
  const Program program;
  const Outcome help = program.run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.err, IsEmpty());
  EXPECT_THAT(help.out, HasSubstr("Examples:"));
  for (const char* command :
       {"check", "classify", "subsumes", "entails", "consistent", "explain", "id", "compile", "draw"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    const Outcome own = program.run({command, "--help"});
    EXPECT_EQ(own.status, 0) << command;
    EXPECT_THAT(own.out, HasSubstr("Example")) << command;
  }
}

TEST(CommandLine, VersionIsOneLine) {
  const Outcome version = Program().run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("geminga-ontology [0-9.]+ .compiled ontologies [0-9]+.\n"));
  EXPECT_THAT(version.out, EndsWith("\n"));
}

TEST(CommandLine, WrongUsageIsStatusTwoAndOneLine) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"frobnicate"},
      {"check"},
      {"check", "--frobnicate", "a.ttl"},
      {"classify", "a.ttl", "--threads", "0"},
      {"classify", "a.ttl", "--threads", "-1"},
      {"classify", "a.ttl", "--threads", "257"},
      {"classify", "a.ttl", "--threads", "4294967297"},
      {"classify", "a.ttl", "--threads", "1x"},
      {"classify", "a.ttl", "--threads", ""},
      {"classify", "a.ttl", "--closure", "--json"},
      {"subsumes", "a.ttl", "--sub", "e:A"},
      {"subsumes", "a.ttl", "--sub", "e:A", "--super", "e:Nope"},
      {"subsumes", "a.ttl", "--sub", "nope:A", "--super", "e:A"},
      {"explain", "a.ttl", "--sub", "e:A"},
      {"id"},
      {"id", "a", "b", "c"},
      {"compile", "a.ttl"},
      {"compile", "a.ttl", "-o", "x", "--memory-limit", "95"},
      {"compile", "a.ttl", "-o", "x", "--time-limit", "0"},
      {"draw", "a.ttl", "--format", "png"},
      {"draw", "a.ttl", "--root", "e:Nope"},
      {"check", "missing.ttl"},
      {"classify", "missing.ttl"},
  };
  for (const auto& arguments : wrong) {
    const Outcome outcome = program.run(arguments);
    const std::string line = testing::PrintToString(arguments);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_THAT(outcome.out, IsEmpty()) << line;
    EXPECT_THAT(outcome.err, StartsWith("geminga-ontology: ")) << line;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << line << outcome.err;
  }
}

TEST(CommandLine, TakesFlagsAndFilesInAnyOrder) {
  const Program program;
  program.turtle("a.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("b.ttl", ":B rdfs:subClassOf :C .\n");
  const std::vector<std::vector<std::string>> orders{
      {"subsumes", "a.ttl", "b.ttl", "--sub", "e:A", "--super", "e:C"},
      {"subsumes", "--sub", "e:A", "a.ttl", "--super", "e:C", "b.ttl"},
      {"subsumes", "--sub=e:A", "--super=e:C", "a.ttl", "b.ttl"},
      {"subsumes", "--sub=e:A", "--super=e:C", "."},
  };
  for (const auto& arguments : orders) {
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.status, 0) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "e:A is subsumed by e:C\n");
  }
}

TEST(CommandLine, ABrokenFileIsNamedWithItsLineByEveryCommand) {
  const Program program;
  program.turtle("good.ttl", ":A rdfs:subClassOf :B .\n");
  program.turtle("bad.ttl", ":A rdfs:subClassOf :B .\n:A rdfs:subClassOf nonsense .\n");
  const std::vector<std::vector<std::string>> commands{{"classify"},
                                                       {"subsumes", "--sub", "e:A", "--super", "e:B"},
                                                       {"explain", "--sub", "e:A", "--super", "e:B"},
                                                       {"compile", "-o", "out"},
                                                       {"draw"}};
  for (std::vector<std::string> arguments : commands) {
    arguments.insert(arguments.end(), {"good.ttl", "bad.ttl"});
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, StartsWith("geminga-ontology: bad.ttl:3: "));
  }
}

}  // namespace
}  // namespace geminga::ontology
