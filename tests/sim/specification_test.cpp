// The whole specification of the paper's team on ten hosts: who is told of whom is what it means, no pair more and no
// pair less. GEMINGA_SEED chooses another seed.
#include "sim/specification.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// How what a row says of its counterparts is said in GCNP.
enum class Said : std::uint8_t { as_scopes, as_conditions };
/// The sides that say it. The specification does on both; a provider that does not care who listens says nothing.
enum class Sayer : std::uint8_t { both, consumer };

struct Case {
  bool is_mended = false;
  Said said = Said::as_scopes;
  Sayer sayer = Sayer::both;
  std::string in_words;
};

const std::vector<std::string> of_a_robot{"Vision", "VisionDirected", "Base", "Motion", "Kicker", "Lebt", "Compass"};

/// Five robots that play, one that only shows its state, and four hosts beside the field.
std::vector<Post> posts() {
  std::vector<Post> all;
  for (int number = 1; number <= 5; ++number)
    all.push_back({"robot" + std::to_string(number) + "-shw-stat-ctrl-sim", of_a_robot});
  all.push_back({"robot6-stat", of_a_robot});
  all.back().modules.emplace_back("Replayer");
  all.push_back({"simulator-sim", {"Simulator"}});
  all.push_back({"monitor-shw-stat-ctrl", {"LebtClient", "RemoteControl"}});
  all.push_back({"guest", {"LebtClient", "Joystick", "RemoteControl"}});
  all.push_back({"referee-stat", {"RefereeBox", "RefereeBoxInterface", "CompassTestSender", "CompassTestReceiver"}});
  return all;
}

/// The ontology that ships says which names mean the same.
vocabulary::Vocabulary shipped() {
  const std::string folder = GEMINGA_SOURCE_DIR "/ontology/";
  const auto loaded = rdf::load(std::vector{folder + "core.ttl", folder + "robot-soccer.ttl"});
  EXPECT_TRUE(loaded);
  const auto classification = el::classify(loaded->source);
  EXPECT_TRUE(classification);
  return vocabulary::Vocabulary(
      std::move(compiled::Ontology::from_bytes(compiled::compile(loaded->source, *classification))).value());
}

/// "host/Base,*-shw*/Base,!host/Base"
std::string as_scope(const SpecificationRow& row) {
  std::string scope;
  for (const Counterpart& one : row.counterparts) {
    const std::string host = one.host == "localhost" ? "host"
                             : one.host == "any"     ? "any"
                                                     : "*-" + one.host.substr(0, one.host.find('_')) + "*";
    scope += (scope.empty() ? "" : ",") + std::string(one.is_excluded ? "!" : "") + host + "/" + one.module;
  }
  return scope;
}

/// The same by names alone, as one who knows the name of his own host can write it.
std::string as_condition(const SpecificationRow& row, const Post& own) {
  std::string wanted;
  std::string excluded;
  for (const Counterpart& one : row.counterparts) {
    const std::string host = one.host == "localhost" ? own.name
                             : one.host == "any"     ? "*"
                                                     : "*-" + one.host.substr(0, one.host.find('_')) + "*";
    const std::string text = "(participant_name = " + host + " and name = " + one.module + ")";
    if (one.is_excluded) {
      excluded += " and not " + text;
    } else {
      wanted += (wanted.empty() ? "" : " or ") + text;
    }
  }
  return "(" + wanted + ")" + excluded;
}

/// One row on one host.
struct Line {
  const Post* post;
  const SpecificationRow* row;
  Client* client;
  std::uint32_t number;

  /// "robot1-stat Base 2055": the port tells the rows of a module from each other.
  [[nodiscard]] std::string in_words() const { return post->name + " " + row->module + " " + std::to_string(port()); }
  [[nodiscard]] std::uint32_t port() const { return 2000 + number; }
};

std::string statement(const Line& line, const Case& how) {
  const bool is_publication = line.row->is_publication;
  std::string words = std::to_string(line.number) + (is_publication ? " pub" : " sub") + " create mode=otm/pubsub " +
                      (how.is_mended ? "concept=soccer:" : "text=") + line.row->message +
                      " port=" + std::to_string(line.port());
  if (is_publication && how.sayer == Sayer::consumer) return words;
  if (how.said == Said::as_scopes) return words + " scope=\"" + as_scope(*line.row) + "\"";
  return words + (is_publication ? " for=\"" : " where=\"") + as_condition(*line.row, *line.post) + "\"";
}

bool is_meant(const Line& offered, const Line& wanted, const Case& how) {
  if (!offered.row->is_publication || wanted.row->is_publication) return false;
  if (!is_same_message(offered.row->message, wanted.row->message, how.is_mended)) return false;
  if (!names(*wanted.row, *wanted.post, *offered.post, offered.row->module)) return false;
  return how.sayer == Sayer::consumer || names(*offered.row, *offered.post, *wanted.post, wanted.row->module);
}

/// The view of a module for one of its rows.
std::set<std::string> told(const Line& line) {
  std::set<std::string> others;
  for (const auto& [word, event] : line.client->view(line.number)) {
    const auto value = [&](std::string_view key) { return std::string(event.value(key).value_or("?")); };
    others.insert(value("participant_name") + " " + value("name") + " " + value("port"));
  }
  return others;
}

class Specification : public testing::TestWithParam<Case> {};

TEST_P(Specification, ConnectsAllThatItMeansAndNobodyElse) {
  const auto file = specification_file();
  if (!file) GTEST_SKIP() << "no carpe-noctem/modules.tsv in $GEMINGA_TEST_DATA or ../shared/data";
  const auto rows = read_specification(*file);
  ASSERT_EQ(rows.size(), 70U);
  const Case& how = GetParam();
  const std::vector<Post> all = posts();
  World world(World::seed_or(12), {.loss = 0.1, .longest_delay = milliseconds(20)});
  const vocabulary::Vocabulary ontology = how.is_mended ? shipped() : vocabulary::Vocabulary();
  std::vector<Line> lines;
  std::set<std::string> modules;
  for (const Post& post : all) {
    Host& host = world.add_host(post.name);
    host.ontology = ontology;
    host.switch_on();
    world.run_for(milliseconds(100));
    for (const std::string& module : post.modules) {
      modules.insert(module);
      Client& client = world.add_client(post.name + "/" + module);
      client.keeps_lines = false;
      client.connect(host);
      client.say("0 sys hello name=" + module);
      for (std::uint32_t at = 0; at < rows.size(); ++at) {
        if (rows[at].module == module) lines.push_back({&post, &rows[at], &client, at + 1});
      }
    }
  }
  for (const SpecificationRow& row : rows) EXPECT_TRUE(modules.contains(row.module)) << row.module << " is nowhere";
  world.run_for(seconds(2));
  for (const Line& line : lines) line.client->say(statement(line, how));
  world.run_for(seconds(20));
  std::size_t pairs = 0;
  for (const Line& line : lines) {
    std::set<std::string> meant;
    for (const Line& other : lines) {
      if (is_meant(line, other, how) || is_meant(other, line, how)) meant.insert(other.in_words());
    }
    EXPECT_EQ(told(line), meant) << line.in_words() << ": " << statement(line, how) << "\n" << world.when();
    pairs += meant.size();
  }
  EXPECT_GT(pairs, 300U) << "counted on both sides";
}

INSTANTIATE_TEST_SUITE_P(CarpeNoctem, Specification,
                         testing::Values(Case{false, Said::as_scopes, Sayer::both, "PlainScopes"},
                                         Case{true, Said::as_scopes, Sayer::both, "MendedScopes"},
                                         Case{false, Said::as_conditions, Sayer::both, "PlainConditions"},
                                         Case{true, Said::as_conditions, Sayer::both, "MendedConditions"},
                                         Case{false, Said::as_scopes, Sayer::consumer, "PlainOfConsumers"},
                                         Case{true, Said::as_scopes, Sayer::consumer, "MendedOfConsumers"}),
                         [](const auto& one) { return one.param.in_words; });

TEST(SpecificationOfTheTeam, MeansMoreWithMendedNames) {
  const auto file = specification_file();
  if (!file) GTEST_SKIP() << "no carpe-noctem/modules.tsv in $GEMINGA_TEST_DATA or ../shared/data";
  const auto rows = read_specification(*file);
  const Post robot{"robot1-stat", of_a_robot};
  std::set<std::string> mended;
  for (const SpecificationRow& offered : rows) {
    for (const SpecificationRow& wanted : rows) {
      const Line provider{&robot, &offered, nullptr, 0};
      const Line consumer{&robot, &wanted, nullptr, 0};
      const auto is_pair = [&](bool is_mended) {
        return is_meant(provider, consumer, {is_mended, Said::as_scopes, Sayer::consumer, ""});
      };
      if (is_pair(true) && !is_pair(false)) mended.insert(offered.message + " for " + wanted.message);
    }
  }
  EXPECT_EQ(mended, std::set<std::string>{"KickerStat for KickStat"});
}

}  // namespace
}  // namespace geminga::sim
