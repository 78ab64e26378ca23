// The transcripts of matching (discovery/participant/transcripts), which the simulator plays, on real daemons. Time is
// not virtual here: the test waits for an expected line, and `@ wait` ends when all hosts know the statements of the
// others.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/small_ontology.hpp"
#include "support/lab.hpp"
#include "support/transcript_words.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

/// Numbers that no transcript uses.
constexpr std::uint32_t first_marker = 4'000'000'000;
/// A statement of one host can cause one of another, and that can cause one of the first.
constexpr int rounds_of_a_wait = 2;

class LiveTranscript {
 public:
  explicit LiveTranscript(std::string path) : path_(std::move(path)), lab_(count_hosts(path_) + 1) {}

  /// Plays the whole file; stops at the first line that fails.
  void play() {
    std::ifstream file(path_);
    std::string text;
    for (int number = 1; std::getline(file, text) && !testing::Test::HasFailure(); ++number) {
      at_ = path_ + ":" + std::to_string(number) + ": " + text;
      if (!text.empty() && !text.starts_with('#')) line(text);
    }
    if (testing::Test::HasFailure()) return;
    at_ = path_ + ": at the end";
    settle();
    for (const auto& [name, client] : clients_) {
      if (!client->lines.empty()) ADD_FAILURE() << at_ << ", to " << name << ": " << client->lines.front();
    }
  }

 private:
  struct Client {
    std::size_t host;
    Talk talk;
    std::deque<std::string> lines{};  ///< that came and were not expected so far
  };

  /// Hosts are called robot1, robot2 and so on.
  static std::size_t number_of(std::string_view host) { return std::stoul(std::string(host.substr(5))); }

  static std::size_t count_hosts(const std::string& path) {
    std::ifstream file(path);
    std::string text;
    std::size_t count = 0;
    while (std::getline(file, text)) count += text.starts_with("@ host ") ? 1 : 0;
    return count;
  }

  void line(std::string_view rest) {
    const std::string who = test::next_word(rest);
    if (who == "@") return direct(rest);
    const std::string sign = test::next_word(rest);
    rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
    ASSERT_TRUE(clients_.contains(who)) << at_;
    Client& client = *clients_.at(who);
    if (sign == "<") return expect(client, rest);
    const auto text = words_.substituted(rest);
    ASSERT_TRUE(text) << at_ << ": a name is not known yet";
    ASSERT_TRUE(client.talk.send(sign == ">>" ? test::unescaped(*text) : *text + "\r\n")) << at_;
    wait_for_answer(client);
  }

  void direct(std::string_view rest) {
    const std::string verb = test::next_word(rest);
    const std::string name = test::next_word(rest);
    const std::string third = test::next_word(rest);
    if (verb == "host") return;
    if (verb == "wait") return settle();
    if (verb == "connect") {
      clients_[name] = std::make_unique<Client>(number_of(third), lab_.talk(number_of(third)));
      return wait_for_answer(*clients_.at(name));
    }
    if (verb == "hang-up") {
      clients_.erase(name);
      return;
    }
    const std::size_t host = number_of(name);
    if (verb == "on") {
      std::vector<std::string> flags{"--interval", "1"};
      if (ontologies_.contains(host)) flags.insert(flags.end(), {"--ontology", ontologies_.at(host)});
      lab_.start(host, flags);
      on_.insert(host);
    } else if (verb == "crash") {
      lab_.daemon(host).signal(SIGKILL);
      on_.erase(host);
    } else {
      ASSERT_EQ(verb, "ontology") << at_ << ": this is not played on real daemons";
      load(host, third);
    }
  }

  /// Replaces the file instead of writing to it: a running daemon has it mapped.
  void load(std::size_t host, const std::string& ontology) {
    const auto bytes = sim::compiled_small_ontology(ontology);
    ASSERT_TRUE(bytes) << at_;
    const std::string path = folder_.path(std::to_string(host) + ".geminga");
    std::ofstream(path + ".new", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    std::filesystem::rename(path + ".new", path);
    ontologies_[host] = path;
    if (!on_.contains(host)) return;
    lab_.daemon(host).forget();
    lab_.daemon(host).signal(SIGHUP);
    ASSERT_TRUE(lab_.daemon(host).wait_for(" is in force")) << at_;
  }

  void expect(Client& client, std::string_view pattern) {
    if (client.lines.empty()) {
      auto came = client.talk.line();
      ASSERT_TRUE(came) << at_ << ": nothing came";
      client.lines.push_back(std::move(*came));
    }
    const std::string came = std::exchange(client.lines.front(), {});
    client.lines.pop_front();
    ASSERT_TRUE(words_.matches(in_lab(pattern), came)) << at_ << "\n  came: " << came;
  }

  /// The simulated hosts have the addresses 10.0.0.1, 10.0.0.2 and so on.
  [[nodiscard]] std::string in_lab(std::string_view pattern) const {
    constexpr std::string_view simulated = "10.0.0.";
    std::string text;
    for (std::size_t at = pattern.find(simulated); at != std::string_view::npos; at = pattern.find(simulated)) {
      text += pattern.substr(0, at);
      pattern.remove_prefix(at + simulated.size());
      text += lab_.address_of(std::stoul(std::string(pattern)));
      pattern.remove_prefix(std::min(pattern.find_first_not_of("0123456789"), pattern.size()));
    }
    return text.append(pattern);
  }

  /// Waits until the daemon has handled all statements of the client: it answers one that no transcript makes.
  void wait_for_answer(Client& client) {
    const std::string number = std::to_string(++marker_);
    ASSERT_TRUE(client.talk.send(number + " sub remove\r\n")) << at_;
    ASSERT_TRUE(take_until(client, number + " 404 ")) << at_;
  }

  /// Keeps all lines before the one with this beginning.
  [[nodiscard]] static bool take_until(Client& client, const std::string& begin) {
    while (auto came = client.talk.line()) {
      if (came->starts_with(begin)) return true;
      client.lines.push_back(std::move(*came));
    }
    return false;
  }

  /// One client of each host that has clients.
  [[nodiscard]] std::map<std::size_t, Client*> speakers() const {
    std::map<std::size_t, Client*> found;
    for (const auto& [name, client] : clients_) {
      if (on_.contains(client->host)) found.emplace(client->host, client.get());
    }
    return found;
  }

  /// Waits until each host knows the statements of the others. A host's statements come in their order, so it is enough
  /// that all hosts know the last service of each. Withdrawals of the last requests for it may come later, so a query
  /// for requests must name them.
  void settle() {
    for (int round = 0; round < rounds_of_a_wait && !testing::Test::HasFailure(); ++round) {
      const auto all = speakers();
      const std::string offer = std::to_string(++marker_);
      const std::string wish = std::to_string(++marker_);
      for (const auto& [host, client] : all) {
        client->talk.say(wish + " sub create mode=otm/stream text=marker-" + offer);
        client->talk.say(offer + " pub create mode=otm/stream port=9 text=marker-" + offer);
      }
      hear_of_all(all, wish + " pub add ");
      for (const auto& [host, client] : all) client->talk.say(offer + " pub remove");
      hear_of_all(all, wish + " pub del ");
      for (const auto& [host, client] : all) client->talk.say(wish + " sub remove");
      for (const auto& [name, client] : clients_) {
        if (on_.contains(client->host)) wait_for_answer(*client);
      }
    }
  }

  void hear_of_all(const std::map<std::size_t, Client*>& all, const std::string& begin) {
    for (const auto& [host, client] : all) {
      for (std::size_t heard = 0; heard < all.size(); ++heard)
        ASSERT_TRUE(take_until(*client, begin)) << at_ << ": " << lab_.way();
    }
  }

  std::string path_;
  std::string at_;  ///< "file:line", for failures
  Folder folder_;
  Lab lab_;
  std::map<std::size_t, std::string> ontologies_;
  std::set<std::size_t> on_;
  std::map<std::string, std::unique_ptr<Client>> clients_;
  test::BoundWords words_;
  std::uint32_t marker_ = first_marker;
};

class RealTranscripts : public testing::TestWithParam<const char*> {};

TEST_P(RealTranscripts, AreWhatDaemonsSay) {
  LiveTranscript(std::string(GEMINGA_SOURCE_DIR "/tests/discovery/participant/transcripts/") + GetParam() + ".txt")
      .play();
}

INSTANTIATE_TEST_SUITE_P(Gcnp, RealTranscripts,
                         testing::Values("arbitration", "attributes", "choices", "conversions", "converters",
                                         "expressions", "local_match", "overlapping", "preferences", "scopes",
                                         "signatures", "why", "why_if"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace geminga::system
