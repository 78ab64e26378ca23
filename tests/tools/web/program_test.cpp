// geminga-web as a user runs it, beside a real daemon and geminga-query.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "client/scripted_daemon.hpp"
#include "tools/clients/query.hpp"
#include "tools/web/reader.hpp"

namespace geminga::web {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using tools::Outcome;

/// Members that differ between two answers to the same question.
constexpr std::array restless{"age",    "uptime", "statements",  "clients",        "peers",      "users",      "cpu",
                              "memory", "heard",  "peak_memory", "datagrams_sent", "bytes_sent", "peer_count", "seen"};

void calm(boost::json::value& value) {
  if (auto* array = value.if_array()) {
    for (auto& element : *array) calm(element);
  }
  if (auto* object = value.if_object()) {
    for (auto& member : *object) {
      if (std::ranges::find(restless, member.key()) != restless.end()) member.value() = nullptr;
      calm(member.value());
    }
  }
}

/// A document as text, in which what is restless is null; the order of its members counts.
std::string calmed(const std::string& text) {
  auto value = tools::parsed(text);
  calm(value);
  return boost::json::serialize(value);
}

class Program : public tools::Query {
 protected:
  void serve(std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {"--listen", "127.0.0.1:" + std::to_string(port_)});
    web_ = bench_.start("geminga-web", flags);
    ASSERT_TRUE(web_->wait_for("geminga-web: serving http://127.0.0.1:" + std::to_string(port_) + "/\n"));
  }
  Reply get(const std::string& target, const std::string& fields = "") {
    Reply reply;
    bench_.lab().visit(0, [&] { reply = web::get(port_, target, fields); });
    return reply;
  }
  Reader reader() {
    std::optional<Reader> made;
    bench_.lab().visit(0, [&] { made.emplace(port_); });
    return std::move(*made);
  }
  /// Asks until the answer has this status, as long as the test's patience lasts.
  testing::AssertionResult comes_to(const std::string& target, int status) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    Reply reply;
    while (std::chrono::steady_clock::now() < end) {
      reply = get(target);
      if (reply.status == status) return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << reply.status << ' ' << reply.body;
  }

  /// The answers of both, given while the page's stays the same. The doctor finds more after some time.
  std::pair<Reply, std::string> page_and_program(const std::string& target, const std::vector<std::string>& line) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    Reply after = get(target);
    Reply before;
    std::string said;
    do {
      before = std::move(after);
      said = bench_.query(line).out;
      after = get(target);
    } while (calmed(before.body) != calmed(after.body) && std::chrono::steady_clock::now() < end);
    return {before, said};
  }

  std::uint16_t port_ = client::free_port();
  std::unique_ptr<system::Process> web_;
};

TEST_F(Program, SaysWhatGemingaQuerySays) {
  serve();
  ASSERT_TRUE(comes_to("/readyz", 200));
  const std::string request = word({"requests", "id=77"}, "subscription");
  const std::string service = word({"services", "lonely"}, "service");
  const std::vector<std::pair<std::string, std::vector<std::string>>> questions{
      {"/api/status", {"status"}},  // first, since it counts the expressions of the others
      {"/api/participants", {"participants"}},
      {"/api/services", {"services"}},
      {"/api/services?unused=1", {"services", "--unused"}},
      {"/api/services?mode=oto", {"services", "mode=oto"}},
      {"/api/services?concept=soccer:TrackedObject", {"services", "concept=soccer:TrackedObject"}},
      {"/api/requests", {"requests"}},
      {"/api/requests?unmatched=1", {"requests", "--unmatched"}},
      {"/api/match?concept=soccer:TrackedObject&limit=1", {"match", "soccer:TrackedObject", "--limit", "1"}},
      {"/api/match?text=nothing", {"match", "--text", "nothing"}},
      {"/api/match?concept=soccer:BallInfo%20or%20soccer:GoalInfo&where=rate+%3E+10",
       {"match", "soccer:BallInfo or soccer:GoalInfo", "--where", "rate > 10"}},
      {"/api/explain?sub=soccer:SharedBallInfo&super=soccer:TrackedObject",
       {"explain", "soccer:SharedBallInfo", "soccer:TrackedObject"}},
      {"/api/explain?sub=soccer:TrackedObject&super=soccer:SharedBallInfo",
       {"explain", "soccer:TrackedObject", "soccer:SharedBallInfo"}},
      {"/api/why?subscription=" + request, {"why", request}},
      {"/api/why?subscription=" + request + "&service=" + service, {"why", request, service}},
      {"/api/why?service=" + service, {"why", "--service", service}},
      {"/api/why?concept=soccer:TrackedObject&offer.text=a",
       {"why", "--concept", "soccer:TrackedObject", "--offer-text", "a"}},
      {"/api/ontology", {"ontology"}},
      {"/api/security", {"security"}},
      {"/api/doctor", {"doctor"}}};
  for (const auto& [target, words] : questions) {
    std::vector<std::string> line = words;
    line.emplace_back("--json");
    const auto [reply, said] = page_and_program(target, line);
    EXPECT_EQ(reply.status, 200) << target << reply.body;
    EXPECT_EQ(reply.fields.at("content-type"), "application/json");
    EXPECT_EQ(calmed(reply.body), calmed(said)) << target;
  }
}

TEST_F(Program, RefusesWithTheDaemonsWords) {
  serve();
  ASSERT_TRUE(comes_to("/readyz", 200));
  const Reply unknown = get("/api/match?concept=soccer:BalInfo");
  EXPECT_EQ(unknown.status, 422);
  EXPECT_THAT(unknown.body, HasSubstr("soccer:BalInfo"));
  EXPECT_EQ(get("/api/why?subscription=00000000/1/1").status, 404);
  EXPECT_EQ(get("/api/match?id=x").status, 400);
  EXPECT_EQ(get("/api/match?where=%28%28%28").status, 422);
}

TEST_F(Program, TellsWhatWatchTells) {
  serve();
  ASSERT_TRUE(comes_to("/readyz", 200));
  Reader events = reader();
  ASSERT_TRUE(events.send(get_request("/api/events?of=services&text=new")));
  ASSERT_TRUE(events.reply());
  const auto watch = bench_.start("geminga-query", {"--watch", "--json", "services", "text=new"});
  const auto both_tell = [&](const std::string& text) { return events.wait_for(text) && watch->wait_for(text); };
  peer_.say("8 pub create mode=oto text=new port=5008 rate=3");
  ASSERT_TRUE(events.wait_for("data: "));
  ASSERT_TRUE(both_tell("{\"event\":\"add\",\"time\":\""));
  ASSERT_TRUE(both_tell("\"text\":\"new\",\"mode\":\"oto\","));
  ASSERT_TRUE(
      both_tell("\"port\":5008,\"protocol\":\"udp\",\"priority\":0,\"age\":0,\"local\":true,\"used\":false,"
                "\"attributes\":{\"rate\":\"3\"}}\n"));
  peer_.say("8 pub modify rate=4");
  ASSERT_TRUE(both_tell("{\"event\":\"modify\",\"time\":\""));
  ASSERT_TRUE(both_tell("\"former\":{\"attributes\":{\"rate\":\"3\"}},\"service\":\""));
  peer_.say("8 pub remove");
  ASSERT_TRUE(both_tell("{\"event\":\"del\",\"time\":\""));
  ASSERT_TRUE(both_tell("\"reason\":\"withdrawn\",\"service\":\""));
}

TEST_F(Program, IsReadyWhileTheDaemonIs) {
  serve({"--timeout", "0.5"});
  ASSERT_TRUE(comes_to("/readyz", 200));
  Reader events = reader();
  ASSERT_TRUE(events.send(get_request("/api/events?of=participants")));
  ASSERT_TRUE(events.wait_for("\"event\":\"add\""));
  bench_.stop_daemon();
  ASSERT_TRUE(comes_to("/readyz", 503));
  ASSERT_TRUE(events.wait_for("event: daemon\ndata: {\"up\":false,\"reason\":\""));
  EXPECT_THAT(get("/metrics").body, HasSubstr("\ngeminga_up 0\n"));
  EXPECT_EQ(get("/api/status").status, 503);
  EXPECT_EQ(get("/livez").status, 200);
  bench_.start_daemon();
  ASSERT_TRUE(comes_to("/readyz", 200));
  ASSERT_TRUE(events.wait_for("event: daemon\ndata: {\"up\":true}\n\n"));
  ASSERT_TRUE(events.wait_for("\"event\":\"add\"")) << "it is another participant";
}

TEST_F(Program, AnswersWhileTheDaemonIsStopped) {
  serve({"--timeout", "0.2"});
  ASSERT_TRUE(comes_to("/readyz", 200));
  bench_.lab().daemon(0).signal(SIGSTOP);
  ASSERT_TRUE(comes_to("/readyz", 503));
  EXPECT_EQ(get("/livez").status, 200);
  bench_.lab().daemon(0).signal(SIGCONT);
  EXPECT_TRUE(comes_to("/readyz", 200));
}

TEST_F(Program, IsNotReadyWithAnOntologyThatCannotBeRead) {
  const auto folder = std::filesystem::temp_directory_path() / ("geminga-web-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const std::string file = folder / "team.ttl";
  std::ofstream(file) << "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n<urn:a> a owl:Class .\n";
  tools::Bench bench({"--ontology", file});
  const std::string port = std::to_string(port_);
  const auto web = bench.start("geminga-web", {"--listen", "127.0.0.1:" + port});
  ASSERT_TRUE(web->wait_for("serving"));
  const auto ready = [&] {
    Reply reply;
    bench.lab().visit(0, [&] { reply = web::get(port_, "/readyz"); });
    return reply;
  };
  const auto until = [&](int status) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    while (ready().status != status && std::chrono::steady_clock::now() < end) {
    }
    return ready().status == status;
  };
  ASSERT_TRUE(until(200)) << ready().body;
  std::ofstream(file) << "this is no Turtle";
  bench.lab().daemon(0).signal(SIGHUP);
  ASSERT_TRUE(until(503));
  EXPECT_THAT(ready().body, HasSubstr("ontologies "));
  std::filesystem::remove_all(folder);
}

TEST_F(Program, CannotBeAskedByAnotherSite) {
  serve();
  Reader wrong = reader();
  ASSERT_TRUE(wrong.send("GET /api/status HTTP/1.1\r\nHost: evil.example\r\n\r\n"));
  EXPECT_EQ(wrong.reply()->status, 421);
  Reader named = reader();
  ASSERT_TRUE(named.send("GET /livez HTTP/1.1\r\nHost: robot2.local:4780\r\n\r\n"));
  EXPECT_EQ(named.reply()->status, 421);
}

TEST_F(Program, LetsInTheNamesOfItsFlags) {
  serve({"--host", "robot2.local", "--host", "robot2"});
  for (const char* host : {"robot2.local:4780", "Robot2", "localhost"}) {
    Reader named = reader();
    ASSERT_TRUE(named.send("GET /livez HTTP/1.1\r\nHost: " + std::string(host) + "\r\n\r\n"));
    EXPECT_EQ(named.reply()->status, 200) << host;
  }
}

/// A file with a secret, removed at the end.
struct TokenFile {
  explicit TokenFile(mode_t mode, const std::string& text = "0123456789abcdef0123456789abcdef\n")
      : path(std::filesystem::temp_directory_path() / ("geminga-web-token-" + std::to_string(::getpid()))) {
    std::ofstream(path) << text;
    ::chmod(path.c_str(), mode);
  }
  ~TokenFile() { std::filesystem::remove(path); }
  TokenFile(const TokenFile&) = delete;
  TokenFile& operator=(const TokenFile&) = delete;
  std::filesystem::path path;
};

TEST_F(Program, AsksForItsTokenWhereItHasOne) {
  const TokenFile token(0600);
  serve({"--token-file", token.path});
  EXPECT_EQ(get("/livez").status, 200);
  const Reply refusal = get("/metrics");
  EXPECT_EQ(refusal.status, 401);
  EXPECT_EQ(refusal.fields.at("www-authenticate"), "Bearer");
  EXPECT_EQ(get("/metrics", "Authorization: Bearer 0123456789abcdef0123456789abcdee\r\n").status, 401);
  EXPECT_EQ(get("/metrics", "Authorization: Bearer 0123456789abcdef0123456789abcdef\r\n").status, 200);
}

TEST_F(Program, DoesNotStartOpenToOthersWithoutASecret) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& reason) {
    const Outcome outcome = bench_.run("geminga-web", words);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
    EXPECT_THAT(outcome.errors, HasSubstr(reason));
    EXPECT_EQ(outcome.out, "");
  };
  refused({"--listen", "0.0.0.0:4780"}, "other hosts reach 0.0.0.0: give --token-file");
  refused({"--listen", "[::]:4780"}, "other hosts reach ::: give --token-file");
  refused({"--listen", "192.0.2.7:4780"}, "give --token-file");
  refused({"--listen", "localhost:4780"}, "--listen: 'localhost' is no IP address");
  refused({"--listen", "127.0.0.1"}, "--listen: ");
  refused({"--host", "a b"}, "is no name of a host");
  refused({"--connect", "nowhere"}, "is no address of a daemon");
  refused({"--token-file", "/nonexistent/token"}, "No such file");
  refused({"--token-file", "/tmp"}, "is no file that can be read");
  refused({"--bogus"}, "--bogus");
  for (const mode_t mode : {0640U, 0604U, 0620U, 0602U}) {
    const TokenFile token(mode);
    refused({"--token-file", token.path}, "can be read or changed by others: chmod 600 ");
  }
  for (const char* text : {"", "short", "  \n", "0123456789abcdef 0123456789abcdef"}) {
    const TokenFile token(0600, text);
    refused({"--token-file", token.path}, "the token has ");
  }
}

TEST_F(Program, ServesAtAUnixSocketAloneWhereItIsTold) {
  const std::string path =
      std::filesystem::temp_directory_path() / ("geminga-web-" + std::to_string(::getpid()) + ".socket");
  web_ = bench_.start("geminga-web", {"--socket", path});
  ASSERT_TRUE(web_->wait_for("geminga-web: serving " + path + "\n"));
  Reader at_path(path);
  ASSERT_TRUE(at_path.send(get_request("/livez")));
  EXPECT_EQ(at_path.reply()->status, 200);
  struct stat status{};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0660U);
  web_->signal(SIGTERM);
  EXPECT_EQ(web_->wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Program, EndsAtASignalWithReadersThere) {
  serve();
  ASSERT_TRUE(comes_to("/readyz", 200));
  Reader events = reader();
  ASSERT_TRUE(events.send(get_request("/api/events?of=services")));
  ASSERT_TRUE(events.wait_for("\"event\":\"add\""));
  web_->signal(SIGINT);
  EXPECT_EQ(web_->wait(), 0);
  EXPECT_TRUE(events.is_closed());
}

TEST_F(Program, HasHelpAndAVersion) {
  const Outcome help = bench_.run("geminga-web", {"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* text :
       {"--listen ADDRESS:PORT", "--token-file FILE", "127.0.0.1:4780", "Examples:\n", "Exit status: 0"}) {
    EXPECT_THAT(help.out, HasSubstr(text));
  }
  const Outcome version = bench_.run("geminga-web", {"--version"});
  EXPECT_THAT(version.out, StartsWith("geminga-web 1."));
  EXPECT_EQ(version.status, 0);
}

TEST_F(Program, CountsLossesMatchesAndOtherOntologies) {
  serve();
  ASSERT_TRUE(comes_to("/readyz", 200));
  const std::string metrics = get("/metrics").body;
  EXPECT_THAT(metrics, HasSubstr("\ngeminga_matches_total{degree=\"narrower\"} 1\n"));
  EXPECT_THAT(metrics, HasSubstr("\ngeminga_participants_lost_total 0\n"));
  EXPECT_THAT(metrics, HasSubstr("\ngeminga_requests_unmatched 1\n"));
  EXPECT_THAT(metrics, HasSubstr("identity=\"77\",why=\"nobody\"} 1\n"));
  EXPECT_THAT(metrics, EndsWith("# EOF\n"));
}

}  // namespace
}  // namespace geminga::web
