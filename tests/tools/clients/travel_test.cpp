// geminga-ontology serve and fetch between two hosts of a team with a key, with a liar among them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/lab.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using system::Lab;
using system::Process;
using testing::AllOf;
using testing::HasSubstr;

class Travel : public testing::Test {
 protected:
  Travel() {
    std::string path = fs::temp_directory_path() / "geminga-travel-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
    fs::create_directory(folder_ / "team");
    std::ofstream(folder_ / "team" / "team.ttl")
        << "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n<urn:team> a owl:Ontology ; owl:versionInfo \"7\" .\n"
        << "<urn:team#Ball> a owl:Class .\n";
    EXPECT_EQ(system::run({{system::program("gemingad"), "--generate-key", (folder_ / "key").string()}, {}, {}}).status,
              0);
  }
  ~Travel() override { fs::remove_all(folder_); }

  [[nodiscard]] Process::Start start_of(std::size_t host, const std::string& program,
                                        std::vector<std::string> words) const {
    words.insert(words.begin(), system::program(program));
    auto start = lab_.on(host, std::move(words));
    start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(lab_.gcnp_port(host))}};
    return start;
  }
  [[nodiscard]] system::Ran fetch(std::vector<std::string> words, const std::string& folder) const {
    words.insert(words.begin(), "fetch");
    words.insert(words.end(), {"-o", (folder_ / folder).string()});
    return system::run(start_of(1, "geminga-ontology", std::move(words)));
  }
  /// Has the second host fetch what it adopts until it has this version of the first host's. Gives the exit status.
  [[nodiscard]] int adopt(const std::string& version) const {
    int status = 0;
    while (status == 0 && !fs::exists(folder_ / "state" / "adopted" / "robot0" / version))
      status = system::run(start_of(1, "geminga-ontology", {"adopt", "--once"})).status;
    return status;
  }
  [[nodiscard]] std::string content_of(const fs::path& file) const {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
  Lab lab_{2};
};

TEST_F(Travel, BringsAnOntologyWholeFromWhoHasItAndNothingFromALiar) {
  // Neither daemon knows geminga:Ontology: they meet by its number.
  lab_.start(0, {"--key-file", (folder_ / "key").string()});
  std::ofstream(folder_ / "own.ttl") << "<urn:own#it> a <urn:team#Ball> .\n";
  lab_.start(1, {"--key-file", (folder_ / "key").string(), "--ontology", (folder_ / "own.ttl").string(),
                 "--state-folder", (folder_ / "state").string(), "--adopt-from", "robot0"});
  EXPECT_EQ(fetch({"--timeout", "0"}, "none").status, 1);

  Process server(start_of(0, "geminga-ontology", {"serve", (folder_ / "team").string()}));
  ASSERT_TRUE(server.wait_for("offering 1 file, version 7")) << server.said();
  const auto taken = fetch({"--from", "robot0", "--timeout", "60"}, "taken");
  EXPECT_EQ(taken.status, 0) << taken.said;
  EXPECT_EQ(content_of("taken/team.ttl"), content_of("team/team.ttl"));

  const std::string digest(64, 'a');
  Process::Start lie = start_of(
      0, "geminga-publish",
      {"--id", "1450564836", "--mode", "otm/pubsub", "--protocol", "tcp", "--send", "digest=" + digest, "version=9"});
  // It says its one line to its first consumer, and ends.
  std::ofstream(folder_ / "lie") << "lie\n";
  const std::vector<std::string> shell{"/bin/sh", "-c", "exec \"$@\" < '" + (folder_ / "lie").string() + "'", "sh"};
  lie.words.insert(lie.words.begin(), shell.begin(), shell.end());
  Process liar(lie);
  system::Ran several;
  do several = fetch({"--timeout", "60"}, "several");
  while (several.status == 0);  // until the liar is heard, there is one ontology
  EXPECT_EQ(several.status, 2);
  EXPECT_THAT(several.said, AllOf(HasSubstr("several are offered"), HasSubstr("version 7 of robot0")));
  const auto lied = fetch({"--digest", "aa", "--timeout", "10"}, "lied");
  EXPECT_EQ(lied.status, 1);
  EXPECT_THAT(lied.said, HasSubstr("no part of an ontology"));
  EXPECT_FALSE(fs::exists(folder_ / "lied"));

  server.signal(SIGSTOP);  // it is still offered, and nothing comes
  system::Ran late;
  do late = system::run(start_of(1, "geminga-ontology", {"adopt", "--once", "--time-limit", "1"}));
  while (late.status == 0);  // until the version is heard, there is nothing to fetch
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(late.said, HasSubstr("robot0: the ontology was not whole in time"));
  EXPECT_FALSE(fs::exists(folder_ / "state" / "adopted" / "robot0"));
  server.signal(SIGCONT);

  lab_.daemon(1).forget();
  EXPECT_EQ(adopt("7"), 0);
  EXPECT_EQ(content_of("state/adopted/robot0/7/team.ttl"), content_of("team/team.ttl"));
  EXPECT_TRUE(lab_.daemon(1).wait_for("is in force")) << lab_.daemon(1).said();

  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0) << server.said();
  std::ofstream(folder_ / "team" / "team.ttl", std::ios::app)
      << "<urn:team#Ball> <http://www.w3.org/2000/01/rdf-schema#subClassOf> owl:Nothing .\n";
  Process next(start_of(0, "geminga-ontology", {"serve", (folder_ / "team").string(), "--version", "8"}));
  ASSERT_TRUE(next.wait_for("offering")) << next.said();
  EXPECT_EQ(adopt("8"), 0);
  EXPECT_TRUE(lab_.daemon(1).wait_for("8 is not adopted: the ontologies contradict themselves with it"))
      << lab_.daemon(1).said();
}

TEST_F(Travel, NeedsAKeyUnlessItIsOpen) {
  lab_.start(0, {"--ontology", GEMINGA_SOURCE_DIR "/ontology/core.ttl"});
  const auto refused = system::run(start_of(0, "geminga-ontology", {"serve", (folder_ / "team").string()}));
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr("--open"));
}

}  // namespace
}  // namespace geminga::tools
