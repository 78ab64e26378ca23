// Daemons that hear each other over a server alone: each has its loopback, and a bridge as its peer.
#ifndef GEMINGA_TESTS_TOOLS_BRIDGE_SERVER_LINK_HPP
#define GEMINGA_TESTS_TOOLS_BRIDGE_SERVER_LINK_HPP

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {

/// The server is on host 0, and a daemon with its bridge on each of three.
class ServerLink {
 public:
  static constexpr std::size_t hosts = 3;

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
  void start_bridge(std::size_t host) {
    bridges_.resize(hosts);
    bridges_.at(host) = std::make_unique<Process>(lab_.on(host, {program("geminga-bridge"), kind_, url_}));
    EXPECT_TRUE(bridges_.at(host)->wait_for("carrying words by")) << bridges_.at(host)->said();
  }
  void kill_bridge(std::size_t host) { bridges_.at(host).reset(); }
  /// Starts a daemon of the site that host 0 is the relay of, without a bridge of its own unless that is it.
  void start_on_site(std::size_t host) {
    std::vector<std::string> flags{"--interface", "wlan0", "--interval", "0.1", "--key-file", key_};
    if (host == 0) flags.insert(flags.end(), {"--interface", "lo", "--peer", "127.0.0.1:4720", "--relay"});
    lab_.start(host, flags);
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
  Lab lab_{hosts};
  std::unique_ptr<Process> server_;
  std::vector<std::unique_ptr<Process>> bridges_;
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

  link.lab().daemon(1).signal(SIGKILL);
  EXPECT_TRUE(consumer.line_with({"7 pub del", "reason=expired"})) << "the server keeps nobody alive";
  EXPECT_TRUE(link.lab().wait_for_participants(0, 2));
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

}  // namespace geminga::system

#endif
