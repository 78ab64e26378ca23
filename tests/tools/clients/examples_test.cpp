// Runs every example of every --help and of the documents for users as it stands there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

#include "tools/clients/bench.hpp"
#include "tools/help_text.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::Not;
using testing::SizeIs;

/// The text with `from` replaced wherever it stands.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The commands of a text that begin with `geminga-`, each in one line, without remarks.
std::vector<std::string> examples_in(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(std::regex_replace(text, std::regex(R"( *\\\n *)"), " "));
  for (std::string line; std::getline(lines, line);) {
    for (const char* introduction : {"Example: ", "Examples: "}) line = replaced(line, introduction, "");
    line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
    if (!line.starts_with("geminga-") || !line.contains(' ')) continue;
    for (const char* end : {" #", " |", " > ", "   ", " &&", " &"}) line = line.substr(0, line.find(end));
    line.erase(line.find_last_not_of(' ') + 1);
    found.push_back(line);
  }
  return found;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A daemon with the services of the examples, and a folder with their files.
class Examples : public testing::Test {
 protected:
  Examples() {
    std::string path = fs::temp_directory_path() / "geminga-examples-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
    const fs::path shipped = fs::path(GEMINGA_SOURCE_DIR) / "ontology";
    for (const char* folder : {"team", "old"}) fs::create_directory(folder_ / folder);
    std::ofstream(folder_ / "alerts.toml")
        << "[[rule]]\nname = \"eyes\"\nparticipants = \"canSee some WarmThing\"\nat-least = 2\n";
    std::ofstream(folder_ / "names.txt") << "# one a line\nsoccer:BallInfo\nsoccer:SharedBallInfo\n";
    for (const char* name : {"core.ttl", "robot-soccer.ttl"}) {
      for (const char* folder : {"team", "old"}) fs::copy_file(shipped / name, folder_ / folder / name);
      fs::copy_file(shipped / name, folder_ / name);
    }
    fs::create_directory_symlink(shipped, folder_ / "ontology");
    fs::copy_file(GEMINGA_SOURCE_DIR "/examples/rescue-team/task.ttl", folder_ / "task.ttl");
    fs::copy_file(fs::path(GEMINGA_SOURCE_DIR) / "examples/facts/robot.ttl", folder_ / "robot.ttl");
    const std::string soccer = text_of(shipped / "robot-soccer.ttl");
    const auto prefix = soccer.find("@prefix soccer:");
    const std::string own = "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n" +
                            soccer.substr(prefix, soccer.find('\n', prefix) + 1 - prefix);
    std::ofstream(folder_ / "expected.ttl") << own << "soccer:SharedBallInfo rdfs:subClassOf soccer:BallInfo .\n";
    std::ofstream(folder_ / "my-team.ttl") << own << "soccer:LidarBall a <http://www.w3.org/2002/07/owl#Class> ; "
                                           << "rdfs:subClassOf soccer:BallInfo .\n";
    std::ofstream(folder_ / "oeo.omn") << "Prefix: : <http://oeo.example/>\nOntology: <http://oeo.example/>\n"
                                       << "Class: :Plant\n    SubClassOf: :Thing\nClass: :Thing\n";
    std::ofstream(folder_ / "pizza.owl") << "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
                                         << "<urn:p#Margherita> rdfs:subClassOf <urn:p#Pizza> .\n";
    std::ofstream(folder_ / "unnamed.rq") << "SELECT ?c WHERE { ?c a <http://www.w3.org/2002/07/owl#Class> }\n";
    for (const auto& [name, concept_name] :
         {std::pair("services", "SharedBallInfo"), std::pair("queries", "BallInfo")}) {
      fs::create_directory(folder_ / name);
      std::ofstream(folder_ / name / "ball.owls")
          << "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
          << "xmlns:profile='http://www.daml.org/services/owl-s/1.1/Profile.owl#'><profile:Profile>"
          << "<profile:hasOutput rdf:resource='https://geminga.example/soccer#" << concept_name << "'/>"
          << "</profile:Profile></rdf:RDF>\n";
    }
    EXPECT_EQ(start("geminga-ontology compile team/ -o team.geminga")->wait(), 0);
    provide();
  }
  ~Examples() override { fs::remove_all(folder_); }

  void provide() {
    peer_.say("0 sys hello name=vision");
    EXPECT_TRUE(peer_.line_with({"0 msg hello"}));
    peer_.say("1 pub create mode=otm/stream concept=soccer:SharedBallInfo port=5000 rate=30");
    peer_.say("2 pub create mode=otm/pubsub text=camera port=5001 rate=30");
    peer_.say(
        "3 pub create mode=otm/stream concept=soccer:BallInfo representation=soccer:CartesianFieldFrame port=5002 "
        "rate=30");
    peer_.say("4 pub create mode=otm/stream id=0x30242948 port=5003");
    peer_.say("5 sub create mode=oto text=nobody");
    EXPECT_THAT(peer_.lines_until_pong(), testing::IsEmpty());
  }

  [[nodiscard]] std::unique_ptr<Process> start(const std::string& example) {
    const std::string script = "cd '" + folder_.string() + "' && exec " + example;
    auto start = bench_.lab().on(0, {"/bin/sh", "-c", script});
    start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(bench_.lab().gcnp_port(0))},
                         {"PATH", GEMINGA_BINARY_DIR "/bin:/usr/bin:/bin"}};
    return std::make_unique<Process>(std::move(start));
  }

  /// Runs an example that ends by itself.
  void run(const std::string& example) {
    auto process = start(example);
    EXPECT_THAT(process->wait(), AnyOf(testing::Optional(0), testing::Optional(1), testing::Optional(4)))
        << example << '\n'
        << process->said();
  }

  /// Runs an example that records until something is in its file, or on its output.
  void record(const std::string& example) {
    std::string name = example.substr(example.rfind(' ') + 1);
    if (!example.contains("--append")) fs::remove(folder_ / name);
    auto process = start(example);
    if (name == "-") {
      EXPECT_TRUE(process->wait_for("snapshot")) << example << '\n' << process->said();
    } else {
      // It polls: with inotify tail never reads a file that comes to be between its first look and its watch.
      const std::vector<std::string> words{"/usr/bin/tail", "---disable-inotify", "-s", "0.1", "-F", folder_ / name};
      Process reader({.words = words, .environment = {}, .before = {}});
      const bool has_read = reader.wait_for("snapshot");
      // The file is what counts: tail has missed its content once on a busy machine.
      const std::string recorded = text_of(folder_ / name);
      EXPECT_TRUE(has_read || recorded.contains("snapshot"))
          << example << '\n'
          << process->said() << reader.said() << recorded.size() << " octets: " << recorded.substr(0, 400);
    }
    process->signal(SIGTERM);
    EXPECT_EQ(process->wait(), 0) << example << '\n' << process->said();
  }

  /// Runs an example that takes an ontology, which this host offers.
  void fetch(std::string example) {
    auto server = start("geminga-ontology serve team/ --open --version 7");
    ASSERT_TRUE(server->wait_for("offering")) << server->said();
    example = replaced(replaced(example, "--from base", "--from robot0"), "/tmp/", "");
    example = replaced(example, "--align rescue1", "--align robot0");
    for (const char* made : {"theirs", "rescue"}) fs::remove_all(folder_ / made);
    run(example + " --open");
    server->signal(SIGTERM);
    EXPECT_EQ(server->wait(), 0) << server->said();
  }

  void expect_to_work(std::string example) {
    example = replaced(example, "127.0.0.1:4718", "127.0.0.1:" + std::to_string(bench_.lab().gcnp_port(0)));
    example = replaced(example, "/usr/local/share/geminga/ontology", "ontology");
#ifdef __SANITIZE_THREAD__
    example = replaced(example, " --memory-limit 512", "");  // the sanitizer's own tables take more
#endif
    example = replaced(example, "--format svg", "--format dot");  // svg needs Graphviz, which may not be installed
    example = replaced(example, "/var/lib/robot/", "");
    example = replaced(example, "--at 14:03:10", "--speed 2");  // a recording of these seconds has another moment
    if (example.starts_with("geminga-bridge")) return;          // needs what is beyond it: tests/tools/bridge
    if (example.starts_with("geminga-query record")) return record(example);
    const bool is_taken = example.starts_with("geminga-ontology fetch") || example.contains("--align");
    if (is_taken) return fetch(example);
    const bool is_served = example.starts_with("geminga-ontology serve");
    if (is_served && !example.contains("--open")) example += " --open";  // this team has no key
    const bool is_replay = example.starts_with("geminga-query replay");
    if (is_replay && !fs::exists(folder_ / "field-test.jsonl")) record("geminga-query record field-test.jsonl");
    const bool is_alerts = example.starts_with("geminga-query") && example.contains(" alerts ");
    example = replaced(example, "logger -t alerts", "echo");
    const bool is_web = example.starts_with("geminga-web");
    const bool goes_on = is_web || is_served || (is_alerts && !example.contains("--check")) ||
                         (is_replay && !example.contains("--mcap")) || example.starts_with("geminga-publish") ||
                         example.contains("--watch");
    if (!goes_on) {
      const bool needs_end = example.starts_with("geminga-subscribe") && !example.contains("--timeout");
      run(needs_end ? example + " --timeout 0.2" : example);
      return;
    }
    auto process = start(example);
    EXPECT_TRUE(process->wait_for(is_web                        ? "serving"
                                  : is_replay                   ? "Plays from"
                                  : is_alerts                   ? "raised"
                                  : example.contains("--watch") ? "robot0"
                                                                : "offer"))
        << example << '\n'
        << process->said();
    process->signal(SIGTERM);
    EXPECT_EQ(process->wait(), 0) << example << '\n' << process->said();
  }

  /// Runs every example of the --help of a program and its commands. Returns their number.
  std::size_t expect_help_to_work(const std::string& program) {
    const std::string help = bench_.run(program, {"--help"}).out;
    std::vector<std::string> examples = examples_in(help);
    for (const std::string& command : commands_of(help)) {
      const auto more = examples_in(bench_.run(program, {command, "--help"}).out);
      EXPECT_THAT(more, Not(testing::IsEmpty())) << program << ' ' << command << " --help has no example";
      examples.insert(examples.end(), more.begin(), more.end());
    }
    for (const std::string& example : examples) expect_to_work(example);
    return examples.size();
  }

  fs::path folder_;
  Bench bench_{std::vector<std::string>{"--describe", "Robot and hasPart some Gripper and hasPart some ThermalCamera"}};
  Talk peer_ = bench_.talk();
};

TEST_F(Examples, OfTheHelpOfQueryWork) { EXPECT_GE(expect_help_to_work("geminga-query"), 20U); }
TEST_F(Examples, OfTheHelpOfPublishWork) { EXPECT_GE(expect_help_to_work("geminga-publish"), 3U); }
TEST_F(Examples, OfTheHelpOfSubscribeWork) { EXPECT_GE(expect_help_to_work("geminga-subscribe"), 5U); }
TEST_F(Examples, OfTheHelpOfOntologyWork) { EXPECT_GE(expect_help_to_work("geminga-ontology"), 18U); }

TEST_F(Examples, OfTheReadmeWork) {
  const auto examples = examples_in(text_of(fs::path(GEMINGA_SOURCE_DIR) / "README.md"));
  EXPECT_THAT(examples, SizeIs(testing::Ge(3U)));
  for (const std::string& example : examples) expect_to_work(example);
}

TEST_F(Examples, OfTheGuideWork) {
  const auto examples = examples_in(text_of(fs::path(GEMINGA_SOURCE_DIR) / "GUIDE.md"));
  EXPECT_THAT(examples, SizeIs(testing::Ge(12U)));
  for (const std::string& example : examples) expect_to_work(example);
}

TEST_F(Examples, OfHowATeamWritesItsOntologyWork) {
  const std::string document = text_of(fs::path(GEMINGA_SOURCE_DIR) / "ontology" / "README.md");
  const auto begin = document.find("```turtle\n");
  ASSERT_NE(begin, std::string::npos);
  const auto text = document.find('\n', begin) + 1;
  std::ofstream(folder_ / "tigers.ttl") << document.substr(text, document.find("```", text) - text);
  const auto examples = examples_in(document);
  EXPECT_THAT(examples, SizeIs(4));
  for (const std::string& example : examples) {
    auto process = start(example);
    EXPECT_EQ(process->wait(), 0) << example << '\n' << process->said();
  }
}

TEST(ExamplesIn, AreFoundInTexts) {
  EXPECT_EQ(examples_in("Example: geminga-query why A B\n"), std::vector<std::string>{"geminga-query why A B"});
  EXPECT_EQ(examples_in("Examples:\n  geminga-x a 'b  c'   what it does\n$ geminga-y\ngeminga-z a \\\n b && echo\n"),
            (std::vector<std::string>{"geminga-x a 'b  c'", "geminga-z a b"}));
  EXPECT_EQ(examples_in("geminga-x a | jq .b\ngeminga-x b > c\ngeminga-x d &   # e\n"),
            (std::vector<std::string>{"geminga-x a", "geminga-x b", "geminga-x d"}));
}

}  // namespace
}  // namespace geminga::tools
