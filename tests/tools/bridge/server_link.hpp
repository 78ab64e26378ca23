// Daemons that hear each other over a server alone: each has its loopback, and a bridge as its peer.
#ifndef GEMINGA_TESTS_TOOLS_BRIDGE_SERVER_LINK_HPP
#define GEMINGA_TESTS_TOOLS_BRIDGE_SERVER_LINK_HPP

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {

/// The server is on host 0, and a daemon with its bridge on each of three; a fourth host is for a site of several.
class ServerLink {
 public:
  static constexpr std::size_t hosts = 3;
  static constexpr std::size_t all_hosts = 4;

  /// `server`: the program and its words; `kind` and `url`: of the bridges.
  ServerLink(std::vector<std::string> server, std::string ready, std::string kind, std::string url)
      : server_words_(std::move(server)), ready_(std::move(ready)), kind_(std::move(kind)), url_(std::move(url)) {}

  [[nodiscard]] Lab& lab() { return lab_; }
  [[nodiscard]] Process& bridge(std::size_t host) { return *bridges_.at(host); }

  void make_key() {
    key_ = folder_.path("team.key");
    EXPECT_EQ(run({.words = {program("gemingad"), "--generate-key", key_}, .environment = {}, .before = {}}).status, 0);
  }
  void start_all() {
    start_server();
    make_key();
    for (std::size_t host = 0; host < hosts; ++host) {
      start_bridge(host);
      start_daemon(host);
    }
  }
  void start_server() {
    server_ = std::make_unique<Process>(lab_.on(0, server_words_));
    EXPECT_TRUE(server_->wait_for(ready_)) << server_->said();
  }
  void kill_server() { server_.reset(); }
  [[nodiscard]] Process& server() { return *server_; }
  /// Flags of the bridge of a host that is started after it.
  void give_flags(std::size_t host, std::vector<std::string> flags) { flags_.at(host) = std::move(flags); }
  void start_bridge(std::size_t host) {
    begin_bridge(host);
    EXPECT_TRUE(bridges_.at(host)->wait_for("carrying words by")) << bridges_.at(host)->said();
  }
  void begin_bridge(std::size_t host) {
    std::vector<std::string> words{program("geminga-bridge"), kind_, url_};
    words.insert(words.end(), flags_.at(host).begin(), flags_.at(host).end());
    bridges_.at(host) = std::make_unique<Process>(lab_.on(host, std::move(words)));
  }
  /// Starts a relay on host 0 that has a bridge and a crowd of so many participants behind it, and waits until it knows
  /// them.
  void start_crowd(std::size_t count) {
    start_bridge(0);
    lab_.start(0, {"--interface", "lo", "--peer", "127.0.0.1:4720", "--peer", "127.0.0.2:4717", "--interval", "0.1",
                   "--key-file", key_, "--relay"});
    crowd_ = std::make_unique<Process>(
        lab_.on(0, {program("crowd"), "127.0.0.2", "127.0.0.1", key_, std::to_string(count), "2"}));
    EXPECT_TRUE(lab_.wait_for_participants(0, count + 2)) << crowd_->said();
  }
  void kill_crowd() { crowd_.reset(); }
  /// A number of the daemon's `query status`; 0 where it says none.
  [[nodiscard]] std::size_t status(std::size_t host, const std::string& key) {
    Talk talk = lab_.talk(host);
    talk.say("1 query status");
    const auto line = talk.line_with({"1 msg status"});
    const std::string number = line ? field(*line, key) : "";
    return number.empty() ? 0 : std::stoul(number);
  }
  /// Waits until a relay has handed over so many words that are kept.
  [[nodiscard]] bool wait_until_kept(std::size_t host, std::size_t count) {
    return lab_.talk(host).wait_until("status", [count](const std::vector<std::string>& lines) {
      const std::string kept = lines.empty() ? "" : field(lines[0], "relay_kept");
      return !kept.empty() && std::stoul(kept) >= count;
    });
  }
  void kill_bridge(std::size_t host) { bridges_.at(host).reset(); }
  /// Starts a daemon of the site whose relays are the hosts that have a bridge.
  void start_on_site(std::size_t host) {
    std::vector<std::string> flags{"--interface", "wlan0", "--interval", "0.1", "--key-file", key_};
    if (bridges_.at(host) != nullptr)
      flags.insert(flags.end(), {"--interface", "lo", "--peer", "127.0.0.1:4720", "--relay"});
    lab_.start(host, flags);
  }
  /// Starts a daemon that has two bridges as its peers, each of which is a link.
  void start_between_two(std::size_t host) {
    lab_.start(host, {"--interface", "lo", "--peer", "127.0.0.1:4720", "--peer", "127.0.0.1:4721", "--interval", "0.1",
                      "--key-file", key_, "--relay"});
  }
  void start_daemon(std::size_t host) {
    const std::string file = folder_.write("daemon" + std::to_string(host) + ".toml",
                                           "announce-address = [\"lo=" + lab_.address_of(host) + "\"]\n");
    lab_.start(host, {"--config", file, "--interface", "lo", "--peer", "127.0.0.1:4720", "--interval", "0.1",
                      "--key-file", key_});
  }

 private:
  std::vector<std::string> server_words_;
  std::string ready_, kind_, url_, key_;
  Folder folder_;
  Lab lab_{all_hosts};
  std::unique_ptr<Process> server_;
  std::unique_ptr<Process> crowd_;
  std::array<std::unique_ptr<Process>, all_hosts> bridges_;
  std::array<std::vector<std::string>, all_hosts> flags_;
};

/// Each knows all, a service is told with the address of its host, and the dead are forgotten while the server is
/// killed, stays away and comes back.
inline void expect_team_over(ServerLink& link) {
  link.start_all();
  for (std::size_t host = 0; host < ServerLink::hosts; ++host) {
    EXPECT_TRUE(link.lab().wait_for_participants(host, 3)) << host << link.bridge(host).said();
  }
  Talk consumer = link.lab().talk(2);
  consumer.say("7 sub create mode=otm/stream text=ball");
  Talk provider = link.lab().talk(1);
  provider.say("4 pub create mode=otm/stream text=ball port=5000");
  const auto told = consumer.line_with({"7 pub add"});
  ASSERT_TRUE(told);
  EXPECT_EQ(field(*told, "address"), link.lab().address_of(1));
  provider.say("4 pub remove");
  EXPECT_TRUE(consumer.line_with({"7 pub del", "reason=withdrawn"}));

  link.kill_server();
  EXPECT_TRUE(link.lab().wait_for_participants(0, 1)) << "nobody is heard, and the site itself works on";
  provider.say("5 pub create mode=otm/stream text=ball port=5001");
  link.start_server();
  EXPECT_TRUE(consumer.line_with({"7 pub add", "port=5001"})) << link.bridge(1).said();

  link.server().signal(SIGSTOP);
  EXPECT_TRUE(consumer.line_with({"7 pub del", "reason=expired"})) << "a server that stands still keeps nobody alive";
  link.lab().daemon(1).signal(SIGKILL);
  EXPECT_TRUE(link.lab().wait_for_participants(0, 1));
  link.server().signal(SIGCONT);
  EXPECT_TRUE(link.lab().wait_for_participants(0, 2)) << "who lives is found, and who died meanwhile is not";
}

/// A host that has no bridge is found beyond the server, through the relay of its site.
inline void expect_site_over(ServerLink& link) {
  link.start_server();
  link.make_key();
  for (const std::size_t host : {0U, 2U}) link.start_bridge(host);
  for (const std::size_t host : {0U, 1U}) link.start_on_site(host);
  link.start_daemon(2);
  for (std::size_t host = 0; host < ServerLink::hosts; ++host) {
    EXPECT_TRUE(link.lab().wait_for_participants(host, 3)) << host;
  }
  Talk consumer = link.lab().talk(2);
  consumer.say("7 sub create mode=otm/stream text=ball");
  Talk provider = link.lab().talk(1);
  provider.say("4 pub create mode=otm/stream text=ball port=5000");
  const auto told = consumer.line_with({"7 pub add"});
  ASSERT_TRUE(told);
  EXPECT_EQ(field(*told, "address"), link.lab().address_of(1));
  link.lab().daemon(1).signal(SIGKILL);
  EXPECT_TRUE(consumer.line_with({"7 pub del", "reason=expired"}));
}

/// A newcomer is told of a site by what the server has kept; who has died meanwhile is not among them, also when the
/// server has begun anew and when the relay has.
inline void expect_newcomer_over(ServerLink& link) {
  constexpr std::size_t crowd = 40;
  link.start_server();
  link.make_key();
  link.start_crowd(crowd);
  EXPECT_TRUE(link.wait_until_kept(0, crowd + 1));
  link.start_bridge(2);
  link.start_daemon(2);
  EXPECT_TRUE(link.lab().wait_for_participants(2, crowd + 3));
  EXPECT_EQ(link.status(2, "recalled"), crowd + 1) << "all that the relay hears, and the relay itself has answered";
  Talk asker = link.lab().talk(2);
  asker.say("1 query participants");
  EXPECT_TRUE(asker.line_with({"name=r0 ", "hops=2 path=0f000000/robot0"})) << "the way is that of the testimony";

  link.lab().daemon(2).signal(SIGKILL);
  link.kill_server();
  link.start_server();
  EXPECT_TRUE(link.lab().wait_for_participants(0, crowd + 2));
  link.start_daemon(2);
  EXPECT_TRUE(link.lab().wait_for_participants(2, crowd + 3)) << "the server has lost nothing that lives";

  link.lab().daemon(2).signal(SIGKILL);
  link.kill_crowd();
  EXPECT_TRUE(link.lab().wait_for_participants(0, 1));
  link.start_daemon(2);
  EXPECT_TRUE(link.lab().wait_for_participants(2, 2)) << link.lab().daemon(2).said();
  EXPECT_EQ(link.status(2, "recalled"), 0U) << "nobody testifies for the dead";
}

/// Two hosts of a site are relays with a bridge each; one dies with both, and nobody beyond loses the site.
inline void expect_standby_over(ServerLink& link) {
  link.start_server();
  link.make_key();
  for (const std::size_t host : {0U, 1U, 3U}) link.start_bridge(host);
  for (const std::size_t host : {0U, 1U, 2U}) link.start_on_site(host);
  link.start_daemon(3);
  EXPECT_TRUE(link.lab().wait_for_participants(3, 4));
  Talk consumer = link.lab().talk(3);
  consumer.say("7 sub create mode=otm/stream text=ball");
  Talk provider = link.lab().talk(2);
  provider.say("4 pub create mode=otm/stream text=ball port=5000");
  EXPECT_TRUE(consumer.line_with({"7 pub add", "port=5000"}));
  link.kill_bridge(1);
  link.lab().daemon(1).signal(SIGKILL);
  EXPECT_TRUE(link.lab().wait_for_participants(3, 3)) << "the relay that died is forgotten at its deadline";
  provider.say("5 pub create mode=otm/stream text=ball port=5001");
  const auto next = consumer.line_with({"7 pub "});
  ASSERT_TRUE(next);
  EXPECT_EQ(field(*next, "port"), "5001") << "the host behind both was not lost meanwhile";
}

}  // namespace geminga::system

#endif
