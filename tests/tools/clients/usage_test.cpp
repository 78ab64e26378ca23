// Help, versions, mistakes, and a daemon that is missing or does not answer, with every program.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> programs{"geminga-query", "geminga-publish", "geminga-subscribe"};

/// Runs a program without any daemon.
Outcome run(const std::string& program, const std::vector<std::string>& words) {
  std::vector<std::string> line{system::program(program)};
  line.insert(line.end(), words.begin(), words.end());
  const auto ran = system::run({.words = line, .environment = {{"GEMINGA_CONNECT", nobody()}}, .before = {}});
  return {ran.status, ran.said, ran.said};
}

TEST(Programs, ShowHelpWithExamples) {
  for (const auto& program : programs) {
    const auto help = run(program, {"--help"});
    EXPECT_EQ(help.status, 0) << program;
    EXPECT_THAT(help.out, HasSubstr("Examples:\n  " + program + " ")) << program;
    EXPECT_THAT(help.out, HasSubstr("--connect")) << program;
  }
  for (const char* command : {"participants", "team", "services", "requests", "match", "explain", "why", "ontology",
                              "describe", "alerts", "status", "security", "record", "replay", "top"}) {
    const auto help = run("geminga-query", {command, "--help"});
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_THAT(help.out, HasSubstr(std::string("geminga-query ") + command)) << command;
    EXPECT_THAT(run("geminga-query", {"--help"}).out, HasSubstr(command));
  }
}

TEST(Programs, ShowTheirVersion) {
  for (const auto& program : programs) {
    const auto version = run(program, {"--version"});
    EXPECT_EQ(version.status, 0) << program;
    EXPECT_THAT(version.out, StartsWith(program + " ")) << program;
  }
}

TEST(Programs, EndWithTwoOnWrongUsage) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"geminga-query", {}},
      {"geminga-query", {"physician"}},
      {"geminga-query", {"services", "--no-such-flag"}},
      {"geminga-query", {"explain", "soccer:BallInfo"}},
      {"geminga-query", {"why"}},
      {"geminga-query", {"why", "1a2b3c4d/1/1", "1a2b3c4d/1/2", "1a2b3c4d/1/3"}},
      {"geminga-query", {"why", "1a2b3c4d/1/1", "--concept", "soccer:BallInfo"}},
      {"geminga-query", {"why", "--offer-concept", "soccer:BallInfo", "--mode", "oto"}},
      {"geminga-query", {"why", "--offer-mode", "oto"}},
      {"geminga-query", {"why", "--service", "1a2b3c4d/1/1", "--offer-concept", "soccer:BallInfo"}},
      {"geminga-query", {"why", "--representation", "soccer:Pixels"}},
      {"geminga-query", {"why", "1a2b3c4d/1/1", "1a2b3c4d/1/2", "--service", "1a2b3c4d/1/2"}},
      {"geminga-query", {"why", "1a2b3c4d/1/1", "--offer-text", "x", "--offer-attribute", "rate"}},
      {"geminga-query", {"match", "soccer:BallInfo", "--id", "5"}},
      {"geminga-query", {"match", "--id", "4294967296"}},
      {"geminga-query", {"match", "--id", "five"}},
      {"geminga-query", {"match", "--representation", "soccer:Pixels"}},
      {"geminga-query", {"match", "x", "--degree", "close"}},
      {"geminga-query", {"match", "x", "--mode", "otm"}},
      {"geminga-query", {"match", "x", "--limit", "-1"}},
      {"geminga-query", {"requests", "--unmatched", "--unused"}},
      {"geminga-query", {"participants", "--missing"}},
      {"geminga-query", {"participants", "hasPart some Gripper", "--missing", "--why"}},
      {"geminga-query", {"team"}},
      {"geminga-query", {"team", "/no/such/task.ttl"}},
      {"geminga-query", {"team", "--need", ""}},
      {"geminga-query", {"team", "--need", "2:"}},
      {"geminga-query", {"team", "--need", "0: hasPart some Gripper"}},
      {"geminga-query", {"team", "--need", "257: hasPart some Gripper"}},
      {"geminga-query", {"team", "--need", "256: hasPart some Gripper", "--need", "hasPart some Arm"}},
      {"geminga-query", {"team", "--need", "hasPart some Gripper where "}},
      {"geminga-query", {"team", "--need", "hasPart some Gripper", "--prefer", "battery"}},
      {"geminga-query", {"--timeout", "soon", "status"}},
      {"geminga-query", {"--timeout", "-1", "status"}},
      {"geminga-query", {"--timeout", "nan", "status"}},
      {"geminga-query", {"--timeout", "31622401", "status"}},
      {"geminga-query", {"--connect", "robot2", "status"}},
      {"geminga-query", {"--connect", "127.0.0.1:99999", "status"}},
      {"geminga-publish", {}},
      {"geminga-publish", {"soccer:BallInfo"}},
      {"geminga-publish", {"--port", "5000"}},
      {"geminga-publish", {"soccer:BallInfo", "--port", "0"}},
      {"geminga-publish", {"soccer:BallInfo", "--port", "65536"}},
      {"geminga-publish", {"soccer:BallInfo", "--port", "5000", "rate"}},
      {"geminga-publish", {"soccer:BallInfo", "--port", "5000", "rate=1", "rate=2"}},
      {"geminga-publish", {"soccer:BallInfo", "--port", "5000", "--priority", "high"}},
      {"geminga-publish", {"--text", "a", "--id", "1", "--port", "5000"}},
      {"geminga-publish", {"rate=30", "--port", "5000"}},
      {"geminga-publish", {"text=a", "--text", "b", "--port", "5000"}},
      {"geminga-subscribe", {"soccer:BallInfo", "rate=30"}},
      {"geminga-subscribe", {}},
      {"geminga-subscribe", {"soccer:BallInfo", "--text", "ball"}},
      {"geminga-subscribe", {"soccer:BallInfo", "--degree", "very"}},
      {"geminga-subscribe", {"soccer:BallInfo", "--count", "-1"}},
      {"geminga-subscribe", {"soccer:BallInfo", "--provider", "/vision"}},
  };
  for (const auto& [program, words] : cases) {
    const auto outcome = run(program, words);
    const std::string line = program + ' ' + testing::PrintToString(words);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_THAT(outcome.errors, StartsWith(program + ": ")) << line;
    EXPECT_THAT(outcome.errors, EndsWith("\n")) << line;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << line << outcome.errors;
  }
}

TEST(Programs, NameTheFlagOrTheCommandThatMayBeMeant) {
  const std::vector<std::tuple<std::string, std::vector<std::string>, std::string>> cases{
      {"geminga-query", {"servces"}, "'servces' is no command: did you mean services? see "},
      {"geminga-query", {"--json", "statsu"}, "'statsu' is no command: did you mean status? see "},
      {"geminga-query",
       {"physician"},
       "'physician' is no command: the commands are participants, team, services, requests, match, explain, why, "
       "ontology, export, describe, status, security, doctor, alerts, mcp, record, replay, top, complete: see "},
      {"geminga-query", {"services", "--unsued"}, "'--unsued' is no flag: did you mean --unused? see "},
      {"geminga-query", {"services", "--conect", "x"}, "'--conect' is no flag: did you mean --connect? see "},
      {"geminga-query", {"match", "--limt=3"}, "'--limt' is no flag: did you mean --limit? see "},
      {"geminga-publish", {"a", "--prot", "5"}, "'--prot' is no flag: did you mean --port? see "},
      {"geminga-subscribe", {"a", "--wher", "rate > 3"}, "'--wher' is no flag: did you mean --where? see "},
      {"geminga-subscribe", {"a", "--colour"}, "'--colour' is no flag: see "},
  };
  for (const auto& [program, words, text] : cases) {
    const auto outcome = run(program, words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.errors, program + ": " + text + program + " --help\n");
  }
}

TEST(Programs, TakeNoEmptyTextOfAnEmptyVariable) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"geminga-query", {"match", ""}},
      {"geminga-query", {"match", "--concept", ""}},
      {"geminga-query", {"match", "--text", ""}},
      {"geminga-query", {"match", "concept="}},
      {"geminga-query", {"match", "text="}},
      {"geminga-query", {"match", "soccer:BallInfo", "representation="}},
      {"geminga-query", {"match", "soccer:BallInfo", "--representation", ""}},
      {"geminga-query", {"match", "soccer:BallInfo", "--where", ""}},
      {"geminga-query", {"match", "soccer:BallInfo", "--provider", ""}},
      {"geminga-query", {"match", "soccer:BallInfo", "--convert", ""}},
      {"geminga-query", {"services", ""}},
      {"geminga-query", {"services", "concept="}},
      {"geminga-query", {"requests", "text="}},
      {"geminga-query", {"explain", "soccer:BallInfo", ""}},
      {"geminga-query", {"why", ""}},
      {"geminga-query", {"why", "--concept", ""}},
      {"geminga-query", {"--connect", "", "status"}},
      {"geminga-publish", {"", "--port", "5"}},
      {"geminga-publish", {"--text", "", "--port", "5"}},
      {"geminga-publish", {"--text", "a", "--port", "5", "--for", ""}},
      {"geminga-publish", {"--text", "a", "--port", "5", "--name", ""}},
      {"geminga-publish", {"--text", "a", "--port", "5", "--address", ""}},
      {"geminga-subscribe", {""}},
      {"geminga-subscribe", {"--text", ""}},
      {"geminga-subscribe", {"text="}},
      {"geminga-subscribe", {"--text", "a", "--where", ""}},
      {"geminga-subscribe", {"--text", "a", "--name", ""}},
      {"geminga-subscribe", {"soccer:BallInfo", "--representation", ""}},
  };
  for (const auto& [program, words] : cases) {
    const auto outcome = run(program, words);
    EXPECT_EQ(outcome.status, 2) << program << testing::PrintToString(words) << outcome.errors;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
  }
  EXPECT_THAT(run("geminga-query", {"match", ""}).errors,
              HasSubstr("IDENTITY is empty: leave it out, or see whether the variable that it comes from is set"));
}

TEST(Programs, NameTheVariableThatMayBeMeant) {
  const auto ran = system::run({.words = {system::program("geminga-query"), "status"},
                                .environment = {{"GEMINGA_CONECT", nobody()}, {"GEMINGA_CONVERT", "1"}},
                                .before = {}});
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.said, HasSubstr("GEMINGA_CONECT: unknown: did you mean GEMINGA_CONNECT?"));
}

TEST(Programs, SayWhichNumbersTheyTake) {
  const std::string priority = "--priority: must be a whole number from -2147483648 to 2147483647: see ";
  const std::string limit = "--limit: must be a whole number from 0 to 4294967295: see ";
  const std::string port = "--port: must be a whole number from 1 to 65535: see ";
  const std::string count = "--count: must be a whole number from 0 to 1000000000000000: see ";
  const std::string convert =
      "--convert: must be yes, no or the largest cost, a whole number from 0 to 4294967295: see ";
  const std::vector<std::tuple<std::string, std::vector<std::string>, std::string>> cases{
      {"geminga-publish", {"--priority", "2147483648"}, priority},
      {"geminga-publish", {"--priority", "-2147483649"}, priority},
      {"geminga-publish", {"--priority", "9999999999"}, priority},
      {"geminga-publish", {"--priority", "1.5"}, priority},
      {"geminga-publish", {"--port", "0"}, port},
      {"geminga-publish", {"--port", "65536"}, port},
      {"geminga-publish", {"--name", ""}, "--name: must not be empty: see "},
      {"geminga-subscribe", {"--priority", "9999999999999999999999"}, priority},
      {"geminga-subscribe", {"--limit", "4294967296"}, limit},
      {"geminga-subscribe", {"--limit", "-1"}, limit},
      {"geminga-subscribe", {"--port", "x"}, port},
      {"geminga-subscribe", {"--count", "-1"}, count},
      {"geminga-subscribe", {"--convert", "4294967296"}, convert},
      {"geminga-subscribe", {"--name", ""}, "--name: must not be empty: see "},
      {"geminga-query", {"match", "--limit", "4294967296"}, limit},
  };
  for (const auto& [program, words, text] : cases) {
    auto line = words;
    if (program != "geminga-query") line.insert(line.begin(), {"--text", "a"});
    EXPECT_EQ(run(program, line).errors, program + ": " + text + program + " --help\n");
  }
}

TEST(Programs, EndWithThreeWhereNobodyListens) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"geminga-query", {"status"}},
      {"geminga-query", {"--watch", "services"}},
      {"geminga-publish", {"--text", "x", "--port", "5000"}},
      {"geminga-publish", {"--text", "x", "--port", "5000", "--keep"}},
      {"geminga-subscribe", {"--text", "x"}},
  };
  for (const auto& [program, words] : cases) {
    const auto outcome = run(program, words);
    EXPECT_EQ(outcome.status, 3) << program;
    EXPECT_THAT(outcome.errors, StartsWith(program + ": no daemon at 127.0.0.1:")) << program;
    EXPECT_THAT(outcome.errors, HasSubstr("start gemingad")) << program;
  }
}

TEST(Programs, EndWithFourWhereTheDaemonDoesNotAnswer) {
  // The kernel accepts the connection, and no program reads.
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(listener, 4), 0);
  ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  const std::string there = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  EXPECT_EQ(run("geminga-query", {"--connect", there, "--timeout", "0.05", "status"}).status, 4);
  EXPECT_EQ(run("geminga-publish", {"--connect", there, "--timeout", "0.05", "--text", "x", "--port", "1"}).status, 4);
  ::close(listener);
}

TEST(Programs, FindTheDaemonWhereItUsuallyIs) {
  Bench bench;
  const auto found = bench.run("geminga-query", {"participants"});
  EXPECT_EQ(found.status, 0) << found.errors;
  const std::string there = "127.0.0.1:" + std::to_string(bench.lab().gcnp_port(0));
  EXPECT_EQ(bench.query({"--connect", there, "participants"}).status, 0) << "a flag";
  EXPECT_EQ(bench.query({"--connect", nobody(), "participants"}).status, 3) << "a flag beats the environment";
  if (!bench.lab().has_namespaces()) GTEST_SKIP() << "the usual ports belong to whoever else is on this host";
  const auto usual = system::run(bench.lab().on(0, {system::program("geminga-query"), "participants"}));
  EXPECT_EQ(usual.status, 0) << "without any word about it: " << usual.said;
  EXPECT_EQ(bench.query({"--connect", "[::1]:4717", "participants"}).status, 0);
}

}  // namespace
}  // namespace geminga::tools
