// The metrics and alert rules as Debian's Prometheus sees them; skipped where it is not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>

#include "client/scripted_daemon.hpp"
#include "tools/clients/query.hpp"
#include "tools/web/reader.hpp"

namespace geminga::web {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* promtool = "/usr/bin/promtool";
constexpr const char* prometheus = "/usr/bin/prometheus";
const std::string monitoring = GEMINGA_SOURCE_DIR "/examples/monitoring/";

bool is_there() { return fs::exists(promtool) && fs::exists(prometheus); }

/// The output of a command, which has to succeed.
std::string said_by(std::vector<std::string> words) {
  const auto ran = system::run({.words = std::move(words), .environment = {}, .before = {}});
  EXPECT_EQ(ran.status, 0) << ran.said;
  return ran.said;
}

TEST(AlertRules, AreTakenByPromtoolAndFireWhenTheyShould) {
  if (!is_there()) GTEST_SKIP() << "Debian's prometheus is not installed";
  EXPECT_THAT(said_by({promtool, "check", "rules", monitoring + "geminga.rules.yml"}), HasSubstr("SUCCESS"));
  EXPECT_THAT(said_by({promtool, "test", "rules", monitoring + "geminga.rules_test.yml"}), HasSubstr("SUCCESS"));
  EXPECT_THAT(said_by({promtool, "check", "config", monitoring + "prometheus.yml"}), HasSubstr("SUCCESS"));
}

/// A folder of its own, removed at the end.
struct Folder {
  Folder() : path(fs::temp_directory_path() / ("geminga-prometheus-" + std::to_string(::getpid()))) {
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path path;
};

class Scraped : public tools::Query {
 protected:
  Reply get(std::uint16_t port, const std::string& target, const std::string& fields = "") {
    Reply reply;
    bench_.lab().visit(0, [&] { reply = web::get(port, target, fields); });
    return reply;
  }
  boost::json::value ask_prometheus(const std::string& target) {
    const Reply reply = get(prometheus_port_, target);
    EXPECT_EQ(reply.status, 200) << reply.body;
    return tools::parsed(reply.body);
  }
  /// The names of the alerts that fire.
  std::set<std::string> firing() {
    std::set<std::string> names;
    const auto document = ask_prometheus("/api/v1/alerts");
    for (const auto& alert : document.at("data").at("alerts").as_array()) {
      if (alert.at("state").as_string() == "firing") names.emplace(alert.at("labels").at("alertname").as_string());
    }
    return names;
  }
  /// Asks until these alerts fire and no others, as long as the test's patience lasts.
  testing::AssertionResult comes_to(const std::set<std::string>& wanted) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    std::set<std::string> found;
    while (std::chrono::steady_clock::now() < end) {
      found = firing();
      if (found == wanted) return testing::AssertionSuccess();
      ::poll(nullptr, 0, 100);  // Prometheus has nothing to wait on, and would answer nothing else meanwhile
    }
    return testing::AssertionFailure() << "firing at last: " << testing::PrintToString(found);
  }

  /// Asks until this alert fires, whatever else does.
  testing::AssertionResult comes_to_fire(const std::string& alert) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    std::set<std::string> found;
    while (std::chrono::steady_clock::now() < end) {
      found = firing();
      if (found.contains(alert)) return testing::AssertionSuccess();
      ::poll(nullptr, 0, 100);
    }
    return testing::AssertionFailure() << "firing at last: " << testing::PrintToString(found);
  }
  /// Keeps two of three datagrams of this participant from the host, which is known by the name.
  void lose_two_of_three(const std::string& name) {
    system::Talk asker = bench_.talk();
    std::string id;
    ASSERT_TRUE(asker.wait_until("participants", [&](const auto& lines) {
      for (const std::string& line : lines) {
        if (system::field(line, "name") == name) id = system::field(line, "id");
      }
      return !id.empty();
    }));
    // Its octets stand behind the UDP header and the first eight of an announcement, the lowest first.
    const std::string octets = id.substr(6, 2) + id.substr(4, 2) + id.substr(2, 2) + id.substr(0, 2);
    const auto ran = system::run(
        bench_.lab().on(0, {"/usr/sbin/nft",
                            "add table inet air; add chain inet air in { type filter hook input priority 0; }; "
                            "add rule inet air in udp dport 4717 @th,128,32 0x" +
                                octets + " numgen inc mod 3 < 2 drop"}));
    ASSERT_EQ(ran.status, 0) << ran.said;
  }

  void serve() {
    web_ = bench_.start("geminga-web", {"--listen", "127.0.0.1:" + std::to_string(web_port_)});
    ASSERT_TRUE(web_->wait_for("serving"));
  }
  void start_prometheus() {
    std::ofstream(folder_.path / "prometheus.yml")
        << "global: {scrape_interval: 500ms, evaluation_interval: 500ms}\nrule_files: [" << monitoring
        << "geminga.rules.yml]\nscrape_configs: [{job_name: geminga, static_configs: [{targets: ['127.0.0.1:"
        << web_port_ << "']}]}]\n";
    prometheus_ = bench_.start(
        prometheus, {"--config.file", folder_.path / "prometheus.yml", "--storage.tsdb.path", folder_.path / "data",
                     "--web.listen-address", "127.0.0.1:" + std::to_string(prometheus_port_)});
    ASSERT_TRUE(prometheus_->wait_for("Server is ready to receive web requests"));
  }

  Folder folder_;
  std::uint16_t web_port_ = client::free_port();
  std::uint16_t prometheus_port_ = client::free_port();
  std::unique_ptr<system::Process> web_;
  std::unique_ptr<system::Process> prometheus_;
};

TEST_F(Scraped, IsTakenByPromtool) {
  if (!is_there()) GTEST_SKIP() << "Debian's prometheus is not installed";
  serve();
  const Reply metrics = get(web_port_, "/metrics", "Accept: text/plain\r\n");
  EXPECT_EQ(metrics.fields.at("content-type"), "text/plain; version=0.0.4; charset=utf-8");
  std::ofstream(folder_.path / "metrics") << metrics.body;
  said_by({"/bin/sh", "-c", std::string(promtool) + " check metrics <" + (folder_.path / "metrics").string()});
}

TEST_F(Scraped, RaisesEachOfTheAlertsThatShip) {
  if (!is_there()) GTEST_SKIP() << "Debian's prometheus is not installed";
  serve();
  start_prometheus();
  // The request for 77 is there from the start, and nobody serves it.
  ASSERT_TRUE(comes_to({"GemingaRequestUnmatched"}));
  const auto targets = ask_prometheus("/api/v1/targets");
  EXPECT_EQ(targets.at("data").at("activeTargets").at(0).at("health").as_string(), "up");
  EXPECT_EQ(targets.at("data").at("activeTargets").at(0).at("lastError").as_string(), "");
  const auto types = ask_prometheus("/api/v1/metadata?metric=geminga_matches");
  EXPECT_EQ(types.at("data").at("geminga_matches").at(0).at("type").as_string(), "counter")
      << "it was read as OpenMetrics";
  peer_.say("9 pub create mode=oto id=77 port=5077");
  ASSERT_TRUE(comes_to({}));
  bench_.stop_daemon();
  ASSERT_TRUE(comes_to({"GemingaDaemonAway"}));
  bench_.start_daemon();
  ASSERT_TRUE(comes_to({}));
  if (!bench_.lab().has_namespaces()) return;  // another team may be heard on this link
  auto other = bench_.start("gemingad", {"--name", "other", "--interval", "0.05", "--gcnp",
                                         "127.0.0.1:" + std::to_string(client::free_port()), "--ontology",
                                         GEMINGA_SOURCE_DIR "/ontology/robot-soccer.ttl"});
  ASSERT_TRUE(comes_to({"GemingaOntologiesDiffer"}));
  if (system::Lab::can_lose()) {
    lose_two_of_three("other");
    ASSERT_TRUE(comes_to_fire("GemingaLossHigh"));
  }
  other->signal(SIGKILL);
  ASSERT_TRUE(comes_to({"GemingaRobotGone"})) << "it said no goodbye";
  const std::string key = folder_.path / "team.key";
  ASSERT_EQ(bench_.run("gemingad", {"--generate-key", key}).status, 0);
  const auto sealed = bench_.start("gemingad", {"--name", "sealed", "--key-file", key, "--gcnp",
                                                "127.0.0.1:" + std::to_string(client::free_port())});
  ASSERT_TRUE(comes_to_fire("GemingaKeyMissing")) << "this host has no key";
}

}  // namespace
}  // namespace geminga::web
