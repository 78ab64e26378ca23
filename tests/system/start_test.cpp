// The words of gemingad at its start, at a failed start, at a reload and at its end.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Start, AnswersOverIpv6) {
  Lab lab(1);
  const std::string port = std::to_string(lab.gcnp_port(0));
  lab.start(0, {"--gcnp", "127.0.0.1:" + port, "--gcnp", "[::1]:" + port});
  Talk talk = lab.talk(0, "::1");
  talk.say("0 sys hello name=six");
  const auto hello = talk.line();
  ASSERT_TRUE(hello);
  EXPECT_THAT(*hello, AllOf(StartsWith("0 msg hello version=1 "), HasSubstr(" name=six ")));
}

TEST(Start, ListensOnBothLoopbackAddressesUnlessToldOtherwise) {
  Lab lab(1);
  EXPECT_THAT(refused({"--check-config"}).said, HasSubstr(R"(gcnp = ["127.0.0.1:4717", "[::1]:4717"])"));
  if (!lab.has_namespaces()) GTEST_SKIP() << "the usual ports belong to whoever else is on this host";
  lab.start(0);
  EXPECT_THAT(lab.talk(0, "127.0.0.1").lines_until_pong(), IsEmpty());
  EXPECT_THAT(lab.talk(0, "::1").lines_until_pong(), IsEmpty());
}

TEST(Start, ServesWithoutIpv6OnTheHost) {
  Lab lab(1);
  if (!lab.has_namespaces())
    GTEST_SKIP() << "a host without IPv6 needs a network namespace, which may not be made here";
  lab.visit(0, [] { std::ofstream("/proc/sys/net/ipv6/conf/all/disable_ipv6") << "1"; });
  lab.start(0);
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr("[::1]:4717 is not available on this host: going on without it"));
  EXPECT_THAT(lab.talk(0).lines_until_pong(), IsEmpty());
}

TEST(Start, SaysThatThePortIsInUse) {
  Lab lab(1);
  lab.start(0);
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  const Ran second = run(lab.on(0, {program("gemingad"), "--interface", "lo", "--gcnp", address}));
  EXPECT_EQ(second.status, 2);
  EXPECT_EQ(second.said, "gemingad: " + address + " is already in use: another gemingad? choose another with --gcnp\n");
  EXPECT_THAT(lab.talk(0).lines_until_pong(), IsEmpty()) << "the first one does not notice";
}

TEST(Start, RefusesWhatItDoesNotUnderstand) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--gcnp", "0.0.0.0:4717"}, "--gcnp: 0.0.0.0:4717 is not on this host alone"},
      {{"--gcnp", "[::]:4717"}, "--gcnp: [::]:4717 is not on this host alone"},
      {{"--gcnp", "localhost:4717"}, "--gcnp: 'localhost' is no IP address"},
      {{"--port", "65536"}, "--port: '65536' is no port"},
      {{"--multicast", "10.0.0.1"}, "--multicast: 10.0.0.1 is no multicast group"},
      {{"--key-file", "no-such.key"}, "no-such.key: No such file or directory: name a key file"},
      {{"--surprise"}, "'--surprise' is no flag: see gemingad --help"},
      {{"surprise"}, "'surprise' is one word too many: see gemingad --help"},
      {{"--config", "/nowhere/geminga.toml"}, "/nowhere/geminga.toml: No such file or directory"},
  };
  for (const auto& [flags, words] : cases) {
    const Ran ran = refused(flags);
    EXPECT_EQ(ran.status, 2) << words;
    EXPECT_THAT(ran.said, AllOf(StartsWith("gemingad: "), HasSubstr(words)));
  }
}

TEST(Start, ChecksItsConfiguration) {
  const Folder folder;
  const std::string file =
      folder.write("geminga.toml", "name = \"r2\"\nport = 4000\ninterval = 1\nlog-level = \"debug\"\n");
  const Ran good =
      refused({"--config", file, "--check-config"}, {{"GEMINGA_PORT", "4001"}, {"GEMINGA_LOG_LEVEL", "error"}});
  EXPECT_EQ(good.status, 0);
  EXPECT_THAT(good.said, AllOf(HasSubstr("name = \"r2\"\n"), HasSubstr("port = 4001\n"),
                               HasSubstr("interval = 1.000\n"), HasSubstr("log-level = \"error\"\n")));
  const std::string bad = folder.write("bad.toml", "name = \"r2\"\nport = \"4000\"\ncolour = \"red\"\n");
  const Ran wrong = refused({"--config", bad, "--check-config"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.said, AllOf(HasSubstr("gemingad: " + bad + ":2: port must be a whole number\n"),
                                HasSubstr("gemingad: " + bad + ":3: unknown key 'colour'")));
}

TEST(Start, ServesTheOntologyItWasGiven) {
  Lab lab(1);
  lab.start(0, {"--ontology", shipped("core.ttl"), "--ontology", shipped("robot-soccer.ttl")});
  Talk talk = lab.talk(0);
  talk.say("1 sub create mode=otm/stream concept=soccer:BallInfo");
  talk.say("2 sub create mode=otm/stream concept=soccer:NoSuchThing");
  const auto lines = talk.lines_until_pong();
  ASSERT_THAT(lines, testing::SizeIs(1));
  EXPECT_THAT(lines[0], StartsWith("2 422 "));
}

TEST(Start, TakesPrefixesFromItsConfiguration) {
  const Folder folder;
  folder.write("zoo.ttl", animals);
  const std::string file =
      folder.write("geminga.toml", "ontology = \"zoo.ttl\"\n[prefixes]\npet = \"http://zoo.example/#\"\n");
  Lab lab(1);
  lab.start(0, {"--config", file});
  Talk talk = lab.talk(0);
  talk.say("1 sub create mode=otm/stream concept=pet:Cat");
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());
}

TEST(Start, RefusesAnOntologyThatIsNotThere) {
  const Folder folder;
  const std::string missing = folder.path("missing.ttl");
  const Ran ran = refused({"--ontology", folder.write("good.ttl", animals), "--ontology", missing});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.said, "gemingad: " + missing + ": cannot be opened: No such file or directory\n");
}

TEST(Start, DrawsAnotherIdentityWhereTheFileIsEmptyAndSaysSo) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("state"));
  const std::string file = folder.write("state/identity", "");
  Lab lab(1);
  lab.start(0, {"--state-folder", folder.path("state")});
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr(file + ": was empty: another identity is drawn"));
  EXPECT_NE(std::filesystem::file_size(file), 0U);
}

TEST(Start, IsNotHeldUpByAFifo) {
  const Folder folder;
  ASSERT_EQ(::mkfifo(folder.path("fifo.toml").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(folder.path("fifo.geminga").c_str(), 0600), 0);
  for (const std::string& path : {folder.path("fifo.toml"), std::string("/dev/zero")}) {
    const Ran ran = refused({"--config", path});
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.said, "gemingad: " + path + ": is not a regular file\n");
  }
  for (const std::string& path : {folder.path("fifo.toml"), folder.path("fifo.geminga")}) {
    const Ran ran = refused({"--ontology", path, "--check-config"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_THAT(ran.said, AllOf(StartsWith("gemingad: "), HasSubstr(path)));
  }
}

TEST(Log, ThatNobodyReadsHoldsUpNobody) {
  Lab lab(1);
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  auto start = lab.on(0, {program("gemingad"), "--interface", "lo", "--gcnp", address});
  const auto enter = start.before;
  start.before = [enter, end = ends[1]] {
    if (enter) enter();
    ::dup2(end, STDERR_FILENO);
  };
  Process daemon(std::move(start));
  std::string said;
  std::array<char, 4096> chunk;
  while (said.find("ready: ") == std::string::npos) {
    const ssize_t size = ::read(ends[0], chunk.data(), chunk.size());
    ASSERT_GT(size, 0);
    said.append(chunk.data(), static_cast<std::size_t>(size));
  }
  Talk talk = lab.talk(0);
  constexpr int reloads = 1000;  // two lines each, and a pipe holds 64 KiB
  for (int number = 0; number < reloads; ++number) {
    daemon.signal(SIGHUP);
    ASSERT_THAT(talk.lines_until_pong(), IsEmpty());
  }
  EXPECT_TRUE(talk.wait_until(
      "status", [](const auto& lines) { return lines.size() == 1 && field(lines[0], "log_dropped") != "0"; }));
  daemon.signal(SIGTERM);
  EXPECT_EQ(daemon.wait(), 0);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Reload, KeepsPublicationsAndTakesTheNewOntology) {
  const Folder folder;
  const std::string file = folder.write("zoo.ttl", animals);
  Lab lab(1);
  lab.start(0, {"--ontology", file});
  Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=otm/stream concept=<http://zoo.example/#Animal>");
  Talk provider = lab.talk(0);
  provider.say("1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5000");
  provider.say("2 pub create mode=otm/stream concept=<http://zoo.example/#Dog> port=5001");
  EXPECT_THAT(provider.lines_until_pong(), testing::ElementsAre(StartsWith("2 422 ")));
  EXPECT_TRUE(consumer.line_with({"1 pub add", "port=5000"}));

  folder.write("zoo.ttl", std::string(animals) + ":Dog a owl:Class ; rdfs:subClassOf :Animal .\n");
  lab.daemon(0).forget();
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("is in force")) << lab.daemon(0).said();
  provider.say("2 pub create mode=otm/stream concept=<http://zoo.example/#Dog> port=5001");
  EXPECT_TRUE(consumer.line_with({"1 pub add", "port=5001"}));
  EXPECT_THAT(consumer.lines_until_pong(), IsEmpty()) << "what stayed matched gets no event";
}

TEST(Reload, KeepsTheOntologyInForceWhenTheNewOneIsBroken) {
  const Folder folder;
  const std::string file = folder.write("zoo.ttl", animals);
  Lab lab(1);
  lab.start(0, {"--ontology", file});
  folder.write("zoo.ttl", std::string(animals) + ":Dog a owl:Class\n:Fox a owl:Class .\n");
  lab.daemon(0).forget();
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the ontology in force is kept"));
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr(file + ":8"));
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5000");
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());

  // Queries show the failure until it is mended.
  talk.say("2 query ontology");
  EXPECT_TRUE(talk.line_with({"2 msg ontology failed=", file + ":8"}));
  folder.write("zoo.ttl", animals);
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the failure is mended")) << lab.daemon(0).said();
  talk.say("3 query status");
  const auto status = talk.line_with({"3 msg status"});
  ASSERT_TRUE(status);
  EXPECT_THAT(*status, testing::Not(HasSubstr("ontology_failed")));
}

TEST(Reload, KeepsTheConfigurationInForceWhenTheNewOneIsBroken) {
  const Folder folder;
  const std::string file = folder.write("geminga.toml", "log-level = \"info\"\n");
  Lab lab(1);
  lab.start(0, {"--config", file});
  folder.write("geminga.toml", "log-level = 7\n");
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for(file + ":1: log-level must be a text in quotes")) << lab.daemon(0).said();
  EXPECT_TRUE(lab.daemon(0).wait_for("the configuration in force is kept"));
  Talk talk = lab.talk(0);
  talk.say("1 query status");
  EXPECT_TRUE(talk.line_with({"1 msg status", "configuration_failed=", file + ":1"}));
  folder.write("geminga.toml", "log-level = \"debug\"\nlog-format = \"json\"\n");
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for(R"("text":"ontology: none is in force")")) << lab.daemon(0).said();
  talk.say("2 query status");
  const auto status = talk.line_with({"2 msg status"});
  ASSERT_TRUE(status);
  EXPECT_THAT(*status, testing::Not(HasSubstr("configuration_failed")));
}

TEST(Reload, WarnsOfASettingThatAwaitsAStartUntilItIsBackAsItWas) {
  const Folder folder;
  const std::string file = folder.write("geminga.toml", "group = \"red\"\n");
  Lab lab(1);
  lab.start(0, {"--config", file});
  const auto said_at_reload = [&](const std::string& group) {
    folder.write("geminga.toml", "group = \"" + group + "\"\n");
    const std::size_t earlier = lab.daemon(0).said().size();
    lab.daemon(0).forget();
    lab.daemon(0).signal(SIGHUP);
    EXPECT_TRUE(lab.daemon(0).wait_for("is in force")) << lab.daemon(0).said();
    return lab.daemon(0).said().substr(earlier);
  };
  const auto warns = HasSubstr("take effect at the next start");
  EXPECT_THAT(said_at_reload("red"), testing::Not(warns));
  EXPECT_THAT(said_at_reload("blue"), warns);
  EXPECT_THAT(said_at_reload("blue"), warns) << "the daemon is still in the group red";
  EXPECT_THAT(said_at_reload("red"), testing::Not(warns)) << "that is its group";
}

TEST(End, ComesWithStatusZeroOnSigint) {
  Lab lab(1);
  lab.start(0);
  lab.daemon(0).signal(SIGINT);
  EXPECT_EQ(lab.daemon(0).wait(), 0);
}

}  // namespace
}  // namespace geminga::system
