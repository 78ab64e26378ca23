// A daemon and its ontology: still loading, unreadable, or overwritten while in use.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

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
  const Ran without_facts = refused({"--describe", "/nowhere/robot.ttl", "--check-config"});
  EXPECT_EQ(without_facts.status, 2);
  EXPECT_THAT(without_facts.said, HasSubstr("/nowhere/robot.ttl: cannot be opened"));
  const Ran broken_facts = refused({"--describe", broken, "--check-config"});
  EXPECT_EQ(broken_facts.status, 2);
  EXPECT_THAT(broken_facts.said, AllOf(HasSubstr("describe: "), HasSubstr(broken + ":1")));
}

TEST(Start, ChecksADescriptionByTheGrammarAndByTheOntology) {
  const Folder folder;
  const std::string prefixes =
      "@prefix : <http://zoo.example/#> . @prefix g: <https://geminga.example/core#> .\n"
      "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n";
  const std::string words = folder.write(
      "words.ttl",
      prefixes + ":has a owl:ObjectProperty . :Robot a owl:Class ; owl:disjointWith :Mast . :Mast a owl:Class .\n");
  const auto check = [&](const std::string& description, bool has_ontology) {
    std::vector<std::string> flags{"--describe", description, "--check-config"};
    if (has_ontology) flags.insert(flags.end(), {"--ontology", words});
    return refused(flags);
  };
  for (const bool has_ontology : {false, true}) {
    EXPECT_EQ(check("Robot and has some Mast", has_ontology).status, 0) << has_ontology;
    const Ran half = check("Robot and", has_ontology);
    EXPECT_EQ(half.status, 2) << has_ontology;
    EXPECT_THAT(half.said, HasSubstr("gemingad: describe: concept=Robot and: column 10: expected a class"))
        << has_ontology;
    const std::string file = folder.write("gemingad.toml", "describe = \"Robot and (has some\"\n");
    EXPECT_EQ(refused({"--config", file, "--check-config"}).status, 2);
  }
  EXPECT_EQ(check("Rowboat", false).status, 0) << "an ontology may come that knows it";
  EXPECT_THAT(check("Rowboat", true).said, HasSubstr("describe: concept=Rowboat: "));
  EXPECT_EQ(check("Robot and Mast", true).status, 2) << "nothing can be both";
  const std::string facts = folder.write("robot.ttl", prefixes + "g:self a :Robot , :Mast .\n");
  EXPECT_EQ(check(facts, true).status, 2) << "the expression made of facts is tried, too";
  folder.write("robot.ttl", prefixes + "g:self a :Robot ; :has [ a :Mast ] .\n");
  EXPECT_EQ(check(facts, true).status, 0);
}

TEST(Start, DescribesItselfByFactsAndServesThoseWhoAskForThat) {
  const Folder folder;
  const std::string prefixes =
      "@prefix : <http://zoo.example/#> . @prefix g: <https://geminga.example/core#> .\n"
      "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n";
  const std::string words =
      folder.write("words.ttl", prefixes + ":has a owl:ObjectProperty . :Robot a owl:Class . :Mast a owl:Class .\n");
  const std::string facts =
      folder.write("robot.ttl", prefixes + "g:self a :Robot ; :has [ a :Mast ] ; :says :hello .\n");
  Lab lab(1);
  lab.start(0, {"--ontology", words, "--describe", facts});
  ASSERT_TRUE(lab.daemon(0).wait_for("robot.ttl is in force, as an expression of ")) << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr("robot.ttl:3: left out: ")) << "nobody says what :says is";
  Talk talk = lab.talk(0);
  talk.say("1 pub create mode=oto text=relay port=5000");
  talk.say("2 sub create mode=oto text=relay on=\"Robot and has some Mast\"");
  EXPECT_TRUE(talk.line_with({"2 pub add", "text=relay"}));

  folder.write("robot.ttl", prefixes + "g:self a :Robot ;\n");
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the description in force is kept")) << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr(facts + ":3"));
  EXPECT_THAT(talk.query("services mode=participant"), Contains(HasSubstr("Mast")));

  folder.write("robot.ttl", prefixes + "g:self a :Robot .\n");
  lab.daemon(0).signal(SIGHUP);
  EXPECT_TRUE(talk.line_with({"2 pub del", "reason=changed"}));

  const auto missing = refused({"--describe", folder.path("nowhere.ttl")});
  EXPECT_THAT(missing.said, HasSubstr("nowhere.ttl: cannot be opened")) << "a file, and no expression";
}

/// A folder with one file that can be read, and one that cannot.
struct HalfGood {
  HalfGood() {
    fs::create_directory(files.path("team"));
    files.write("team/good.ttl", animals);
    bad = files.write("team/bad.ttl", ":Dog a owl:Class\n");
    team = files.path("team");
  }
  Folder files;
  std::string team;
  std::string bad;
};

constexpr const char* offers_a_cat = "1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5001";

TEST(Start, TakesTheGoodFilesOfAFolderAndNamesTheOneThatCannotBeRead) {
  const HalfGood half;
  Lab lab(1);
  lab.start(0, {"--ontology", half.team});
  EXPECT_TRUE(lab.daemon(0).wait_for("left out: " + half.bad)) << lab.daemon(0).said();
  Talk talk = lab.talk(0);
  talk.say(offers_a_cat);
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());
  EXPECT_TRUE(talk.wait_until("status", [&](const auto& lines) {
    return lines.size() == 1 && lines[0].find("ontology_failed=\"left out: " + half.bad) != std::string::npos;
  }));
  EXPECT_THAT(talk.query("ontology"), Contains(AllOf(HasSubstr("failed="), HasSubstr(half.bad))));

  // A reload leaves the ontology in force as it is while a file is broken.
  half.files.write("team/worse.ttl", ":Fox a owl:Class\n");
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the ontology in force is kept")) << lab.daemon(0).said();
  talk.say("2" + std::string(offers_a_cat).substr(1));
  EXPECT_THAT(talk.lines_until_pong(), IsEmpty());

  fs::remove(half.bad);
  fs::remove(half.files.path("team/worse.ttl"));
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the failure is mended")) << lab.daemon(0).said();
  EXPECT_THAT(talk.query("status")[0], Not(HasSubstr("ontology_failed")));
}

TEST(Start, TakesNoFileOfAFolderWhereItIsStrictAndOneCannotBeRead) {
  const HalfGood half;
  Lab lab(1);
  lab.start(0, {"--ontology", half.team, "--strict"});
  ASSERT_TRUE(lab.daemon(0).wait_for("serving without an ontology")) << lab.daemon(0).said();
  Talk talk = lab.talk(0);
  talk.say(offers_a_cat);
  EXPECT_THAT(talk.lines_until_pong(), testing::ElementsAre(AllOf(StartsWith("1 422 "), HasSubstr(half.bad))));
  EXPECT_EQ(refused({"--ontology", half.team, "--check-config"}).status, 2) << "a check takes everything";
}

/// An instance of two classes that exclude each other.
constexpr const char* contradiction = R"(@prefix : <http://zoo.example/#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
:Tree a owl:Class ; owl:disjointWith :Animal .
:bob a owl:NamedIndividual , :Cat , :Tree .
)";

TEST(Start, SaysThatItsOntologyContradictsItself) {
  const Folder folder;
  const std::string zoo = folder.write("zoo.ttl", animals);
  const std::string facts = folder.write("facts.ttl", contradiction);
  Lab lab(1);
  lab.start(0, {"--ontology", zoo, "--ontology", facts});
  Talk talk = lab.talk(0);
  EXPECT_THAT(talk.query("status")[0], HasSubstr("ontology_contradiction=1"));
  EXPECT_THAT(talk.query("ontology")[0], AllOf(HasSubstr("complete=0"), HasSubstr("contradiction=1")));
  talk.say("1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5000");
  EXPECT_THAT(talk.lines_until_pong(),
              testing::ElementsAre(AllOf(StartsWith("1 422 "), HasSubstr("contradicts itself"))));
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  const Ran told = run(lab.on(0, {program("geminga-query"), "--connect", address, "ontology"}));
  EXPECT_THAT(told.said, AllOf(HasSubstr("Contradiction:"), Not(HasSubstr("Complete: "))));
  const Ran checked = refused({"--ontology", zoo, "--ontology", facts, "--check-config"});
  EXPECT_EQ(checked.status, 2);
  EXPECT_THAT(checked.said,
              AllOf(HasSubstr("contradicts itself"), HasSubstr("geminga-ontology check " + zoo + ' ' + facts)));
}

TEST(Reload, KeepsTheOntologyInForceWhenTheNewOneContradictsItself) {
  const Folder folder;
  const std::string zoo = folder.write("zoo.ttl", animals);
  const std::string facts = folder.write("facts.ttl", "");
  Lab lab(1);
  lab.start(0, {"--ontology", zoo, "--ontology", facts});
  Talk provider = lab.talk(0);
  Talk consumer = lab.talk(0);
  provider.say("1 pub create mode=otm/stream concept=<http://zoo.example/#Cat> port=5001");
  consumer.say("1 sub create mode=otm/stream concept=<http://zoo.example/#Animal>");
  ASSERT_TRUE(consumer.line_with({"1 pub add", "port=5001"}));
  folder.write("facts.ttl", contradiction);
  lab.daemon(0).forget();
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the ontology in force is kept")) << lab.daemon(0).said();
  EXPECT_THAT(lab.daemon(0).said(), HasSubstr("the ontology contradicts itself"));
  EXPECT_THAT(consumer.lines_until_pong(), IsEmpty());
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  EXPECT_THAT(consumer.query("status")[0], HasSubstr("ontology_failed=\"the ontology contradicts itself"));
  EXPECT_THAT(consumer.query("ontology"), Contains(HasSubstr(" failed=\"the ontology contradicts itself")));

  folder.write("facts.ttl", "");
  lab.daemon(0).signal(SIGHUP);
  ASSERT_TRUE(lab.daemon(0).wait_for("the failure is mended")) << lab.daemon(0).said();
  EXPECT_THAT(consumer.query("status")[0], Not(HasSubstr("ontology_failed")));
}

/// A gemingad with a shell script as geminga-ontology, which can start no program.
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
  const Ran listed = run(lab.on(0, {program("geminga-query"), "--connect", address, "services", "mode=otm/pubsub"}));
  EXPECT_EQ(listed.status, 1);
  EXPECT_THAT(listed.said, HasSubstr("the daemon is still reading its ontology"));

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
    talk.say(id + " pub create mode=otm/stream concept=Cat port=5000");  // by label: labels are read last
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

}  // namespace
}  // namespace geminga::system
