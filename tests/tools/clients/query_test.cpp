// geminga-query against a real daemon: the output of each command in words and in JSON, and its exit status.
#include "tools/clients/query.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(Query, ListsParticipants) {
  const auto shown = bench_.query({"participants"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, HasSubstr("robot0"));
  const auto all = bench_.json({"participants"});
  ASSERT_EQ(all.as_array().size(), 1U);
  const auto& self = all.at(0).as_object();
  EXPECT_EQ(self.at("name"), "robot0");
  EXPECT_EQ(self.at("self"), true);
  EXPECT_EQ(self.at("publications").as_int64(), 2);
  EXPECT_EQ(self.at("subscriptions").as_int64(), 2);
  EXPECT_TRUE(self.at("addresses").is_array());
  EXPECT_TRUE(self.at("id").is_string());
  EXPECT_TRUE(self.at("interval").is_number());
}

TEST_F(Query, ListsServices) {
  const auto shown = bench_.query({"services"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, StartsWith("PROVIDER"));
  EXPECT_THAT(shown.out, HasSubstr("vision@robot0"));
  EXPECT_THAT(shown.out, HasSubstr("soccer:SharedBallInfo"));
  EXPECT_THAT(shown.out, HasSubstr("lens=\"wide angle\" rate=30"));
  EXPECT_THAT(shown.out, HasSubstr("10.0.0.9:5001"));
  const auto ball = bench_.json({"services", "mode=otm/stream"}).at(0).as_object();
  EXPECT_EQ(ball.at("concept"), "soccer:SharedBallInfo");
  EXPECT_EQ(ball.at("port").as_int64(), 5000);
  EXPECT_EQ(ball.at("priority").as_int64(), 3);
  EXPECT_EQ(ball.at("used"), true);
  EXPECT_EQ(ball.at("attributes").at("rate"), "30");
}

TEST_F(Query, FiltersServicesByWords) {
  const auto count = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "services");
    return bench_.json(words).as_array().size();
  };
  EXPECT_EQ(count({}), 2U);
  EXPECT_EQ(count({"lonely"}), 1U);
  EXPECT_EQ(count({"vision"}), 2U);
  EXPECT_EQ(count({"vision", "wide"}), 1U);
  EXPECT_EQ(count({"rate=30"}), 1U);
  EXPECT_EQ(count({"rate=31"}), 0U);
  EXPECT_EQ(count({"mode=oto"}), 1U);
  EXPECT_EQ(count({"concept=soccer:TrackedObject"}), 1U);
  EXPECT_EQ(count({"provider=robot0/vision"}), 2U);
  EXPECT_EQ(count({"provider=robot1"}), 0U);
  const auto nothing = bench_.query({"services", "nowhere"});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_THAT(nothing.out, IsEmpty());
  EXPECT_THAT(nothing.errors, StartsWith("geminga-query: no such service is known: "));
  EXPECT_EQ(bench_.query({"services", "mode=otm"}).status, 2) << "the daemon's 400";
}

TEST_F(Query, ListsRequestsAndWhatIsMissingOrLeftOver) {
  EXPECT_EQ(bench_.json({"requests"}).as_array().size(), 2U);
  const auto unmatched = bench_.json({"requests", "--unmatched"}).as_array();
  ASSERT_EQ(unmatched.size(), 1U);
  EXPECT_EQ(unmatched.at(0).at("id").as_int64(), 77);
  EXPECT_EQ(unmatched.at(0).at("served"), false);
  const auto unused = bench_.json({"requests", "--unused"}).as_array();
  ASSERT_EQ(unused.size(), 1U);
  EXPECT_EQ(unused.at(0).at("text"), "lonely");
  EXPECT_THAT(bench_.query({"requests"}).out, HasSubstr("rate > 10"));
  peer_.say("4 sub remove");
  peer_.say("2 pub remove");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  EXPECT_EQ(bench_.query({"requests", "--unmatched"}).status, 1);
  EXPECT_EQ(bench_.query({"requests", "--unused"}).status, 1);
}

TEST_F(Query, RanksWhatMatches) {
  peer_.say("5 pub create mode=oto concept=soccer:TrackedObject port=5002");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  const auto both = bench_.json({"match", "soccer:TrackedObject"}).as_array();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both.at(0).at("degree"), "narrower") << "priority is the first of arbitration";
  EXPECT_EQ(both.at(1).at("degree"), "exact");
  EXPECT_EQ(both.at(1).at("distance").as_int64(), 0);
  EXPECT_EQ(bench_.json({"match", "soccer:TrackedObject", "--degree", "exact"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "soccer:TrackedObject", "--mode", "otm/stream"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "soccer:TrackedObject", "--limit", "1"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "soccer:TrackedObject", "--where", "rate = 30"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "--text", "lonely"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match"}).as_array().size(), 3U);
  EXPECT_THAT(bench_.query({"match", "soccer:TrackedObject"}).out, StartsWith("DEGREE"));
  EXPECT_EQ(bench_.query({"match", "--id", "0x4d"}).status, 1) << "asked for, and not offered";
}

TEST_F(Query, EndsWithTwoOnANameThatTheOntologyDoesNotKnow) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"match", "soccer:Bal"},
                                                {"match", "soccer:BallInfo", "--representation", "soccer:Bal"},
                                                {"explain", "soccer:Bal", "soccer:BallInfo"},
                                                {"match", "soccer:BallInfo", "--where", "rate >"},
                                                {"services", "concept=soccer:Bal"}}) {
    const auto outcome = bench_.query(words);
    EXPECT_EQ(outcome.status, 2) << words[1];
    EXPECT_THAT(outcome.errors, StartsWith("geminga-query: ")) << words[1];
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST_F(Query, ExplainsWithTheAxiomsAndWhereTheyStand) {
  const auto yes = bench_.query({"explain", "soccer:SharedBallInfo", "soccer:TrackedObject"});
  EXPECT_EQ(yes.status, 0);
  EXPECT_THAT(yes.out, StartsWith("yes: "));
  EXPECT_THAT(yes.out, HasSubstr("soccer:SharedBallInfo SubClassOf soccer:BallInfo"));
  EXPECT_THAT(yes.out, HasSubstr("robot-soccer.ttl:"));
  const auto no = bench_.query({"explain", "soccer:TrackedObject", "soccer:SharedBallInfo"});
  EXPECT_EQ(no.status, 1);
  EXPECT_THAT(no.out, StartsWith("no: soccer:TrackedObject is not subsumed by soccer:SharedBallInfo\n"));
  const auto in_full =
      bench_.query({"explain", "<https://geminga.example/soccer#TrackedObject>", "soccer:SharedBallInfo"});
  EXPECT_EQ(in_full.out, no.out) << "names are printed short, however they were asked for";
  const auto document = bench_.json({"explain", "soccer:SharedBallInfo", "soccer:TrackedObject"});
  EXPECT_EQ(document.at("subsumed"), true);
  EXPECT_GE(document.at("axioms").as_array().size(), 2U);
  EXPECT_TRUE(document.at("axioms").at(0).at("line").is_int64());
  EXPECT_EQ(bench_.json({"explain", "soccer:TrackedObject", "soccer:SharedBallInfo"}).at("subsumed"), false);
}

TEST_F(Query, TellsOfTheOntologyAndTheStatus) {
  const auto ontology = bench_.query({"ontology"});
  EXPECT_EQ(ontology.status, 0);
  EXPECT_THAT(ontology.out, HasSubstr("robot-soccer.ttl"));
  const auto loaded = bench_.json({"ontology"});
  EXPECT_EQ(loaded.at("loaded"), true);
  EXPECT_GE(loaded.at("files").as_array().size(), 3U);
  EXPECT_GT(loaded.at("classes").as_int64(), 100);
  EXPECT_EQ(bench_.query({"status"}).status, 0);
  const auto status = bench_.json({"status"});
  EXPECT_EQ(status.at("state"), "ready");
  EXPECT_TRUE(status.at("uptime").is_number());
  EXPECT_TRUE(status.at("participant").is_string());
}

TEST_F(Query, PrintsNothingThatATerminalCouldObey) {
  peer_.say("6 pub create mode=oto text=\"\u009b31mred\u202e\" port=1 note=\"\u2066\"");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  const auto shown = bench_.query({"services"});
  const auto document = bench_.query({"services", "--json"});
  for (const char* harmful : {"\u009b", "\u202e", "\u2066", "\x1b"}) {
    EXPECT_THAT(shown.out, Not(HasSubstr(harmful)));
    EXPECT_THAT(document.out, Not(HasSubstr(harmful)));
  }
  EXPECT_THAT(shown.out, HasSubstr("\ufffd31mred\ufffd"));
  const auto services = parsed(document.out);
  bool is_faithful = false;
  for (const auto& service : services.as_array()) {
    const auto* text = service.as_object().if_contains("text");
    is_faithful = is_faithful || (text != nullptr && *text == "\u009b31mred\u202e");
  }
  EXPECT_TRUE(is_faithful) << document.out;
}

TEST_F(Query, FindsServicesByTheConceptThatTheyServe) {
  const auto count = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "services");
    return bench_.json(words).as_array().size();
  };
  EXPECT_EQ(count({"soccer:TrackedObject"}), 1U) << "what it subsumes";
  EXPECT_EQ(count({"soccer:SharedBallInfo"}), 1U);
  EXPECT_EQ(count({"soccer:TrackedObject", "rate=30"}), 1U);
  EXPECT_EQ(count({"soccer:TrackedObject", "lonely"}), 0U);
  peer_.say("5 pub create mode=oto concept=soccer:GoalInfo representation=soccer:CartesianFieldFrame port=5002");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  EXPECT_EQ(count({"soccer:CartesianFieldFrame"}), 1U) << "where the name occurs";
  const auto mistyped = bench_.query({"services", "soccer:Bal"});
  EXPECT_EQ(mistyped.status, 2);
  EXPECT_THAT(mistyped.errors, HasSubstr("soccer:Bal"));
}

TEST_F(Query, ListsUnusedServicesByBothCommands) {
  EXPECT_EQ(bench_.query({"services", "--unused"}).out, bench_.query({"requests", "--unused"}).out);
  const auto unused = bench_.json({"services", "--unused"}).as_array();
  ASSERT_EQ(unused.size(), 1U);
  EXPECT_EQ(unused.at(0).at("text"), "lonely");
  EXPECT_EQ(bench_.query({"services", "--unused", "soccer:TrackedObject"}).status, 1);
}

TEST_F(Query, SaysThatNothingHasAKey) {
  const auto odd = bench_.query({"services", "rat=30"});
  EXPECT_EQ(odd.status, 1);
  EXPECT_THAT(odd.errors,
              StartsWith("geminga-query: nothing that is known has a column or attribute 'rat' (did you mean rate?): "
                         "there are "));
  EXPECT_EQ(bench_.query({"services", "attr.rate=30"}).status, 0);
  EXPECT_EQ(bench_.query({"services", "attr.port=5000"}).status, 1) << "a column is no attribute";
  EXPECT_THAT(odd.errors, HasSubstr(", rate, "));
  EXPECT_THAT(bench_.query({"services", "rat=30", "--json"}).errors, HasSubstr("'rat'"));
  EXPECT_THAT(bench_.query({"services", "rate=31"}).errors, HasSubstr("no such service is known"));
}

TEST_F(Query, MatchesAnIdentityInTheWordsOfGcnp) {
  EXPECT_EQ(bench_.json({"match", "text=lonely"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "concept=soccer:TrackedObject"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.json({"match", "--concept", "soccer:TrackedObject"}).as_array().size(), 1U);
  EXPECT_EQ(bench_.query({"match", "id=77"}).status, 1);
  const auto attribute = bench_.query({"match", "soccer:TrackedObject", "rate=30"});
  EXPECT_EQ(attribute.status, 2);
  EXPECT_THAT(attribute.errors, HasSubstr("--where 'rate = 30'"));
  EXPECT_EQ(bench_.query({"match", "soccer:BallInfo", "soccer:GoalInfo"}).status, 2);
  EXPECT_EQ(bench_.query({"match", "text=a", "--text", "b"}).status, 2);
}

TEST_F(Query, EndsWithTwoWhenItsOutputCannotBeWritten) {
  auto start =
      bench_.lab().on(0, {"/bin/sh", "-c", "exec \"$0\" services > /dev/full", system::program("geminga-query")});
  start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(bench_.lab().gcnp_port(0))}};
  const auto ran = system::run(start);
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.said, "geminga-query: standard output cannot be written: is the disk full?\n");
}

TEST(QueryWithoutOntology, SaysSo) {
  system::Lab lab(1);
  lab.start(0);
  auto start = lab.on(0, {system::program("geminga-query"), "ontology"});
  start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(lab.gcnp_port(0))}};
  const auto ran = system::run(start);
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.said, HasSubstr("start gemingad with --ontology"));
}

TEST_F(Query, ShowsThatNothingIsSealedWhereThereIsNoKey) {
  const auto shown = bench_.query({"security"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, HasSubstr("Nothing is sealed: there is no key."));
  const auto all = bench_.json({"security"});
  EXPECT_EQ(all.at("mode"), "plain");
  for (const char* list : {"keys", "datagrams", "participants", "rejected"})
    EXPECT_TRUE(all.at(list).is_array()) << list;
}

TEST(QueryOfSealed, ShowsModeAndKeysAndNeverAKey) {
  std::string folder = std::filesystem::temp_directory_path() / "geminga-query-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string file = folder + "/team.key";
  const system::Ran made =
      system::run({.words = {system::program("gemingad"), "--generate-key", file}, .environment = {}, .before = {}});
  ASSERT_EQ(made.status, 0) << made.said;
  const std::string id = made.said.substr(made.said.find(": key ") + 6, 4);
  Bench bench({"--key-file", file});
  const auto shown = bench.query({"security"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_THAT(shown.out, HasSubstr("Mode encrypted: this host sends datagrams sealed with key " + id));
  const auto all = bench.json({"security"});
  EXPECT_EQ(all.at("mode"), "encrypted");
  EXPECT_EQ(all.at("keys").at(0), id.c_str());
  EXPECT_EQ(bench.json({"status"}).at("sealing"), "encrypted");
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string secret = text.str().substr(text.str().find("\nkey ") + 10);
  secret.resize(40);
  EXPECT_THAT(shown.out + bench.query({"--json", "security"}).out, Not(HasSubstr(secret)));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace geminga::tools
