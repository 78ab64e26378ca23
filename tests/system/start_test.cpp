// What gemingad says when it starts, when it cannot, and when it is asked to end or to read everything again.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "system/lab.hpp"

namespace geminga::system {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A folder for the files of one test, removed with it.
class Folder {
 public:
  Folder() {
    std::string path = fs::temp_directory_path() / "geminga-test-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

constexpr const char* animals = R"(@prefix : <http://zoo.example/#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<http://zoo.example/> a owl:Ontology .
:Animal a owl:Class .
:Cat a owl:Class ; rdfs:subClassOf :Animal .
)";

std::string shipped(const std::string& name) { return std::string(GEMINGA_SOURCE_DIR) + "/ontology/" + name; }

/// Starts a gemingad that is expected to refuse.
Ran refused(const std::vector<std::string>& flags, std::map<std::string, std::string> environment = {}) {
  std::vector<std::string> words{program("gemingad")};
  words.insert(words.end(), flags.begin(), flags.end());
  return run({.words = words, .environment = std::move(environment), .before = {}});
}

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
      {{"--key-file", "team.key"}, "--key-file: sealed announcements are not there yet"},
      {{"--http", "127.0.0.1:80"}, "--http: the HTTP side is not there yet"},
      {{"--surprise"}, "--surprise: see gemingad --help"},
      {{"surprise"}, "surprise: see gemingad --help"},
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
  const std::string zoo = folder.write("zoo.ttl", animals);
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

TEST(Start, ServesWithoutAnOntologyThatCannotBeRead) {
  const Folder folder;
  const std::string good = folder.write("good.ttl", animals);
  const std::string broken =
      folder.write("broken.ttl", std::string(animals) + ":Dog a owl:Class\n:Fox a owl:Class .\n");
  Lab lab(1);
  lab.start(0, {"--ontology", good, "--ontology", broken});
  ASSERT_TRUE(lab.daemon(0).wait_for("serving without an ontology")) << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr(broken + ":8"));
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=otm/stream id=5 port=5000");
  talk.say("2 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5001");
  EXPECT_THAT(talk.lines_until_pong(), testing::ElementsAre(AllOf(StartsWith("2 422 "), HasSubstr(broken + ":8"))));
  EXPECT_TRUE(talk.wait_until("status", [&](const auto& lines) {
    return lines.size() == 1 && lines[0].find("ontology_failed=") != std::string::npos;
  }));

  folder.write("broken.ttl", "");
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("is in force")) << lab.daemon(0).said();
  talk.say("2 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5001");
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());
  EXPECT_THAT(talk.query("status")[0], Not(HasSubstr("ontology_failed")));
  EXPECT_EQ(refused({"--ontology", good, "--check-config"}).status, 0);
  folder.write("broken.ttl", ":Dog a owl:Class\n");
  EXPECT_EQ(refused({"--ontology", broken, "--check-config"}).status, 2) << "a check says that it will not do";
}

/// A gemingad beside a geminga-ontology of our own making, a shell script without other programs.
class WithCompiler {
 public:
  WithCompiler(const Folder& folder, const std::string& script) {
    daemon_ = folder.path("gemingad");
    fs::copy_file(program("gemingad"), daemon_);
    const std::string compiler = folder.write("geminga-ontology", "#!/bin/sh\n" + script + "\n");
    fs::permissions(compiler, fs::perms::owner_all);
  }
  [[nodiscard]] const std::string& daemon() const { return daemon_; }

 private:
  std::string daemon_;
};

TEST(Start, ServesFromItsFirstSecondWhileAHardOntologyIsStillBeingRead) {
  const Folder folder;
  const std::string zoo = folder.write("zoo.ttl", animals);
  const std::string compiled = folder.path("zoo.geminga");
  ASSERT_EQ(
      run({.words = {program("geminga-ontology"), "compile", zoo, "-o", compiled}, .environment = {}, .before = {}})
          .status,
      0);
  const WithCompiler slow(folder,
                          "while [ ! -e '" + folder.path("go") + "' ]; do :; done; exec cat '" + compiled + "'");
  Lab lab(1);
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  Process daemon(lab.on(0, {slow.daemon(), "--interface", "lo", "--gcnp", address, "--ontology", zoo}));
  ASSERT_TRUE(daemon.wait_for("ready: ")) << daemon.said();
  EXPECT_TRUE(daemon.wait_for("ontology is being loaded"));
  Talk provider = lab.talk(0);
  Talk consumer = lab.talk(0);
  provider.say("1 pub create mode=otm/stream text=ball port=5001");
  consumer.say("1 sub create mode=otm/stream text=ball");
  EXPECT_TRUE(consumer.line_with({"1 pub add", "port=5001"})) << "texts wait for nothing";
  provider.say("2 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5002");
  provider.say("3 pub create mode=otm/stream concept=<http://zoo.example/#Unicorn> port=5003");
  consumer.say("2 sub create mode=otm/stream concept=<http://zoo.example/#Animal>");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  EXPECT_THAT(consumer.lines_until_pong(), IsEmpty());
  consumer.say("3 query match concept=<http://zoo.example/#Animal>");
  EXPECT_THAT(consumer.lines_until_pong(), testing::ElementsAre(StartsWith("3 503 not ready: the ontology is being")));
  EXPECT_THAT(consumer.query("status")[0], HasSubstr("ontology_loading=1"));

  folder.write("go", "");
  EXPECT_TRUE(consumer.line_with({"2 pub add", "port=5002"})) << daemon.said();
  EXPECT_TRUE(provider.line_with({"3 422 "}));
  EXPECT_THAT(consumer.query("status")[0], Not(HasSubstr("ontology_loading")));
  daemon.signal(SIGTERM);
  EXPECT_EQ(daemon.wait(), 0);
}

TEST(Start, EndsAtOnceWhenItIsAskedToWhileItsOntologyIsBeingRead) {
  const Folder folder;
  const WithCompiler endless(folder, "exec sleep 1000");
  Lab lab(1);
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  Process daemon(lab.on(
      0, {endless.daemon(), "--interface", "lo", "--gcnp", address, "--ontology", folder.write("zoo.ttl", animals)}));
  ASSERT_TRUE(daemon.wait_for("ready: ")) << daemon.said();
  daemon.signal(SIGTERM);
  EXPECT_EQ(daemon.wait(), 0);
}

TEST(Start, NeedsNoFolderForTemporaryFiles) {
  const Folder folder;
  Lab lab(1);
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  auto start = lab.on(
      0, {program("gemingad"), "--interface", "lo", "--gcnp", address, "--ontology", folder.write("zoo.ttl", animals)});
  start.environment["TMPDIR"] = "/no/such/folder";
  start.environment["XDG_RUNTIME_DIR"] = "/no/such/folder";
  Process daemon(std::move(start));
  ASSERT_TRUE(daemon.wait_for("ready: ")) << daemon.said();
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5000");
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());
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

TEST(Ontology, InUseMayBeOverwritten) {
  const Folder folder;
  const std::string zoo = folder.write("zoo.ttl", animals);
  const std::string compiled = folder.path("zoo.geminga");
  ASSERT_EQ(
      run({.words = {program("geminga-ontology"), "compile", zoo, "-o", compiled}, .environment = {}, .before = {}})
          .status,
      0);
  const auto size = fs::file_size(compiled);
  Lab lab(1);
  lab.start(0, {"--ontology", compiled});
  Talk talk = lab.talk(0);
  const auto asks = [&](const std::string& id) {
    talk.say(id + " pub create mode=otm/stream concept=Cat port=5000");  // by label, which is read late
    talk.say(id + "1 query explain sub=<http://zoo.example/#Cat> super=<http://zoo.example/#Animal>");
    const auto lines = talk.lines_until_pong();
    EXPECT_THAT(lines, Contains(HasSubstr("subsumed=1"))) << "after " << id;
  };
  std::fstream(compiled, std::ios::binary | std::ios::in | std::ios::out) << std::string(size, '\xff');
  asks("1");
  fs::resize_file(compiled, 0);
  asks("2");
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the ontology in force is kept")) << lab.daemon(0).said();
  asks("3");
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

  // Whoever looks later sees it, too, until it is mended.
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
  folder.write("geminga.toml", "log-level = \"debug\"\nlog-format = \"json\"\n");
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(lab.daemon(0).wait_for(R"("text":"ontology: none is in force")")) << lab.daemon(0).said();
  EXPECT_THAT(lab.talk(0).lines_until_pong(), IsEmpty());
}

TEST(End, ComesWithStatusZeroOnSigint) {
  Lab lab(1);
  lab.start(0);
  lab.daemon(0).signal(SIGINT);
  EXPECT_EQ(lab.daemon(0).wait(), 0);
}

}  // namespace
}  // namespace geminga::system
